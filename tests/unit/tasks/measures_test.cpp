// Quantities of behaviours, in a world of which everything is known: a body of two balls 1 m above the ground, and a
// ball beside it that tests lift.
#include "tasks/behaviour/measures.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "engine/model.h"

namespace mimo::tasks {
namespace {

constexpr const char* kWorld = R"(
<mujoco>
  <option gravity="0 0 0"/>
  <worldbody>
    <geom type="plane" size="0 0 1"/>
    <body name="mimo_location" pos="0 0 1">
      <freejoint/>
      <body name="hip">
        <geom type="sphere" size="0.1" mass="1"/>
        <body name="head" pos="0 0 0.3"><geom type="sphere" size="0.05" mass="1"/></body>
      </body>
    </body>
    <body name="ball" pos="2 0 0">
      <joint name="lift" type="slide" axis="0 0 1"/>
      <geom type="sphere" size="0.1" mass="1"/>
    </body>
    <body name="door" pos="5 0 1">
      <joint name="hinge" type="hinge" axis="0 0 1"/>
      <geom type="sphere" size="0.1" mass="1"/>
    </body>
  </worldbody>
</mujoco>)";

class Watching {
 public:
  explicit Watching(const std::string& quantity, std::vector<double> phases = {})
      : model_(engine::compile(kWorld, {}, {})),
        physics_(model_, {}),
        body_(body::find_body(*model_, "")),
        phases_(std::move(phases)) {
    Maker maker(*model_, body_, phases_);
    quantity_ = maker.quantity(quantity);
    memory_.assign(maker.kept(), 0);
  }

  double look(double seconds) {
    time_ += seconds;
    physics_.forward();
    return quantity_->look({*model_, physics_.data(), seconds, time_, memory_});
  }
  double begin() { return look(0); }

  // The middle of the ball is at this height: at 0.1 it touches the ground, below it presses.
  Watching& lift(double height) { return set("lift", height); }
  Watching& set(const char* joint, double value) {
    physics_.data().qpos[address(joint)] = value;
    return *this;
  }
  Watching& put(double x, double y, double z, double turn = 0, double ax = 0, double ay = 0, double az = 1) {
    double* root = physics_.data().qpos;
    const double half = turn * kDegree / 2;
    const double pose[] = {x, y, z, std::cos(half), ax * std::sin(half), ay * std::sin(half), az * std::sin(half)};
    std::copy(std::begin(pose), std::end(pose), root);
    return *this;
  }
  const char* unit() const { return quantity_->unit(); }
  engine::Physics& physics() { return physics_; }
  const std::vector<double>& memory() const { return memory_; }

 private:
  int address(const char* joint) const {
    return model_->jnt_qposadr[engine::find(*model_, engine::Kind::kJoint, joint)];
  }

