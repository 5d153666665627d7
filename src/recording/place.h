// Where a recording is written: no other program's file is touched, and the recording's name never shows an incomplete
// file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "recording/system.h"

namespace mimo::recording {

class Place {
 public:
  // Throws Status::kFile where something is there that is no recording, that somebody is using, or that is not to be
  // replaced.
  Place(const std::string& path, bool replace);
  ~Place();  // a file that was not settled goes
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  const std::string& path() const { return given_; }  // for messages
  const std::string& file() const { return file_; }   // that is to be made
  // Before it is made, as HDF5 can neither go on nor be rid of a new file for which there is no room.
  void require_room(std::size_t content) const;
  void made() { made_ = true; }
  // Other programs can read the file now: it gets its name. No other writer may open it from now on.
  void settle(int file);
  // Throws where somebody did nevertheless, or has taken its name away, since written() was called.
  void require_untouched(int file) const;
  void written(int file);

 private:
  void require_replaceable(bool replace) const;
  [[noreturn]] void fail_used() const;

  std::string given_, name_, file_;
  std::optional<Claim> replaced_;
  std::uint64_t bytes_ = 0;
  bool made_ = false, settled_ = false;
};

}  // namespace mimo::recording
