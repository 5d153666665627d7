// How long nerves are, and what they take.
#include <gtest/gtest.h>

#include <Eigen/Core>

#include "body/body.h"
#include "growth/maturity.h"
#include "support/infants.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

// A head 10 cm above its joint, a chest whose neck is 20 cm above its middle, a belly 30 cm below it, an arm of two
// parts and a leg. All lengths are in the text: straight, the hand's way is 5 (to the elbow) + 30 (to the shoulder) +
// 50 (3-4-5 from there to the neck), the leg's 15 (to the hip) + 40 (to the belly's joint) + 30 (to the neck), the
// head's 10 cm.
const char* const kModel =
    "<mujoco><worldbody><body name='belly'><freejoint/><geom size='.1'/>"
    "<body name='chest' pos='0 0 .3'><joint pos='0 0 -.1'/><geom size='.1'/>"
    "<body name='head' pos='0 0 .3'><joint pos='0 0 -.1'/><geom size='.1'/></body>"
    "<body name='arm' pos='.4 0 -.1'><joint/><geom size='.05' pos='.15 0 0'/>"
    "<body name='hand' pos='.3 0 0'><joint axis='0 1 0'/><geom size='.03' pos='.05 0 0'/></body></body></body>"
    "<body name='leg' pos='0 0 -.2'><joint/><geom size='.05' pos='0 0 -.15'/></body></body>"
    "<body name='ball'><geom size='.1'/></body></worldbody></mujoco>";

TEST(Nerves, GoThroughJointsToTheHead) {
  constexpr double kHead = 1.03, kSpine = 0.62, kArm = 1.37, kLeg = 1.65;  // nerves over straight ways
  const engine::ModelPtr model = compiled(kModel);
  const auto id = [&](const char* name) { return engine::find_or_fail(*model, engine::Kind::kBody, name); };
  body::Body body;
  body.root = id("belly");
  body.head = id("head");
  body.bodies = body::subtree(*model, body.root);
  const std::vector<double> lengths = body::nerve_lengths(*model, body);
  const auto length = [&](const char* name) { return lengths[static_cast<std::size_t>(id(name))]; };
  const double head = kHead * 0.1;
  EXPECT_NEAR(length("head"), head, 1e-9);
  EXPECT_NEAR(length("chest"), kSpine * 0.2 + head, 1e-9);
  EXPECT_NEAR(length("belly"), kSpine * (0.2 + 0.3) + head, 1e-9);
  EXPECT_NEAR(length("arm"), kArm * (0.15 + 0.5) + head, 1e-9);
  EXPECT_NEAR(length("hand"), kArm * (0.05 + 0.3 + 0.5) + head, 1e-9);
  EXPECT_NEAR(length("leg"), kLeg * 0.15 + kSpine * (0.4 + 0.3) + head, 1e-9);
  EXPECT_EQ(length("ball"), 0);
}

// An infant's nerves as its model has them.
class Infant {
 public:
  Infant(const std::string& body, double age) {
    scene::Scene scene(named("benchmark"));
    scene.add_body(body, "", nullptr);
    scene.grow("", aged(age));
    model_ = compile(scene);
  }

  double length(const std::string& part) const { return body::nerve_length(*model_, id(part)); }

  // Of the nerve from the wrist to the neck. What of it lies in hand and forearm tells how much longer it is than the
  // straight way.
  double wrist_to_neck() const {
    const Eigen::Vector3d wrist = anchor("left_hand");
    const double in_hand = (middle("left_hand") - wrist).norm();
    const Eigen::Vector3d end = Eigen::Vector3d(model_->body_pos + 3 * id("left_hand")) + wrist;  // not turned
    const double forearm = end.norm() - middle("left_lower_arm").norm();                          // the elbow is at 0
    const double longer = (length("left_hand") - length("left_lower_arm")) / (in_hand + forearm);
    return length("left_hand") - length("head") - longer * in_hand;
  }

 private:
  int id(const std::string& body) const { return engine::find_or_fail(*model_, engine::Kind::kBody, body); }
  Eigen::Vector3d middle(const std::string& body) const { return Eigen::Vector3d(model_->body_ipos + 3 * id(body)); }
  Eigen::Vector3d anchor(const std::string& body) const {
    return Eigen::Vector3d(model_->jnt_pos + 3 * model_->body_jntadr[id(body)]);
  }

  engine::ModelPtr model_;
};

