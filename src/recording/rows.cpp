#include "recording/rows.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "base/bytes.h"
#include "base/fail.h"
#include "base/format.h"
#include "recording/system.h"

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

int joints_of(const env::World& world) { return world.model().njnt; }

std::string name_of(const env::World& world, int joint) {
  return engine::name(world.model(), engine::Kind::kJoint, joint);
}

// Free joints often have no name, but their bodies have.
std::string column_name(const env::World& world, int joint) {
  const std::string own = name_of(world, joint);
  return own.empty() ? engine::name(world.model(), engine::Kind::kBody, world.model().jnt_bodyid[joint]) : own;
}

template <typename T>
double largest(Span<const std::uint8_t> a, Span<const std::uint8_t> b) {
  double largest = 0;
  for (std::size_t at = 0; at < a.size(); at += sizeof(T)) {
    if (std::memcmp(a.data() + at, b.data() + at, sizeof(T)) == 0) continue;
    T one, other;
    std::memcpy(&one, a.data() + at, sizeof one);
    std::memcpy(&other, b.data() + at, sizeof other);
    const double difference = std::abs(static_cast<double>(one) - static_cast<double>(other));
    largest = std::max(largest, std::isfinite(difference) ? difference : std::numeric_limits<double>::max());
  }
  return largest;
}

std::uint64_t hash_of_library() {
  Hash hash;
  std::ifstream file(path_of_this_library(), std::ios::binary);
  std::vector<std::uint8_t> piece(1 << 16);
  while (file.read(reinterpret_cast<char*>(piece.data()), static_cast<std::streamsize>(piece.size())),
         file.gcount() > 0) {
    hash.add({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  return hash.value();
}

// Reading the library takes a while, so each process does it once; threads that do it at the same time agree.
std::atomic<std::uint64_t> known_hash{0};

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

std::string joint_names(const env::World& world) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) names += name_of(world, i) + "\n";
  return names;
}

std::string joint_columns(const env::World& world, mimo_quantity quantity) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) {
    for (int left = access::width(access::quantity_of(quantity), world.model(), &world, i); left > 0; --left) {
      names += column_name(world, i) + "\n";
    }
  }
  return names;
}

void read_joints(const env::World& world, mimo_quantity number, std::vector<double>& values) {
  const access::Quantity& quantity = access::quantity_of(number);
  const access::Ids all(joints_of(world));
  values.resize(access::width(world, quantity, all));
  access::get(world, quantity, all, false, Span<double>(values));
}

double largest_difference(observation::Type type, Span<const std::uint8_t> one, Span<const std::uint8_t> other) {
  switch (type) {
    case observation::Type::kU8: return largest<std::uint8_t>(one, other);
    case observation::Type::kI32: return largest<std::int32_t>(one, other);
    case observation::Type::kF32: return largest<float>(one, other);
    case observation::Type::kF64: return largest<double>(one, other);
  }
  return 0;
}

std::string build_name(const std::string& versions) {
  std::uint64_t hash = known_hash;
  if (hash == 0) known_hash = hash = hash_of_library();
  return format("{}, build {:016x}", versions, hash);
}

const char* byte_order() {
  const std::uint16_t one = 1;
  return *reinterpret_cast<const std::uint8_t*>(&one) == 1 ? "little" : "big";
}

}  // namespace mimo::recording
