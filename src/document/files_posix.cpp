#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "base/fail.h"
#include "document/files.h"

namespace mimo::document {
namespace {

// Closes a file when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  return "not a plain file";
}

}  // namespace

std::optional<std::string> read_from_disk(const std::string& path, std::uint64_t most_bytes) {
  // Not to wait at a pipe until somebody writes.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat about {};
  if (file.number() < 0 || ::fstat(file.number(), &about) != 0) return std::nullopt;
  if (!S_ISREG(about.st_mode)) fail(Status::kModel, "file {} is {}", path, kind_of(about.st_mode));
  const auto size = static_cast<std::uint64_t>(about.st_size);
  if (size > most_bytes) fail_large(path, size, most_bytes);
  std::string content(static_cast<std::size_t>(size), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t got = ::read(file.number(), content.data() + done, content.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;  // shorter by now
    done += static_cast<std::size_t>(got);
  }
  content.resize(done);
  return content;
}

}  // namespace mimo::document
