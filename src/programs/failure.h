// What commands throw; mimo::Exception is what the library does.
#pragma once

#include <stdexcept>
#include <string>

#include "programs/text.h"

namespace cli {

// A command cannot do what it was asked for; the text is the one line that the user gets.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& text) : std::runtime_error(one_line(text)) {}
};

}  // namespace cli
