// How old the infants of a world are.
#pragma once

#include <CLI/CLI.hpp>
#include <mimo/mimo.hpp>
#include <optional>
#include <string>

namespace cli {

struct AgeOptions {
  std::optional<double> age, physiological_age;  // months
  std::string sex = "mean";
  std::string growth = "who";
  double percentile = 0;
  double z_length = 0, z_weight = 0, z_head = 0;
  bool eyes = false, delays = false;  // are as old, where an age is given
};

void add_age_options(CLI::App& command, AgeOptions& options);
// Whether eyes and nerves are as old as the infant; by themselves they are.
void add_maturity_options(CLI::App& command, AgeOptions& options);

// What was asked for; nothing where that is nothing.
std::optional<mimo_growth> growth_of(const AgeOptions& options);

}  // namespace cli
