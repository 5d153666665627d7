// Where the C library's sin, exp and the like give another result than base/functions.h, in what MuJoCo computes.
#pragma once

#include <string>

namespace cli {

// Notes it as long as it lives; there is one at a time. A program that this room is linked into has the functions
// itself and passes them on to the C library, as on Linux the libraries of a process take a program's functions first.
// Other systems do not, and nothing is noted.
class RoundingNotes {
 public:
  RoundingNotes();
  ~RoundingNotes();
  RoundingNotes(const RoundingNotes&) = delete;
  RoundingNotes& operator=(const RoundingNotes&) = delete;

  // Each call once, in a fixed order: four numbers of 8 bytes, mimo::Substitute, both arguments (the second is 0 where
  // there is none) and the result.
  std::string rows() const;
};

}  // namespace cli
