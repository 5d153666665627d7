// How much a document may ask for, what it has, and what it costs in memory and time, before MuJoCo's compiler sees it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mimo::document {

// How much a document may ask for, before MuJoCo sees it: its compiler believes sizes, and no other world can be made
// while it works. mimo.h has these under the same names with "max_" before them.

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

// What a document costs, estimated before MuJoCo's compiler sees it: bytes, which it counts in ints, and its time, in
// which no other thread in the process can create a world.

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

// How many of everything a document has, and what that makes of a model's bytes and of a world's buffers.

// How many bodies a composite, or another element with a count, becomes.
double made_by(pugi::xml_node element);

class Counts {
 public:
  explicit Counts(const Limits& limits) : limits_(limits) {}

  void add(pugi::xml_node node);

  // Both throw Status::kModel for more than the limits allow, and add to the budget; the second, of a world's buffers,
  // once the budget knows the whole model.
  void check(pugi::xml_node root, Budget& budget) const;
  void check_world(pugi::xml_node root, Budget& budget) const;

 private:
  double size(const char* name, double otherwise) const;
  double model_bytes() const;
  double key_bytes() const;
  double lengths_seconds(pugi::xml_node root) const;
  void add_made(pugi::xml_node node, double made);
  void add_degrees(pugi::xml_node node, double copies);

  const Limits& limits_;
  double elements_ = 0, degrees_ = 0, chains_ = 0, keyframes_ = 0, actuators_ = 0, tendons_ = 0, mocaps_ = 0;
  double text_bytes_ = 0, name_bytes_ = 0, longest_user_ = 0, numeric_ = 0, sensed_ = 0;
  bool dense_ = false;
  std::vector<pugi::xml_node> sizes_, moved_;
  pugi::xml_node most_at_, last_key_, lengths_;
};

// What a document's author may leave open: how much memory the simulation gets, and how near things are drawn.

// Room for contacts, constraints and the solver, where there are infants. What the document's author has decided stays
// where it is enough for them.
void size_buffers(pugi::xml_node root, int mittens, int fingers, int objects);

// Nothing nearer than znear * extent is drawn. MuJoCo's own choice, a hundredth of the size of all that there is, would
// hide an infant's hands from its eyes. Where the author has set both, it is so; else they become 5 mm and, for want of
// any other, 100 m.
void keep_hands_in_sight(pugi::xml_node root);

}  // namespace mimo::document
