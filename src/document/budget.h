// What a document costs, estimated before MuJoCo's compiler sees it: bytes, which it counts in ints, and its time, in
// which nobody else in the process can make a world.
#pragma once

#include <pugixml.hpp>

#include "document/limits.h"

namespace mimo::document {

class Budget {
 public:
  explicit Budget(const Limits& limits) : limits_(limits) {}

  // Both add what an element costs, and throw Status::kModel with its place where that is more than there may be.
  void add_time(pugi::xml_node node, double seconds);
  void add_bytes(pugi::xml_node node, double bytes);  // of the model

  double seconds() const { return seconds_; }
  double bytes() const { return bytes_; }

 private:
  const Limits& limits_;
  double seconds_ = 0, bytes_ = 0;
};

// What parts cost, in seconds of one core of a processor of 2022; the tests of documents that take long compare.
namespace cost {

inline constexpr double kPixel = 20e-9;      // of a texture; reading, copying
inline constexpr double kHeight = 10e-9;     // a point of a height field
inline constexpr double kTextByte = 30e-9;   // of attributes, and of meshes' files
inline constexpr double kByte = 0.15e-9;     // of the buffers of a world, which are filled with zeros
inline constexpr double kElements = 2e-9;    // of two elements: each is compared with each
inline constexpr double kDegrees = 1e-8;     // of two degrees of freedom
inline constexpr double kDense = 1e-10;      // of three, where matrices are dense
inline constexpr double kHullCorner = 5e-6;  // a corner of a convex hull
inline constexpr double kHullPair = 1.2e-9;  // of two of these: each edge is looked up in a list of corners
inline constexpr double kPolygon = 5e-9;     // of two corners of one face of more than four

}  // namespace cost

}  // namespace mimo::document