  engine::ModelPtr model_;
  engine::Physics physics_;
  body::Body body_;
  std::vector<double> phases_, memory_;
  QuantityPtr quantity_;
  double time_ = 0;
};

TEST(Measures, HeightDistanceTiltAndJoint) {
  EXPECT_NEAR(Watching("height head").begin(), 1.3, 1e-12);
  EXPECT_NEAR(Watching("distance head ball").lift(1.3).begin(), 2, 1e-12);
  EXPECT_NEAR(Watching("tilt hip z").put(0, 0, 1, 30, 1, 0, 0).begin(), 30, 1e-9);
  EXPECT_NEAR(Watching("tilt hip -z").put(0, 0, 1, 30, 1, 0, 0).begin(), 150, 1e-9);
  EXPECT_NEAR(Watching("tilt hip x").put(0, 0, 1, -90, 0, 1, 0).begin(), 0, 1e-6) << "on its back";
  EXPECT_NEAR(Watching("joint hinge").set("hinge", 0.5).begin(), 0.5 / kDegree, 1e-12);
}

TEST(Measures, ContactsCountPartsThatPress) {
  EXPECT_EQ(Watching("contacts body ground").begin(), 0);
  EXPECT_EQ(Watching("contacts hip,head ground").put(0, 0, 0.09).begin(), 1) << "the hip is 1 cm in the ground";
  EXPECT_EQ(Watching("contacts body ground").put(0, 0, 0.04, 90, 0, 1, 0).begin(), 2) << "it lies";
  EXPECT_EQ(Watching("contacts body-head ground").put(0, 0, 0.04, 90, 0, 1, 0).begin(), 1);
  EXPECT_EQ(Watching("contacts body outside").put(2, 0, 1).lift(1.15).begin(), 1) << "the ball, from between";
  EXPECT_EQ(Watching("contacts ball ground").lift(0.09).begin(), 1);
}

TEST(Measures, WaysOverTheGround) {
  Watching moved("moved hip");
  moved.put(1, 1, 1).begin();
  EXPECT_NEAR(moved.put(4, 5, 3).look(0.01), 5, 1e-12) << "3 and 4 m; how high does not count";
  Watching advance("advance hip x");
  advance.put(0, 0, 1, 90).begin();
  EXPECT_NEAR(advance.put(7, 2, 1).look(0.01), 2, 1e-9) << "it looked along y";
  EXPECT_NEAR(advance.put(7, -2, 1, 180).look(0.01), -2, 1e-9) << "where it looks now does not count";
}

TEST(Measures, SpeedIsThatOfTheOrigin) {
  Watching speed("speed hip");
  speed.physics().data().qvel[0] = 3;
  speed.physics().data().qvel[2] = 4;
  EXPECT_NEAR(speed.begin(), 5, 1e-12);
}

TEST(Measures, OfWhatWas) {
  Watching change("change (height ball)");
  change.lift(0.3).begin();
  EXPECT_NEAR(change.lift(0.8).look(0.1), 0.5, 1e-12);
  Watching highest("highest (height ball)"), lowest("lowest (height ball)");
  for (Watching* watching : {&highest, &lowest}) watching->lift(0.5).begin();
  for (const double height : {0.9, 0.2}) {
    highest.lift(height).look(0.1);
    lowest.lift(height).look(0.1);
  }
  EXPECT_NEAR(highest.lift(0.4).look(0.1), 0.9, 1e-12);
  EXPECT_NEAR(lowest.lift(0.4).look(0.1), 0.2, 1e-12);
  EXPECT_NEAR(Watching("larger (height ball) (height head)").lift(0.5).begin(), 1.3, 1e-12);
  EXPECT_NEAR(Watching("smaller (height ball) (height head)").lift(0.5).begin(), 0.5, 1e-12);
}

// Whatever compiles it: a state that one compiler's build saved is read by another's.
TEST(Measures, RememberInTheOrderOfTheirWords) {
  for (const char* kind : {"larger", "smaller"}) {
    Watching two(std::string(kind) + " (change (height ball)) (change (height head))");
    two.lift(0.5).begin();
    ASSERT_EQ(two.memory().size(), 2u);
    EXPECT_NEAR(two.memory()[0], 0.5, 1e-12) << kind << ": the ball's height, named first";
    EXPECT_NEAR(two.memory()[1], 1.3, 1e-12) << kind << ": the head's";
  }
}

// Up for 0.3 s, down for 0.2 s, up for 0.5 s, of 1 s.
double after_two_lifts(Watching& watching) {
  watching.lift(0).begin();
  for (int i = 0; i < 3; ++i) watching.lift(1).look(0.1);
  for (int i = 0; i < 2; ++i) watching.lift(0).look(0.1);
  double last = 0;
  for (int i = 0; i < 5; ++i) last = watching.lift(1).look(0.1);
  return last;
}

TEST(Measures, HowLongAndHowOftenAConditionHolds) {
  const std::string condition = " (height ball at least 0.5 m)";
  Watching time("time" + condition), longest("longest" + condition), share("share" + condition),
      times("times" + condition);
  EXPECT_NEAR(after_two_lifts(time), 0.8, 1e-9);
  EXPECT_NEAR(after_two_lifts(longest), 0.5, 1e-9);
  EXPECT_NEAR(after_two_lifts(share), 0.8, 1e-9);
  EXPECT_EQ(after_two_lifts(times), 2);
  EXPECT_STREQ(time.unit(), "s");
  EXPECT_STREQ(times.unit(), "times");
  EXPECT_STREQ(share.unit(), "");
}

TEST(Measures, WhatBouncesBeginsOnce) {
  Watching times("times (height ball at least 0.5 m)");
  times.lift(0).begin();
  for (const double height : {1.0, 0.0, 1.0, 0.0, 1.0}) times.lift(height).look(0.03);
  EXPECT_EQ(times.look(0.03), 1) << "pauses of 0.03 s";
  Watching already("times (height ball at least 0.5 m)");
  already.lift(1).begin();
  EXPECT_EQ(already.lift(1).look(0.2), 0) << "it holds from the start";
}

TEST(Measures, AlternationsWantTurns) {
  Watching steps("alternations (height ball at least 0.5 m) (joint hinge at least 10 deg)");
  steps.begin();
  const auto pulse = [&](double height, double angle) {
    steps.lift(height).set("hinge", angle).look(0.2);
    return steps.lift(0).set("hinge", 0).look(0.2);
  };
  EXPECT_EQ(pulse(1, 0), 1);
  EXPECT_EQ(pulse(1, 0), 1) << "the same again";
  EXPECT_EQ(pulse(0, 1), 2);
  EXPECT_EQ(pulse(1, 0), 3);
}

TEST(Measures, PreferenceIsTheFirstOnesShare) {
  Watching preference("preference (height ball at least 0.5 m) (joint hinge at least 10 deg)");
  EXPECT_EQ(preference.begin(), 0.5);
  for (int i = 0; i < 3; ++i) preference.lift(1).look(0.1);
  EXPECT_NEAR(preference.lift(0).set("hinge", 1).look(0.1), 0.75, 1e-9);
}

// Once in the 2 s of the first phase; 3 times in the 3 s of the second: twice as often.
TEST(Measures, GainComparesPhases) {
  Watching gain("gain (height ball at least 0.5 m) 2 1", {2, 3});
  gain.begin();
  const auto pulse = [&] {
    gain.lift(1).look(0.5);
    return gain.lift(0).look(0.5);
  };
  pulse();
  EXPECT_EQ(gain.look(1), 0) << "the second phase has not begun";
  pulse();
  pulse();
  EXPECT_NEAR(pulse(), 2, 1e-9);
  EXPECT_NEAR(gain.look(1), 2, 1e-9) << "what comes later does not count";
}

std::string refusal(const std::string& text, bool condition = false, const std::string& world = kWorld) {
  const engine::ModelPtr model = engine::compile(world, {}, {});
  const body::Body body = body::find_body(*model, "");
  Maker maker(*model, body, {});
  try {
    condition ? static_cast<void>(maker.condition(text)) : static_cast<void>(maker.quantity(text));
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kModel);
    return error.message();
  }
  return "taken";
}

