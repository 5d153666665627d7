#include "cli/page.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <mimo/mimo.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"
#include "programs/this_program.h"
#include "rounding/rounding.h"

namespace fs = std::filesystem;

namespace cli {
namespace {

// ./dev web makes the page with this line in it, where the recording goes.
constexpr char kPlace[] = "<!-- recording -->";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;  // a text of a browser ends at half a gigabyte

// Beside the program as it is installed, built, or packed into a wheel.
std::string find_page() {
  const fs::path folder = folder_of_this_program();
  std::error_code unknown;
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
void require_playable(const std::string& file, const mimo::Recording& recording) {
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
}

// Plays the recording, and takes it up again where a page does: at the next kept state after steps that differed.
// Returns the first of these, or the number of all.
std::size_t play(mimo::Recording& recording, mimo::Env& env) {
  const std::size_t count = recording.info().steps;
  const std::vector<std::uint64_t> kept = recording.read<std::uint64_t>("states/step");
  const std::set<std::size_t> states(kept.begin(), kept.end());
  mimo::Block no_senses;
  mimo::Results results = env.make_results();
  std::size_t first = count;
  bool parted = false;
  Progress progress(count);
  for (std::size_t step = recording.seek(env, 0, 0); step < count; ++step) {
    if (parted && states.count(step) > 0) recording.seek(env, step, 0);
    recording.step(env, no_senses, results);
    parted = recording.report().identical == 0;
    if (parted) first = std::min(first, step);
    progress.show(step + 1);
  }
  return first;
}

// Where this system's C library rounds otherwise than the page's in the recorded run. Warns where this cannot be known
// for all of the run.
std::string rounding_in(const std::string& file, mimo::Recording& recording) {
  const RoundingNotes notes;
  mimo::Env env = recording.env();
  const mimo_recording_info info = recording.info();
  std::string why;
  try {
    const std::size_t first = play(recording, env);
    if (first < info.steps)
      why = text("it comes out otherwise on this system from %g s on",
                 info.step_seconds * static_cast<double>(first + 1));
  } catch (const mimo::Exception& error) {  // another model, steps along a movement, a world that fails
    why = error.what();
  }
  if (!why.empty()) {
    std::fprintf(stderr, "mimo: warning: the page may not find all of %s the same: %s\n", file.c_str(), why.c_str());
  }
  return notes.rows();
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

std::string inside(const std::string& id, const std::string& attributes, const std::string& bytes) {
  return "<script type=\"text/plain\" id=\"" + id + "\" " + attributes + ">" + base64(bytes) + "</script>";
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
  mimo::Recording played(recording);
  require_playable(recording, played);
  if (const std::uintmax_t size = fs::file_size(recording, missing); size > kMostBytes) {
    throw Failure(
        text("%s has %.0f MB, and a page takes at most %.0f: mimo replay with --from, --seconds and --out writes "
             "a piece of it",
             recording.c_str(), double(size) / 1048576, double(kMostBytes) / 1048576));
  }
  const std::string name = fs::path(recording).filename().string();
  page.replace(place, sizeof kPlace - 1,
               inside("recording", "data-name=\"" + escaped(name) + "\"", read_file(recording)) +
                   inside("rounding", "", rounding_in(recording, played)));
  write_file(options.out, page);
}

}  // namespace cli
