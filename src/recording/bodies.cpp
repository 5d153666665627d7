#include "recording/bodies.h"

#include "base/fail.h"

namespace mimo::recording {
namespace {

// Visits all members with their names, in the order of a row.
template <typename Growth, typename Visit>
void for_each_member(Growth& growth, Visit&& visit) {
  visit("age", growth.age);
  visit("physiological_age", growth.physiological_age);
  visit("sex", growth.sex);
  visit("model", growth.model);
  visit("z_length", growth.z_length);
  visit("z_weight", growth.z_weight);
  visit("z_head", growth.z_head);
  visit("absolute", growth.absolute);
  visit("strength_exponent", growth.strength_exponent);
  visit("neck_strength", growth.neck_strength);
  visit("birth_tone", growth.birth_tone);
  visit("contracture", growth.contracture);
  visit("keep_spacing", growth.keep_spacing);
  visit("body", growth.body);
  visit("eyes", growth.eyes);
  visit("delays", growth.delays);
  visit("threshold", growth.threshold);
  visit("flicker", growth.flicker);
}

void take(double number, double& member) { member = number; }
void take(double number, bool& member) { member = number != 0; }
void take(double number, growth::Sex& member) {
  require(number >= 0 && number <= 2, "sex is {}, expected 0, 1 or 2", number);
  member = static_cast<growth::Sex>(static_cast<int>(number));
}
void take(double number, growth::Model& member) {
  require(number >= 0 && number <= 1, "model is {}, expected 0 or 1", number);
  member = static_cast<growth::Model>(static_cast<int>(number));
}

}  // namespace

Growths growths_of(const env::World& world) {
  Growths growths;
  for (const env::Agent& agent : world.agents()) growths.push_back(agent.growth);
  return growths;
}

std::size_t growth_numbers() {
  std::size_t count = 0;
  const growth::Growth any;
  for_each_member(any, [&](const char*, const auto&) { ++count; });
  return count;
}

std::vector<double> row_of(const Growths& growths) {
  std::vector<double> row;
  for (const growth::Growth& growth : growths) {
    for_each_member(growth, [&](const char*, const auto& member) { row.push_back(static_cast<double>(member)); });
  }
  return row;
}

std::string names_of_row(const env::World& world) {
  std::string names;
  for (const env::Agent& agent : world.agents()) {
    const std::string prefix = agent.name.empty() ? "" : agent.name + "/";
    for_each_member(agent.growth, [&](const char* name, const auto&) { names += prefix + name + "\n"; });
  }
  return names;
}

Growths growths_of_row(const std::vector<double>& row) {
  const std::size_t numbers = growth_numbers();
  require(row.size() % numbers == 0, "a row has {} numbers, expected {} for each agent", row.size(), numbers);
  Growths growths(row.size() / numbers);
  const double* next = row.data();
  for (growth::Growth& growth : growths) {
    for_each_member(growth, [&](const char*, auto& member) { take(*next++, member); });
    growth::check(growth);
  }
  return growths;
}

}  // namespace mimo::recording
