#include "recording/place.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/fail.h"
#include "base/new_file.h"
#include "recording/file.h"

namespace fs = std::filesystem;

namespace mimo::recording {
namespace {

constexpr std::size_t kRoom = 256 * 1024;  // of a file before its first step, and more

}  // namespace

// A host may change its working directory.
Place::Place(const std::string& path, bool replace) : given_(path), name_(fs::absolute(fs::u8path(path)).u8string()) {
  std::error_code unknown;
  const fs::file_status there = fs::status(fs::u8path(name_), unknown);
  if (fs::exists(there)) {
    if (!fs::is_regular_file(there)) {
      fail(Status::kFile, "cannot write {}: it is {}", path, fs::is_directory(there) ? "a folder" : "not a plain file");
    }
    name_ = fs::canonical(fs::u8path(name_)).u8string();  // what a link leads to
    require_replaceable(replace);
    replaced_.emplace(name_);
    if (!replaced_->granted()) fail_used();
  }
  file_ = kNamesOpenFiles ? beside(fs::u8path(name_), ".h5").u8string() : name_;
  if (!kNamesOpenFiles && replaced_) {
    replaced_.reset();
    fs::remove(fs::u8path(name_), unknown);
  }
}

Place::~Place() {
  std::error_code ignored;
  if (made_ && !settled_) fs::remove(fs::u8path(file_), ignored);
}

// An empty file is what makers of temporary names leave.
void Place::require_replaceable(bool replace) const {
  if (!Claim(name_).granted()) fail_used();
  std::error_code unknown;
  if (fs::file_size(fs::u8path(name_), unknown) == 0) return;
  try {
    const Reader recording(name_);
  } catch (const Error& error) {
    if (error.status() == Status::kOutOfMemory) throw;
    fail(Status::kFile, "cannot write {}: a file exists that is not a complete recording; it is not overwritten",
         given_);
  }
  if (!replace)
    fail(Status::kFile, "cannot write {}: a recording exists already and is replaced only if `replace` is set", given_);
}

void Place::fail_used() const {
  fail(Status::kFile, "cannot write {}: the existing file is write-protected, or a program is using it", given_);
}

void Place::require_room(std::size_t content) const {
  const fs::path path = fs::u8path(file_);
  std::ofstream file(path, std::ios::binary);
  file << std::string(kRoom + content, '\0');
  file.close();
  const std::string why = file ? "" : std::generic_category().message(errno);
  std::error_code ignored;
  fs::remove(path, ignored);
  if (!file) fail(Status::kFile, "cannot write {}: {}; check the free space and the permissions", given_, why);
}

void Place::settle(int file) {
  claim_for_writing(file);
  if (file_ != name_) {
    const std::string trouble = name_file(file_, name_, replaced_.has_value());
    if (!trouble.empty()) fail(Status::kFile, "cannot write {}: {}", given_, trouble);
  }
  settled_ = true;
  replaced_.reset();
}

void Place::require_untouched(int file) const {
  if (settled_ && !stands(file, name_, bytes_)) {
    fail(Status::kFile, "cannot write {}: another program has moved, removed, replaced or truncated it", given_);
  }
}

void Place::written(int file) { bytes_ = size_of(file); }

}  // namespace mimo::recording