TEST(Measures, WhatMeansNothingIsNamed) {
  for (const auto& [text, said] : {std::pair("hight head", "did you mean \"height\""),
                                   {"height", "expected PART"},
                                   {"height left_wing", "no body named \"left_wing\""},
                                   {"contacts left_hand ground", "a part that this infant's body lacks"},
                                   {"tilt head up", "x, y, z, -x, -y or -z"},
                                   {"tilt body x", "one part is expected"},
                                   {"joint lift", "no hinge named \"lift\""},
                                   {"contacts body-body ground", "leaves no part"},
                                   {"contacts body,head ground", "body \"head\" is in two of the parts"},
                                   {"larger (height head) (tilt head z)", "cannot be compared"},
                                   {"gain (height head at least 1 m) 2 1", "has 0 phases"},
                                   {"time (height head)", "\"at least\" or \"at most\""}}) {
    EXPECT_NE(refusal(text).find(said), std::string::npos) << text << ": " << refusal(text);
  }
  EXPECT_NE(refusal("height head at least 1 deg", true).find("unit \"deg\", expected \"m\""), std::string::npos);
}

// The world, the ball and the door are outside: 253 more are 256 parts.
TEST(Measures, ContactsOfTooManyPartsAreRefused) {
  const auto with = [](int more) {
    std::string world = kWorld, bodies;
    for (int i = 0; i < more; ++i) bodies += "<body><geom size='0.1'/></body>";
    return world.insert(world.find("</worldbody>"), bodies);
  };
  EXPECT_EQ(refusal("contacts outside hip", false, with(253)), "taken");
  const std::string said = refusal("contacts outside hip", false, with(254));
  EXPECT_NE(said.find("257 parts"), std::string::npos) << said;
  EXPECT_NE(said.find("256 at most"), std::string::npos) << said;
}

TEST(Goals, ProgressGoesFromWhereItBeginsToTheThreshold) {
  const engine::ModelPtr model = engine::compile(kWorld, {}, {});
  body::Body body = body::find_body(*model, "");
  body.stature = 0.5;  // lengths of the document are those of twice this body
  Maker maker(*model, body, {});
  const Goal height = maker.goal(read_clause("height head at least 0.6 from 0.2 m"));
  EXPECT_NEAR(height.threshold, 0.3, 1e-12);
  EXPECT_NEAR(height.progress(0.2), 0.5, 1e-12);
  EXPECT_EQ(height.progress(9), 1);
  EXPECT_EQ(height.progress(0), 0);
  const Goal tilt = maker.goal(read_clause("tilt head z at most 30 from 90 deg"));
  EXPECT_NEAR(tilt.progress(45), 0.75, 1e-12);
  EXPECT_EQ(maker.goal(read_clause("tilt head z at most 30 deg")).progress(31), 0) << "all or nothing";
}

}  // namespace
}  // namespace mimo::tasks
