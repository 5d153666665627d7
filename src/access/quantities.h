// What named access reads and writes: one row of a table for each quantity of the header, which says all about it.
#pragma once

#include <cstdint>

#include "access/kinds.h"
#include "base/span.h"

namespace mimo::access {

// Where values are read: a world's data, or somebody else's, of which nothing more is known.
struct Source {
  const mjModel& model;
  const mjData& data;
  const env::World* world;  // null: somebody else's
};

struct Element : Source {
  int id;
};

// Elements of a quantity's kind: some, by their ids, or the first so many, which are all.
class Ids {
 public:
  explicit Ids(Span<const std::int32_t> some) : some_(some), size_(some.size()) {}
  explicit Ids(int all) : size_(static_cast<std::size_t>(all)) {}

  std::size_t size() const { return size_; }
  int operator[](std::size_t i) const { return some_.data() != nullptr ? some_.data()[i] : static_cast<int>(i); }

 private:
  Span<const std::int32_t> some_;
  std::size_t size_;
};

// When a quantity is true.
enum class Moment {
  kAlways,  // it is not computed
  kPose,    // it follows from positions and velocities: as the last physics step had them, or of now
  kStep,    // physics steps compute it
};

// What it is in space, so that it can be seen from another frame than the world's.
enum class Spatial { kNone, kPosition, kOrientation, kPose, kVelocity };

// Whether a quantity can be written, and where to.
enum class Writing {
  kNever,
  kState,  // of the world, which has none when it has failed
  kWorld,  // outlives resets
};

struct Quantity {
  const char* constant;  // "MIMO_JOINT_POSITION"
  mimo_quantity number;  // of its kind, times 256, and a place in it
  int width = 0;         // of each element; 0: it depends on the element
  // Then; the world is null where there is only a model, which has no agents.
  int (*width_of)(const mjModel& model, const env::World* world, int id) = nullptr;

  const char* unit = "";        // of all values; "" where they differ
  const char* slide_unit = "";  // of joints that slide; `unit` is that of hinges
  const char* frame = "";       // in which values are; "": as its kind says
  Spatial spatial = Spatial::kNone;

  Moment moment = Moment::kAlways;
  const double* (*stored)(const Element& one) = nullptr;      // where its numbers lie; null: they are computed
  void (*compute)(const Element& one, double* to) = nullptr;  // then

  Writing writing = Writing::kNever;
  bool moves = false;  // poses follow from it
  // Throws for values that cannot be written; null: all can.
  void (*check)(const env::World& world, int id, const double* values) = nullptr;
  // Values are checked; quaternions and directions are of any length but 0.
  void (*write)(env::World& world, int id, const double* values) = nullptr;
  // In place of `write`, where all at once costs less.
  void (*write_all)(env::World& world, const Ids& ids, Span<const double> values) = nullptr;

  const Kind& kind() const { return kind_of(number >> 8); }
};
constexpr int kWidest = 9;  // of those with a width of their own

const Quantity* find_quantity(mimo_quantity number);  // null: there is none of that number
const Quantity& quantity_of(mimo_quantity number);

// How many values one element has.
inline int width(const Quantity& quantity, const mjModel& model, const env::World* world, int id) {
  return quantity.width > 0 ? quantity.width : quantity.width_of(model, world, id);
}
// The same of all ids together. Throws for ids out of range.
std::size_t width(const env::World& world, const Quantity& quantity, const Ids& ids);

}  // namespace mimo::access
