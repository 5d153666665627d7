// The variables of a unit of FMI: actions as inputs, fields of the observation and results as outputs.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "programs/world.h"

namespace cli {

struct UnitOptions {
  WorldOptions world;
  std::string outputs = "proprioception,vestibular";  // senses and names of fields
  int version = 3;                                    // of FMI: 2 or 3
};

// The options by which a unit's world is made, for the command that writes it and for the unit, which reads them again.
void add_unit_options(CLI::App& command, UnitOptions& options);

// The world that they describe.
mimo::Env open_unit_world(const UnitOptions& options);

// A variable's number is its place in the list.
struct Variable {
  enum Kind { kTime, kSeed, kAction, kField, kPicture, kReward, kTerminated, kTruncated };

  Kind kind;
  std::string name, unit, description;
  std::int32_t dtype = MIMO_F64;
  std::vector<std::size_t> shape;  // of arrays, which FMI 3 has
  std::size_t place = 0;           // of an action, of a field's first byte, or of an agent
  std::size_t count = 1;
  double low, high;

  bool is_input() const { return kind == kAction; }
  bool is_output() const { return kind > kAction; }
  const char* type(int version) const;  // "Float64", "Real", ...
};

// Throws a Failure for outputs that the world has not. What FMI 2 has no type for, pictures, is left out there.
std::vector<Variable> variables_of(const mimo::Env& env, const UnitOptions& options);

}  // namespace cli