// Ways from parts of infants to the brain stem, m, by lengths of limbs of the survey of Snyder et al. 1977 and the
// WHO's; estimates.
TEST(Nerves, HaveTheLengthOfInfants) {
  const struct {
    const char* part;
    double at_0, at_6, at_18;
  } rows[] = {{"left_upper_arm", 0.18, 0.24, 0.29},
              {"left_lower_arm", 0.27, 0.35, 0.42},
              {"left_hand", 0.34, 0.43, 0.53},
              {"left_fingers", 0.37, 0.47, 0.57},
              {"hip", 0.17, 0.23, 0.28},
              {"left_upper_leg", 0.24, 0.32, 0.40},
              {"left_lower_leg", 0.38, 0.49, 0.62},
              {"left_foot", 0.49, 0.63, 0.79}};
  const Infant newborn("mitten", 0), half_a_year("mitten", 6), toddler("mitten", 18);
  for (const auto& row : rows) {
    EXPECT_NEAR(newborn.length(row.part) / row.at_0, 1, 0.07) << row.part;
    EXPECT_NEAR(half_a_year.length(row.part) / row.at_6, 1, 0.07) << row.part;
    EXPECT_NEAR(toddler.length(row.part) / row.at_18, 1, 0.07) << row.part;
  }
}

// Waves after a touch of the wrist. N13, at the neck of newborns: measured 10.1 +- .5 ms (Electroencephalogr Clin
// Neurophysiol 1988;71:100). N20, in the cortex: 38.5 ms by lengths of newborns (measured 38.9 +- 4.7), 20.6 by those
// of infants of 6 months (measured 20, in infants born early).
TEST(Nerves, GiveInfantsEvokedPotentials) {
  constexpr double kHalf = 0.0005;
  const growth::Conduction young = growth::conduction_at(0), older = growth::conduction_at(6);
  for (const char* body : {"mitten", "fingers"}) {
    const Infant newborn(body, 0), half_a_year(body, 6);
    EXPECT_NEAR(young.along(newborn.wrist_to_neck()), 0.0101, kHalf) << body;
    EXPECT_NEAR(young.along(newborn.wrist_to_neck() + newborn.length("head")) + young.sensory, 0.0385, kHalf) << body;
    EXPECT_NEAR(older.along(half_a_year.wrist_to_neck() + half_a_year.length("head")) + older.sensory, 0.0206, kHalf)
        << body;
  }
}

// From wrist to neck, .257 m in a newborn, and .34 m from hand to brain stem: N13 was measured at 10.1 ms, N20 at 38.9
// (Electroencephalogr Clin Neurophysiol 1988;71:100), and at 20 ms with six months.
TEST(Conduction, AgreesWithEvokedPotentials) {
  const growth::Conduction newborn = growth::conduction_at(0), half_a_year = growth::conduction_at(6);
  EXPECT_NEAR(newborn.along(0.257), 0.0105, 5e-5);
  EXPECT_NEAR(newborn.along(0.257) + newborn.sensory + 0.002, 0.0385, 1e-4);
  EXPECT_NEAR(newborn.along(0.34) + newborn.sensory, 0.040, 5e-4);
  EXPECT_NEAR(half_a_year.along(0.43) + half_a_year.sensory, 0.022, 1e-3);
}

// Rows of the table that the formula was published with here: face, hand and foot by their lengths, ms.
TEST(Conduction, FollowsItsTable) {
  const struct {
    double age, metres, sensory, motor;
  } rows[] = {{0, 0.34, 40, 36}, {0, 0.49, 46, 42},  {6, 0.43, 22, 24},
              {6, 0.63, 26, 29}, {18, 0.53, 19, 21}, {18, 0.79, 24, 27}};
  for (const auto& row : rows) {
    const growth::Conduction at = growth::conduction_at(row.age);
    EXPECT_NEAR(1000 * (at.along(row.metres) + at.sensory), row.sensory, 0.6) << row.age;
    EXPECT_NEAR(1000 * (at.along(row.metres) + at.motor), row.motor, 0.6) << row.age;
  }
}

// 0.6 of the measured wave: 256 ms at birth, 182 with six weeks, 104 later.
TEST(Conduction, OfTheEyesMaturesInTheFirstWeeks) {
  const double week = 7 / 30.4375;
  EXPECT_NEAR(growth::conduction_at(0).vision, 0.6 * 0.256, 1e-3);
  EXPECT_NEAR(growth::conduction_at(6 * week).vision, 0.6 * 0.182, 1e-3);
  EXPECT_NEAR(growth::conduction_at(24).vision, 0.6 * 0.104, 1e-3);
  for (double age = 0; age < 12; age += 0.25) {
    EXPECT_LT(growth::conduction_at(age + 0.25).vision, growth::conduction_at(age).vision + 1e-12);
    EXPECT_LT(growth::conduction_at(age + 0.25).sensory, growth::conduction_at(age).sensory);
  }
}

}  // namespace
}  // namespace mimo::test
