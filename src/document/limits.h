// How much a document may ask for, before MuJoCo sees it: its compiler believes sizes, and no other world can be made
// while it works. mimo.h has these under the same names with "max_" before them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace mimo::document {

// Contents by the names that a document gives them.
using Files = std::map<std::string, std::string>;

struct Limits {
  std::uint64_t file_bytes = 256ull << 20;  // of each file that is read
  std::uint64_t pixels = 64ull << 20;       // of a texture, or of a height field
  std::uint64_t vertices = 1'000'000;       // of a mesh or skin; as many faces
  std::uint64_t elements = 40'000;          // of the document, and those that composites become
  std::uint64_t keyframes = 10'000;         // of a document
  std::uint64_t iterations = 10'000;        // of each solver
  std::uint64_t world_bytes = 4ull << 30;   // what a world and its model may need, estimated
  std::uint64_t compile_ms = 10'000;        // that the compiler may work, estimated
  bool confined = false;                    // files lie in the folder of the document that names them, or below
  std::shared_ptr<const Files> files{};     // all that a document may refer to besides built-in files; null: the disk
};

}  // namespace mimo::document
