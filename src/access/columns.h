// The columns of the table of quantities, and those ways of reading and writing that many quantities share.
#pragma once

#include <algorithm>

#include "access/quantities.h"
#include "engine/model.h"

namespace mimo::access {

// ---- Columns. A row has them in any order; what it does not say is as in `Quantity` ---------------------------------

struct In {
  const char* unit;
  const char* slide_unit = "";
};

struct Frame {
  const char* frame;
};

// Readers say how many values an element has, where the row itself does not.
struct Stored {
  const double* (*where)(const Element& one);
  int width = 0;
};

struct Computed {
  void (*how)(const Element& one, double* to);
  int width = 0;
};

using Check = void (*)(const env::World& world, int id, const double* values);

struct Written {
  Writing writing;
  void (*how)(env::World& world, int id, const double* values);
  Check check = nullptr;
};

struct AllWritten {
  Writing writing;
  void (*how)(env::World& world, const Ids& ids, Span<const double> values);
  Check check = nullptr;
};

struct Moves {};

constexpr void put(Quantity& row, int width) { row.width = width; }
constexpr void put(Quantity& row, decltype(Quantity::width_of) width) { row.width_of = width; }
constexpr void put(Quantity& row, Moment moment) { row.moment = moment; }
constexpr void put(Quantity& row, Frame frame) { row.frame = frame.frame; }
constexpr void put(Quantity& row, Moves /*it does*/) { row.moves = true; }

constexpr void put(Quantity& row, In in) {
  row.unit = in.unit;
  row.slide_unit = in.slide_unit;
}

constexpr void put(Quantity& row, Spatial spatial) {
  row.frame = "world";
  row.spatial = spatial;
}

constexpr void put(Quantity& row, Stored stored) {
  row.stored = stored.where;
  if (row.width == 0) row.width = stored.width;
}

constexpr void put(Quantity& row, Computed computed) {
  row.compute = computed.how;
  if (row.width == 0) row.width = computed.width;
}

constexpr void put(Quantity& row, Written written) {
  row.writing = written.writing;
  row.write = written.how;
  row.check = written.check;
}

constexpr void put(Quantity& row, AllWritten written) {
  row.writing = written.writing;
  row.write_all = written.how;
  row.check = written.check;
}

template <typename... Columns>
constexpr Quantity row(mimo_quantity number, const char* constant, Columns... columns) {
  Quantity made{constant, number};
  (put(made, columns), ...);
  return made;
}

// ---- Ways of reading ------------------------------------------------------------------------------------------------

template <typename T>
T* array_of(const Element& one, T* mjData::*array) {
  return one.data.*array;
}
template <typename T>
T* array_of(const Element& one, T* mjModel::*array) {
  return one.model.*array;
}

// So many numbers of an array of MuJoCo's for each element.
template <auto array, int count>
constexpr Stored kStored{[](const Element& one) -> const double* { return array_of(one, array) + count * one.id; },
                         count};

// Of each element from where another array says.
template <auto array, auto addresses>
constexpr Stored kStoredAt{
    [](const Element& one) -> const double* { return array_of(one, array) + array_of(one, addresses)[one.id]; }};

// Of single precision.
template <auto array, int count>
constexpr Computed kFloats{
    [](const Element& one, double* to) { std::copy_n(array_of(one, array) + count * one.id, count, to); }, count};

template <auto matrices>
constexpr Computed kOrientationOf{[](const Element& one, double* to) {
                                    const auto quaternion = engine::quaternion(array_of(one, matrices) + 9 * one.id);
                                    std::copy_n(quaternion.data(), 4, to);
                                  },
                                  4};

template <auto positions, auto matrices>
constexpr Computed kPoseOf{[](const Element& one, double* to) {
                             kOrientationOf<matrices>.how(one,
                                                          std::copy_n(array_of(one, positions) + 3 * one.id, 3, to));
                           },
                           7};

// Numbers that lie behind each other, whatever their type.
inline void copy(double number, double* to) { *to = number; }
template <typename List>
void copy(const List& list, double* to) {
  std::copy_n(list.data(), list.size(), to);
}

template <auto member>
constexpr Computed kOfStepContact{[](const Element& one, double* to) {
  const Span<const env::StepContact> all = one.world->step_contacts().all();
  copy(all[static_cast<std::size_t>(one.id)].*member, to);
}};

// ---- Ways of writing ------------------------------------------------------------------------------------------------

// Numbers of an array of MuJoCo's for each element.
template <auto array, int count>
void write_stored(env::World& world, int id, const double* values) {
  std::copy_n(values, count, world.physics().data().*array + count * id);
}

// Of a joint's axes.
template <auto array>
void write_axes(env::World& world, int joint, const double* values) {
  const mjModel& model = world.model();
  std::copy_n(values, engine::velocity_count(model.jnt_type[joint]),
              world.physics().data().*array + model.jnt_dofadr[joint]);
}

// What a world has of its own in the model, by the function of its physics that tells where it is.
template <auto where, int count>
void write_own(env::World& world, int id, const double* values) {
  auto* to = (world.physics().*where)(id);
  std::transform(values, values + count, to, [](double value) { return static_cast<decltype(*to + 0)>(value); });
}

}  // namespace mimo::access
