#include "recording/bodies.h"

#include "base/fail.h"

namespace mimo::recording {
namespace {

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
    const auto numbers = growth::numbers_of(growth);
    row.insert(row.end(), numbers.begin(), numbers.end());
  }
  return row;
}

std::string names_of_row(const env::World& world) {
  std::string names;
  for (const env::Agent& agent : world.agents()) {
    const std::string prefix = agent.name.empty() ? "" : agent.name + "/";
    growth::for_each_member(agent.growth, [&](const char* name, const auto&) { names += prefix + name + "\n"; });
  }
  return names;
}

Growths growths_of_row(const std::vector<double>& row) {
  constexpr std::size_t kEach = growth::kMembers;
  require(row.size() % kEach == 0, "a row has {} numbers, expected {} for each agent", row.size(), kEach);
  Growths growths(row.size() / kEach);
  const double* next = row.data();
  for (growth::Growth& growth : growths) {
    growth::for_each_member(growth, [&](const char*, auto& member) { take(*next++, member); });
    growth::check(growth);
  }
  return growths;
}

}  // namespace mimo::recording
