// modelDescription.xml of a unit of FMI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fmi/variables.h"

namespace cli {

struct UnitFacts {
  std::string name, task, token;
  double step;  // s
  std::uint64_t seed;
};

// Of the library in it. Not "mimo": Windows would take it for libmimo, which has that name there.
constexpr char kUnitIdentifier[] = "mimo_unit";

std::string model_description(const UnitFacts& facts, const std::vector<Variable>& variables, int version);

}  // namespace cli
