// The rows of a recording's tables: bodies, joints, results of steps, and how far two rows are apart.
#pragma once

#include <string>
#include <vector>

#include "access/access.h"
#include "base/span.h"
#include "blueprint/aging_world.h"
#include "env/world.h"
#include "observation/field.h"

namespace mimo::recording {

// What the infants of a world were asked to be, as a row of numbers in a recording.

using blueprint::Growths;

Growths growths_of(const env::World& world);

// Numbers of one row, and what they are, a line each.
std::vector<double> row_of(const Growths& growths);
std::string names_of_row(const env::World& world);
// Throws for numbers that no infant can have been asked to be.
Growths growths_of_row(const std::vector<double>& row);

// The joints of a world, as recordings name and number them.

std::string joint_names(const env::World& world);  // a line each
// A line for each column: a free joint has seven positions and six velocities.
std::string joint_columns(const env::World& world, mimo_quantity quantity);
// Of all joints.
void read_joints(const env::World& world, mimo_quantity quantity, std::vector<double>& values);

// What a step gave beside the observation, in room of its own.

struct StepResults {
  std::vector<double> reward, terms;
  std::vector<std::uint8_t> terminated, truncated;
  std::vector<std::int32_t> outcome;

  // Of the world's last step.
  void take(const env::World& world) {
    const std::size_t agents = world.agents().size();
    reward.resize(agents);
    terminated.resize(agents);
    truncated.resize(agents);
    outcome.resize(agents);
    terms.resize(world.term_count());
    world.report({reward, terminated, truncated, outcome, terms});
  }
};

// How far two rows of numbers are apart.

// Of any number, 0 where all are the same to the last bit; numbers that are not finite count as the largest double.
double largest_difference(observation::Type type, Span<const std::uint8_t> one, Span<const std::uint8_t> other);

// Which library recorded.

// The versions, and a fingerprint of the file that the library was loaded from: two builds of one version are two.
std::string build_name(const std::string& versions);

// Of numbers in states, which are kept as they lie in memory: "little" or "big".
const char* byte_order();

}  // namespace mimo::recording
