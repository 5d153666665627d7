#include "cli/page.h"

#include <cstdint>
#include <filesystem>
#include <mimo/mimo.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace fs = std::filesystem;

namespace cli {
namespace {

// ./dev web makes the page with this line in it, where the recording goes.
constexpr char kPlace[] = "<!-- recording -->";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;  // a text of a browser ends at half a gigabyte

// Beside the program as it is installed, built, or packed into a wheel.
std::string find_page() {
  std::error_code unknown;
  const fs::path folder = fs::canonical("/proc/self/exe", unknown).parent_path();
  for (const char* place : {"../share/mimo/web/recording.html", "../web/recording.html", "recording.html"}) {
    if (const fs::path file = folder / place; !folder.empty() && fs::is_regular_file(file, unknown)) {
      return file.lexically_normal().string();
    }
  }
  throw Failure(
      "--html: the page that plays recordings is not beside this program; ./dev build --web and ./dev web make it, and "
      "--page names it");
}

// What a page cannot play is said before it is written.
void require_playable(const std::string& file) {
  const mimo::Recording recording(file);
  const mimo_recording_info info = recording.info();
  if (info.format_version < 3) {
    throw Failure(file + " has format version " + std::to_string(info.format_version) +
                  ", which contains no scene; mimo replay with --scene and --out writes one that does");
  }
  const std::vector<std::uint8_t> world = recording.read<std::uint8_t>("world");
  const auto calls = nlohmann::json::parse(world.begin(), world.end(), nullptr, false);
  for (const auto& call : calls) {
    if (call.is_object() && call.value("call", "") == "add_sense") {
      throw Failure(file + " has a sense of its own, '" + call.value("sense", "") +
                    "', whose library a browser cannot load");
    }
  }
  static_cast<void>(recording.env());
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string digits;
  digits.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = at; i < at + 3; ++i) three = three << 8 | (i < bytes.size() ? std::uint8_t(bytes[i]) : 0U);
    for (unsigned shift = 24; shift > 0; shift -= 6) digits += kDigits[three >> (shift - 6) & 63];
  }
  for (std::size_t i = bytes.size() % 3; i % 3 != 0; ++i) digits[digits.size() - (3 - i)] = '=';
  return digits;
}

// As a text within quotes.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char letter : name) {
    if (letter == '&' || letter == '<' || letter == '"') {
      text += "&#" + std::to_string(int(letter)) + ';';
    } else {
      text += letter;
    }
  }
  return text;
}

}  // namespace

void write_page(const PageOptions& options, const std::string& recording) {
  require_writable(options.out);
  std::error_code missing;
  if (fs::equivalent(options.out, recording, missing)) throw Failure("--html is the recording itself");
  const std::string from = options.without.empty() ? find_page() : options.without;
  std::string page = read_file(from);
  const std::size_t place = page.find(kPlace);
  if (place == std::string::npos) throw Failure(from + " is not the page that ./dev web makes for recordings");
  require_playable(recording);
  if (const std::uintmax_t size = fs::file_size(recording, missing); size > kMostBytes) {
    throw Failure(
        text("%s has %.0f MB, and a page takes at most %.0f: mimo replay with --from, --seconds and --out writes "
             "a piece of it",
             recording.c_str(), double(size) / 1048576, double(kMostBytes) / 1048576));
  }
  const std::string name = fs::path(recording).filename().string();
  page.replace(place, sizeof kPlace - 1,
               "<script type=\"text/plain\" id=\"recording\" data-name=\"" + escaped(name) + "\">" +
                   base64(read_file(recording)) + "</script>");
  write_file(options.out, page);
}

}  // namespace cli
