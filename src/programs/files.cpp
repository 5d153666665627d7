#include "programs/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <random>

#include "programs/program.h"
#include "programs/text.h"

namespace fs = std::filesystem;

namespace cli {
namespace {

// A pipe without a name has both ends, as bash's <(...) and >(...) do; one with a name waits for the other.
bool is_open_pipe(const fs::path& path) {
  std::error_code unnamed;
  static_cast<void>(fs::canonical(path, unnamed));
  return fs::is_fifo(path) && unnamed;
}

// What has no content of its own to keep, and needs no name.
bool is_stream(const fs::path& path) {
  std::error_code unknown;
  return fs::is_character_file(path, unknown) || (fs::is_fifo(path, unknown) && is_open_pipe(path));
}

[[noreturn]] void fail_to_write(const std::string& path) {
  throw Failure("cannot write " + path + ": " + std::strerror(errno));
}

bool put(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return static_cast<bool>(file);
}

// Of what a link leads to, in the same folder.
fs::path beside(const fs::path& path) {
  std::random_device random;
  return path.parent_path() / text(".mimo-%08x%08x", random(), random());
}

}  // namespace

bool has_ending(const std::string& path, const std::string& ending) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return path.size() > ending.size() &&
         std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [&](char wanted, char there) { return same(there, wanted); });
}

void require_writable(const std::string& path) {
  const fs::path file(path), folder = file.parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {
    throw Failure("cannot write " + path + ": there is no folder " + folder.string());
  }
  if (fs::is_directory(file)) throw Failure("cannot write " + path + ": it is a folder");
  if (fs::is_fifo(file) && !is_open_pipe(file)) throw Failure("cannot write " + path + ": it is a named pipe");
  if (fs::exists(file) && !fs::is_regular_file(file) && !is_stream(file)) {
    throw Failure("cannot write " + path + ": it is not a plain file");
  }
}

void write_file(const std::string& path, std::string_view bytes) {
  require_writable(path);
  std::error_code missing;
  const fs::path linked = fs::canonical(path, missing), file = missing ? fs::path(path) : linked;
  if (is_stream(path)) {
    if (!put(path, bytes)) fail_to_write(path);
    return;
  }
  // Whether it may be written is asked of the file that is there, not of its folder.
  if (!missing && !std::ofstream(file, std::ios::binary | std::ios::app)) fail_to_write(path);
  const fs::path whole = beside(file);
  std::error_code error;
  if (!put(whole, bytes)) {
    const int why = errno;
    fs::remove(whole, error);
    errno = why;
    fail_to_write(path);
  }
  if (!missing) fs::permissions(whole, fs::status(file).permissions(), error);
  fs::rename(whole, file, error);
  if (!error) return;
  fs::remove(whole, missing);
  throw Failure("cannot write " + path + ": " + error.message());
}

void make_folder(const std::string& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error)) {
    throw Failure("cannot make the folder " + path + ": a file is there");
  }
  fs::create_directories(path, error);
  if (error) throw Failure("cannot make the folder " + path + ": " + error.message());
}

std::ifstream open_to_read(const std::string& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::is_directory(status)) throw Failure("cannot read " + path + ": it is a folder");
  if (fs::is_fifo(status) && !is_open_pipe(path)) throw Failure("cannot read " + path + ": it is a named pipe");
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_fifo(status)) {
    throw Failure("cannot read " + path + ": it is not a plain file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Failure("cannot read " + path + ": " + std::strerror(errno));
  return file;
}

std::string read_file(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw Failure("cannot read " + path);
  return bytes;
}

std::function<std::string(const std::string&)> ends_in(const std::vector<std::string>& endings) {
  return [endings](const std::string& path) -> std::string {
    std::string expected;
    for (const std::string& ending : endings) {
      if (has_ending(path, ending)) return "";
      expected += (expected.empty() ? "" : " or ") + ending;
    }
    return "expected a name that ends in " + expected + ", not '" + path + "'";
  };
}

}  // namespace cli
