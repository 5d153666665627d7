// Kinds of what named access reaches, one row of a table each: elements of the model, and what only a world has.
#pragma once

#include <string>

#include "env/world.h"
#include "mimo/access.h"

namespace mimo::access {

struct Kind {
  mimo_kind number;
  const char* constant;                                  // "MIMO_STEP_CONTACT"
  int (*count)(const env::World& world);                 // throws where the world does not record them
  const char* (*name)(const env::World& world, int id);  // "" for what has none
  const char* frame = "";                                // in which its quantities are that are not in space
  int (*body)(const mjModel& model, int id) = nullptr;   // that it belongs to, of a body its parent; null: to none

  // Whether other worlds of the same model have as many.
  constexpr bool alike() const { return number != MIMO_CONTACT && number != MIMO_STEP_CONTACT; }
  constexpr bool in_model() const { return number <= MIMO_LIGHT; }
};

// Whether a table has a row for each of the header's numbers, in their order, with the constant's name.
template <typename Row, std::size_t rows, typename Number, std::size_t numbers>
constexpr bool are_rows_of(const Row (&table)[rows], const Number (&header)[numbers]) {
  bool same = rows == numbers;
  for (std::size_t i = 0; same && i < rows; ++i) same = table[i].number == header[i] && table[i].constant[0] == 'M';
  return same;
}

const Kind* find_kind(mimo_kind number);  // null: there is none of that number
int count_kinds();                        // their numbers are 1, 2, ...
const Kind& kind_of(mimo_kind number);
std::string words(const char* constant);  // "step contact" of "MIMO_STEP_CONTACT"

// Throws Status::kNotFound with some of the names that are there.
int find_or_fail(const env::World& world, const Kind& kind, const std::string& name);
// The same where there may be no world, but only a model: throws Status::kUnsupported for what only worlds have. The
// name "" is that of an agent without one.
int find_or_fail(const mjModel& model, const env::World* world, const Kind& kind, const std::string& name);

// The body that an element belongs to; of a body its parent. Throws Status::kInvalidArgument for other kinds.
int body_of(const env::World& world, const Kind& kind, int id);

}  // namespace mimo::access
