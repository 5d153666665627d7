// What commands throw; mimo::Exception is what the library does.
#pragma once

#include <stdexcept>

namespace cli {

// A command cannot do what it was asked for; the text is the one line that the user gets.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cli
