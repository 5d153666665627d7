#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "base/new_file.h"
#include "recording/system.h"
#if defined(__linux__)
#include <sys/auxv.h>
#endif

extern "C" char** environ;  // NOLINT(readability-redundant-declaration): not in every unistd.h

namespace mimo::recording {
namespace {

// A file system that knows no locks has none to respect.
bool lock(int file, int how) { return flock(file, how | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

bool same_file(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

}  // namespace

void* open_library(const char* name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void close_library(void* library) { dlclose(library); }

void* symbol_of(void* library, const char* name) { return dlsym(library, name); }

std::string why_not_opened() {
  const char* const reason = dlerror();
  return reason == nullptr ? "" : reason;
}

std::string path_of_this_library() {
  Dl_info info = {};
  return dladdr(reinterpret_cast<const void*>(&path_of_this_library), &info) == 0 ? "" : info.dli_fname;
}

bool has_elevated_rights() {
#if defined(__linux__)
  return getauxval(AT_SECURE) != 0;
#else
  return issetugid() != 0;
#endif
}

bool environment_has(const std::string& beginning) {
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    if (std::strncmp(*variable, beginning.c_str(), beginning.size()) == 0) return true;
  }
  return false;
}

void write_to_nowhere(int file) {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, file);
  close(nowhere);
}

// HDF5 locks files in the same way: alone while it makes one, together while it reads.
Claim::Claim(const std::string& path) : file_(open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
  const int file = static_cast<int>(file_);
  struct stat opened {
  }, named{};
  granted_ = file >= 0 && lock(file, LOCK_EX) && fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
             same_file(opened, named);  // else another one has taken its name before it was locked
}

Claim::~Claim() {
  if (file_ >= 0) close(static_cast<int>(file_));
}

void claim_for_writing(int file) { lock(file, LOCK_SH); }

void end_claim(int file) { flock(file, LOCK_UN); }

bool stands(int file, const std::string& path, std::uint64_t bytes) {
  struct stat opened {
  }, named{};
  if (fstat(file, &opened) != 0) return true;
  if (stat(path.c_str(), &named) != 0) return errno != ENOENT;  // a host may give up its right to look
  return same_file(opened, named) && static_cast<std::uint64_t>(opened.st_size) >= bytes;
}

std::uint64_t size_of(int file) {
  struct stat about {};
  return fstat(file, &about) == 0 ? static_cast<std::uint64_t>(about.st_size) : 0;
}

const bool kNamesOpenFiles = true;

std::string name_file(const std::string& file, const std::string& name, bool replace) {
  if (!replace) {
    const std::error_code error = move_to_free(file, name);
    return error ? error.message() : "";
  }
  return std::rename(file.c_str(), name.c_str()) == 0 ? "" : std::generic_category().message(errno);
}

}  // namespace mimo::recording
