#include "recording/bodies.h"

#include "base/fail.h"

namespace mimo::recording {
namespace {

constexpr const char* kNames[] = {"age",
                                  "physiological_age",
                                  "sex",
                                  "model",
                                  "z_length",
                                  "z_weight",
                                  "z_head",
                                  "absolute",
                                  "strength_exponent",
                                  "neck_strength",
                                  "birth_tone",
                                  "contracture",
                                  "keep_spacing",
                                  "body",
                                  "eyes",
                                  "delays",
                                  "threshold",
                                  "flicker"};
constexpr std::size_t kNumbers = sizeof kNames / sizeof *kNames;

// Visits all members in the order of their names; the same for those that are read and written.
template <typename Growth, typename Visit>
void for_each_member(Growth& growth, Visit&& visit) {
  visit(growth.age);
  visit(growth.physiological_age);
  visit(growth.sex);
  visit(growth.model);
  visit(growth.z_length);
  visit(growth.z_weight);
  visit(growth.z_head);
  visit(growth.absolute);
  visit(growth.strength_exponent);
  visit(growth.neck_strength);
  visit(growth.birth_tone);
  visit(growth.contracture);
  visit(growth.keep_spacing);
  visit(growth.body);
  visit(growth.eyes);
  visit(growth.delays);
  visit(growth.threshold);
  visit(growth.flicker);
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

std::vector<double> row_of(const Growths& growths) {
  std::vector<double> row;
  for (const growth::Growth& growth : growths) {
    for_each_member(growth, [&](const auto& member) { row.push_back(static_cast<double>(member)); });
  }
  return row;
}

std::string names_of_row(const env::World& world) {
  std::string names;
  for (const env::Agent& agent : world.agents()) {
    for (const char* name : kNames) names += (agent.name.empty() ? "" : agent.name + "/") + name + "\n";
  }
  return names;
}

Growths growths_of_row(const std::vector<double>& row) {
  require(row.size() % kNumbers == 0, "a row has {} numbers, expected {} for each agent", row.size(), kNumbers);
  Growths growths(row.size() / kNumbers);
  const double* next = row.data();
  for (growth::Growth& growth : growths) {
    for_each_member(growth, [&](auto& member) { take(*next++, member); });
    growth::check(growth);
  }
  return growths;
}

}  // namespace mimo::recording
