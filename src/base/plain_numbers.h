// Numbers in texts have a decimal point, whatever the host's locale says.
#pragma once

#include <memory>

namespace mimo {

// While this lives, C functions on this thread have the locale "C", also those that MuJoCo calls. Other threads keep
// theirs.
class PlainNumbers {
 public:
  PlainNumbers();
  ~PlainNumbers();
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  struct Locale;
  std::unique_ptr<Locale> before_;
};

}  // namespace mimo
