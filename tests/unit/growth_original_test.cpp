// Both bodies by the original's rules, against numbers of the original's second version.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <optional>

#include "growth/growth.h"
#include "growth/mechanics.h"
#include "growth/original/original.h"
#include "growth/skeleton.h"
#include "repository_paths.h"
#include "support/infants.h"
#include "support/numbers.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using growth::Skeleton;

const std::vector<int> kAges = {0, 1, 3, 6, 9, 12, 15, 18, 21, 24};
constexpr Tolerance kRecorded = {5e-9, 1e-10};  // nine digits

// The upper chest of the five-fingered body weighs 721.7 g in the second version and 727.9 g in release 1.1, from which
// we have it.
Skeleton base_of_second_version(const std::string& body) {
  Skeleton base = infant(body);
  growth::Parts(base).geom("ub3").mass = 0.7217;
  return base;
}

Skeleton original(const std::string& body, int age) {
  growth::Growth growth = aged(age);
  growth.model = growth::Model::kOriginal;
  return grown(base_of_second_version(body), growth);
}

int component(const std::string& name) {
  const std::map<std::string, int> indices = {{"x", 0},           {"y", 1},      {"z", 2},      {"radius", 0},
                                              {"half_length", 1}, {"half_x", 0}, {"half_y", 1}, {"half_z", 2}};
  return indices.at(name);
}

// What of the original's bodies ours do not have: a body for the chest, a neck, and motors of the chest.
bool is_ours(const std::string& element) {
  return element != "chest" && element != "neck" && element.rfind("act:chest_", 0) != 0;
}

// Our upper body is the original's upper body and chest: a part of the chest has the chest's place added.
bool hangs_in_chest(const std::string& quantity, const std::string& element) {
  return (quantity == "geom_position" && element == "ub3") ||
         (quantity == "body_position" && element == "left_upper_arm");
}

class Comparison {
 public:
  explicit Comparison(const Skeleton& skeleton) : body_(skeleton), parts_(body_) {}

  // Nothing where the table's quantity is none of a body's numbers.
  std::optional<double> value(const Table::Row& row) {
    const std::string quantity = row.text("quantity"), element = row.text("element");
    if (quantity == "total_mass") return growth::total_mass(body_);
    if (quantity == "stature") return growth::stature(body_);
    if (quantity == "geom_mass") return parts_.geom(element).mass;
    if (quantity == "motor_gear") return gear(element);
    const int index = component(row.text("component"));
    if (quantity.rfind("geom_size", 0) == 0) return parts_.geom(element).size[index];
    if (quantity == "geom_position") return parts_.geom(element).position[index];
    if (quantity == "body_position") return parts_.bone(element).position[index];
    if (quantity == "joint_position") return parts_.joint(element).position[index];
    if (quantity == "site_position") return parts_.mark(element).position[index];
    return std::nullopt;
  }

 private:
  std::optional<double> gear(const std::string& name) const {
    for (const growth::Motor& motor : body_.motors) {
      if (motor.name == name) return motor.gear;
    }
    return std::nullopt;
  }

  Skeleton body_;
  growth::Parts parts_;
};

double number(const Table::Row& row, int age) { return row.number("age_" + std::to_string(age)); }

double chest_offset(const Table& table, const std::string& body, const std::string& component, int age) {
  for (const Table::Row& row : table.rows()) {
    if (row.text("body") == body && row.text("quantity") == "body_position" && row.text("element") == "chest" &&
        row.text("component") == component) {
      return number(row, age);
    }
  }
  ADD_FAILURE() << "no chest";
  return 0;
}

// `label` is what the table calls the body.
void expect_original(const std::string& body, const std::string& label, int least) {
  const Table table(MIMO_TEST_DATA "/growth/original.csv");
  for (const int age : kAges) {
    Comparison comparison(original(body, age));
    int compared = 0;
    for (const Table::Row& row : table.rows()) {
      const std::string quantity = row.text("quantity"), element = row.text("element");
      if (row.text("body") != label || !is_ours(element)) continue;
      const double in_chest =
          hangs_in_chest(quantity, element) ? chest_offset(table, label, row.text("component"), age) : 0;
      const std::optional<double> value = comparison.value(row);
      ASSERT_TRUE(value) << row.label();
      EXPECT_TRUE(close(number(row, age) + in_chest, *value, kRecorded)) << row.label() << ", " << age << " months";
      ++compared;
    }
    EXPECT_GE(compared, least);
  }
}

TEST(GrowthOriginal, GivesTheOriginalsMittenBody) { expect_original("mitten", "mitten", 200); }

TEST(GrowthOriginal, GivesTheOriginalsFingeredBody) { expect_original("fingers", "five_finger", 330); }

TEST(GrowthOriginal, MirrorsTheLeftSideAndLeavesJointsAndMusclesAlone) {
  for (const char* name : {"mitten", "fingers"}) {
    const Skeleton body = original(name, 3);
    for (const growth::Bone& left : body.bones) {
      const growth::Bone& was = growth::bone(infant(name), left.name);
      for (std::size_t i = 0; i < left.joints.size(); ++i) {
        EXPECT_EQ(left.joints[i].range, was.joints[i].range);
        EXPECT_EQ(left.joints[i].stiffness, was.joints[i].stiffness);
        EXPECT_EQ(left.joints[i].armature, was.joints[i].armature);
      }
      if (left.name.rfind("left_", 0) != 0) continue;
      const growth::Bone& right = growth::bone(body, "right_" + left.name.substr(5));
      const growth::Vector mirrored = {right.position[0], -right.position[1], right.position[2]};
      EXPECT_EQ(left.position, mirrored) << left.name;
      for (std::size_t i = 0; i < left.geoms.size(); ++i) {
        EXPECT_EQ(left.geoms[i].size, right.geoms[i].size) << left.geoms[i].name;
        EXPECT_EQ(left.geoms[i].mass, right.geoms[i].mass) << left.geoms[i].name;
      }
    }
    for (std::size_t i = 0; i < body.motors.size(); ++i) {
      EXPECT_EQ(body.motors[i].muscle, infant(name).motors[i].muscle);
    }
  }
}

}  // namespace
}  // namespace mimo::test
