// Reflexes in worlds: what sets each off, which motors it pulls, how they add to what the agent commands.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/header.h"
#include "body/body.h"
#include "env/attached.h"
#include "reflexes/table.h"
#include "support/block.h"
#include "support/infants.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;
using reflexes::Reflex;

constexpr double kTick = 0.005;

std::uint32_t bit(Reflex reflex) { return reflexes::rule(reflex).bit; }

const char* const kBall = "<geom type='sphere' size='.005' mass='.0005'/>";

// An infant of that age that hangs on a weld 1 m above the origin, without a floor; and a thing that flies free.
engine::ModelPtr hanging(const std::string& body, double months, const std::string& thing) {
  scene::Scene scene(from_text(
      std::string(
          "<mujoco><include file='mimo/parts/options.xml'/><worldbody><body name='thing' pos='0 2 1'><freejoint/>") +
      thing +
      "</body></worldbody>"
      "<equality><weld name='hold' body1='mimo_location' active='true' solref='.01 1' solimp='.9999 .9999 "
      ".001 .5 1'/></equality></mujoco>"));
  const document::Pose pose{{0, 0, 1}, {1, 0, 0, 0}};
  scene.add_body(body, "", &pose);
  scene.grow("", aged(months));
  return compile(scene);
}

env::AgentOptions newborn(std::uint32_t reflexes, double months = 1) {
  env::AgentOptions options = blind();
  options.touch.wanted = 0;
  options.growth = aged(months);
  options.reflexes.wanted = reflexes;
  return options;
}

// Everything that touches: a ball that comes to rest on the skin and then presses with that force.
struct Touch {
  const char* body;  // of the left side, or the head
  Vector3d point;    // in its frame, m
  Vector3d from;     // where the ball comes from
  double far = 0.03;
};

Touch on_palm(double sign = 1) { return {"left_hand", {0, 0, 0.01}, {0, sign, 0}}; }  // fingers bend towards +y
Touch on_ball_of_foot() { return {"left_foot", {0.034, 0, 0}, {0, 0, -1}}; }
Touch on_heel() { return {"left_foot", {-0.005, 0, 0}, {0, 0, -1}}; }
// The built-in faces have the corner of the mouth at tangents 0.185 to the side and 0.575 down.
Touch on_mouth(double side) {
  const Vector3d corner = Vector3d(1, side * 0.185, -0.575).normalized();
  return {"head", {}, corner, 0.15};
}

class Hanging {
 public:
  Hanging(const std::string& body, const env::AgentOptions& agent, int frame_skip = 1, bool gravity = false,
          const std::string& thing = kBall)
      : world_(hanging(body, agent.growth.age, thing), {agent}, options(frame_skip, gravity)), block_(world_) {
    world_.reset(nullptr, block_.data());
  }

  env::World& world() { return world_; }
  mjData& data() { return world_.physics().data(); }
  const mjModel& model() const { return world_.model(); }

  void step(Span<const float> actions = {}) { world_.step(actions, block_.data(), {}); }
  // Seconds until a reflex acts, with actions of 0 where there are any; negative: it does not within a second.
  double delay(const std::string& label) {
    for (int i = 0; i < 200; ++i) {
      step();
      if (now(label) > 0) return i * kTick;
    }
    return -1;
  }
  double now(const std::string& label) const { return static_cast<double>(block_.at("reflex/activation", label)); }
  double control(const std::string& motor) { return data().ctrl[id(mjOBJ_ACTUATOR, "act:" + motor)]; }
  int id(int type, const std::string& name) const {
    const int found = mj_name2id(&model(), type, name.c_str());
    EXPECT_GE(found, 0) << name;
    return found;
  }
  void lock_all() {
    for (const body::Joint& joint : world_.agents()[0].body.joints) lock(joint.id);
  }
  void lock(int joint) {
    const int lock = engine::find_lock(model(), joint);
    if (lock >= 0) world_.physics().hold(lock, data().qpos[model().jnt_qposadr[joint]]);
  }
  // Puts the ball beside a point of a body, so far away from it.
  void place_thing(const Touch& touch, double away) {
    const Vector3d at =
        Vector3d(data().xpos + 3 * id(mjOBJ_BODY, touch.body)) + frame(touch) * (touch.point + away * touch.from);
    move_thing(at);
  }
  void push_with(const Touch& touch, double newtons) {
    Eigen::Map<Vector3d>{data().xfrc_applied + 6 * id(mjOBJ_BODY, "thing")} = -newtons * (frame(touch) * touch.from);
  }
  // Lays the thing, which is long, across a hand.
  void lay_across(const Touch& touch, double away) {
    place_thing(touch, away);
    const int joint = model().body_jntadr[id(mjOBJ_BODY, "thing")];
    Eigen::Quaterniond across(frame(touch) * Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitY()));
    double* quat = data().qpos + model().jnt_qposadr[joint] + 3;
    quat[0] = across.w(), quat[1] = across.x(), quat[2] = across.y(), quat[3] = across.z();
  }
  double distance(const char* one, const char* other) {
    return (Vector3d(data().xpos + 3 * id(mjOBJ_BODY, one)) - Vector3d(data().xpos + 3 * id(mjOBJ_BODY, other))).norm();
  }
  void take_away() {
    move_thing(Vector3d(0, 2, 1));
    push_with({"thing", {}, Vector3d::UnitX()}, 0);
  }

 private:
  Eigen::Matrix3d frame(const Touch& touch) {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data().xmat + 9 * id(mjOBJ_BODY, touch.body));
  }
  void move_thing(const Vector3d& to) {
    const int joint = model().body_jntadr[id(mjOBJ_BODY, "thing")];
    Eigen::Map<Vector3d>{data().qpos + model().jnt_qposadr[joint]} = to;
    Eigen::Map<Eigen::Matrix<double, 6, 1>>{data().qvel + model().jnt_dofadr[joint]}.setZero();
  }
  static env::EnvOptions options(int frame_skip, bool gravity) {
    env::EnvOptions options = without_renderer();
    options.frame_skip = frame_skip;
    options.physics.gravity = gravity;
    return options;
  }

  env::World world_;
  Observation block_;
};

// What a reflex of one touch does within 0.6 s: its label with "/left", and the force in N that the skin felt.
struct Response {
  double left = 0, right = 0;  // the greatest activation
  int felt = -1, acts = -1;    // ticks
};

class Touching : public Hanging {
 public:
  Touching(const std::string& body, Reflex reflex, double months)
      : Hanging(body, newborn(bit(reflex), months)), name_(reflexes::rule(reflex).name) {
    lock_all();
  }

  Response press(Touch touch, double newtons, double threshold, double seconds = 0.6) {
    if (std::string(touch.body) == "head") {
      const int head = id(mjOBJ_GEOM, "head");
      touch.point = Vector3d(model().geom_pos + 3 * head);
    }
    approach(touch);
    Response response;
    for (int tick = 0; tick < std::lround(seconds / kTick); ++tick) {
      push_with(touch, newtons * std::min(1.0, (tick + 1) / 40.0));  // as a hand would, not as a hammer
      step();
      if (response.felt < 0 && pressed() >= threshold) response.felt = tick;
      const double left = now(name_ + "/left"), right = now(name_ + "/right");
      if (response.acts < 0 && left > 0) response.acts = tick;
      response.left = std::max(response.left, left);
      response.right = std::max(response.right, right);
    }
    return response;
  }
  // As the body's nerves conduct: there, through the centre, and back.
  int latency(const char* felt, const char* moved, double centre, double speed) const {
    const double metres =
        body::nerve_length(model(), id(mjOBJ_BODY, felt)) + body::nerve_length(model(), id(mjOBJ_BODY, moved));
    return static_cast<int>(std::lround((metres / speed + centre) / kTick));
  }

 private:
  void approach(const Touch& touch) {
    for (double away = touch.far; away > 0; away -= 0.0002) {
      place_thing(touch, away);
      world().physics().update_contacts();
      if (data().ncon > 0) return place_thing(touch, away + 0.0002);
    }
    ADD_FAILURE() << "no skin there";
  }
  double pressed() const {
    double sum = 0;
    const mjData& now = const_cast<Touching*>(this)->data();
    const int ball = model().body_geomadr[id(mjOBJ_BODY, "thing")];
    for (int i = 0; i < now.ncon; ++i) {
      if (now.contact[i].geom1 != ball && now.contact[i].geom2 != ball) continue;
      sum += engine::contact_force(model(), now, i)[0];
    }
    return sum;
  }

  std::string name_;
};

struct Case {
  Reflex reflex;
  Touch touch;
  double threshold, age;     // N, months
  const char *felt, *moved;  // where the nerves begin and end
  double centre, speed;      // s, m/s
};

// Thresholds and speeds of nerves: 0.1 N in the hand and the foot; 1.2 g on the sole of a newborn; at 0 months 24.5
// m/s, at 1 month 26 m/s. A spinal centre takes 12 ms, the brain stem 25.
std::vector<Case> cases() {
  return {{Reflex::kPalmarGrasp, on_palm(), 0.1, 1, "left_hand", "left_ffdistal", 0.012, 26},
          {Reflex::kPlantarGrasp, on_ball_of_foot(), 0.1, 0, "left_foot", "left_toes", 0.012, 24.5},
          {Reflex::kRooting, on_mouth(1), 0.02, 1, "head", "head", 0.025, 26},
          {Reflex::kWithdrawal, on_heel(), 1.2e-3 * 9.81, 0, "left_foot", "left_foot", 0.012, 24.5}};
}

TEST(ReflexesInWorlds, StartOnTheTouchedSideAfterTheirLatency) {
  for (const Case& known : cases()) {
    const char* name = reflexes::rule(known.reflex).name;
    Touching weak("fingers", known.reflex, known.age);
    EXPECT_EQ(weak.press(known.touch, 0.9 * known.threshold, known.threshold).left, 0) << name;
    Touching infant("fingers", known.reflex, known.age);
    const Response response = infant.press(known.touch, 1.3 * known.threshold, known.threshold);
    EXPECT_NEAR(response.left, 1, 1e-6) << name;
    EXPECT_EQ(response.right, 0) << name;
    ASSERT_GE(response.felt, 0) << name;
    EXPECT_EQ(response.acts - response.felt, infant.latency(known.felt, known.moved, known.centre, known.speed))
        << name;
  }
}

TEST(ReflexesInWorlds, DoNotStartFromOtherPlaces) {
  Touching hand("fingers", Reflex::kPalmarGrasp, 1);
  EXPECT_EQ(hand.press(on_palm(-1), 0.5, 0.1).left, 0) << "the back of the hand";
  Touching foot("fingers", Reflex::kPlantarGrasp, 1);
  EXPECT_EQ(foot.press(on_heel(), 0.5, 0.1).left, 0);
  Touching face("fingers", Reflex::kRooting, 1);
  const Response right = face.press(on_mouth(-1), 0.1, 0.02);
  EXPECT_EQ(right.left, 0);
  EXPECT_NEAR(right.right, 1, 1e-6);
  Touching brow("fingers", Reflex::kRooting, 1);
  const Response none = brow.press({"head", {}, Vector3d(1, 0.2, 0.5).normalized(), 0.15}, 0.1, 0.02);
  EXPECT_EQ(none.left + none.right, 0) << "the forehead";
}

TEST(ReflexesInWorlds, EndAtTheirAge) {
  Touching hand("fingers", Reflex::kPalmarGrasp, 7);
  EXPECT_EQ(hand.press(on_palm(), 1, 0.1).left, 0);
  Touching leg("fingers", Reflex::kWithdrawal, 12);  // 4.6 g there
  EXPECT_EQ(leg.press(on_heel(), 0.04, 0.04).left, 0);
  EXPECT_NEAR(leg.press(on_heel(), 0.06, 0.04).left, 1, 1e-6);
}

TEST(ReflexesInWorlds, Habituate) {
  Touching infant("fingers", Reflex::kWithdrawal, 0);
  for (const double expected : {1.0, 0.8, 0.64}) {
    EXPECT_NEAR(infant.press(on_heel(), 0.02, 0.0118, 1).left, expected, 1e-6);
    infant.take_away();
    for (int i = 0; i < 400; ++i) infant.step();
  }
}

// An infant whose head is held so far to the left.
class LookingAside : public Hanging {
 public:
  LookingAside(double degrees, const env::AgentOptions& agent, int frame_skip = 1)
      : Hanging("mitten", agent, frame_skip), joint_(id(mjOBJ_JOINT, "robot:head_swivel")) {
    turn(degrees);
  }
  void turn(double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    data().qpos[model().jnt_qposadr[joint_]] = angle;
    world().physics().hold(engine::find_lock(model(), joint_), angle);
  }
  // A second, with these actions.
  void wait(const std::vector<float>& actions, double seconds = 1) {
    for (int i = 0; i < std::lround(seconds / world().step_seconds()); ++i) step(actions);
  }

 private:
  int joint_;
};

const char* const kNeck = "asymmetric_tonic_neck";

// 45 degrees and more; the side of the face is stretched, the other one bent, with 0.3 of what each motor can do: of
// the elbow 0.83 and 1, of the knee 1 and 0.65, of the hip 1 to both sides.
TEST(ReflexesInWorlds, ATurnedHeadStretchesTheLimbsOfItsSide) {
  const std::string reflex = kNeck;
  LookingAside little(40, newborn(bit(Reflex::kTonicNeck)));
  EXPECT_LT(little.delay(reflex + "/left"), 0);
  for (const bool left : {true, false}) {
    const std::string face = left ? "left" : "right", back = left ? "right" : "left";
    LookingAside infant(left ? 55 : -55, newborn(bit(Reflex::kTonicNeck)));
    infant.wait({});
    EXPECT_NEAR(infant.now(reflex + "/" + face), 1, 1e-6);
    EXPECT_EQ(infant.now(reflex + "/" + back), 0);
    EXPECT_NEAR(infant.control(face + "_elbow"), 0.3 * 0.83, 1e-9);
    EXPECT_NEAR(infant.control(face + "_knee"), 0.3, 1e-9);
    EXPECT_NEAR(infant.control(face + "_hip_flex"), 0.3, 1e-9);
    EXPECT_NEAR(infant.control(back + "_elbow"), -0.3, 1e-9);
    EXPECT_NEAR(infant.control(back + "_knee"), -0.3 * 0.65, 1e-9);
    EXPECT_NEAR(infant.control(back + "_hip_flex"), -0.3, 1e-9);
    EXPECT_EQ(infant.control(face + "_shoulder_abduction"), 0);
  }
}

// What is left and what is right follows the mirror image, motor by motor and tick by tick.
TEST(ReflexesInWorlds, MirroredStimuliGiveMirroredMovements) {
  LookingAside left(60, newborn(bit(Reflex::kTonicNeck))), right(-60, newborn(bit(Reflex::kTonicNeck)));
  for (int tick = 0; tick < 200; ++tick) {
    left.step();
    right.step();
    for (const char* motor : {"elbow", "knee", "hip_flex"}) {
      EXPECT_EQ(left.control(std::string("left_") + motor), right.control(std::string("right_") + motor));
      EXPECT_EQ(left.control(std::string("right_") + motor), right.control(std::string("left_") + motor));
    }
  }
}

std::size_t action_of(const Hanging& infant, const std::string& motor) {
  const std::vector<std::string>& names = const_cast<Hanging&>(infant).world().agents()[0].actuation->names();
  const auto found = std::find(names.begin(), names.end(), "act:" + motor);
  EXPECT_NE(found, names.end()) << motor;
  return static_cast<std::size_t>(found - names.begin());
}

// They add to commands, to no more than the motors' limits; what was commanded comes back to the bit.
TEST(ReflexesInWorlds, AddToCommands) {
  LookingAside infant(55, newborn(bit(Reflex::kTonicNeck)));
  std::vector<float> actions(infant.world().action_size(), 0.0F);
  actions[action_of(infant, "left_elbow")] = -1;
  actions[action_of(infant, "left_knee")] = 0.9F;
  actions[action_of(infant, "right_elbow")] = 0.1F;
  infant.wait(actions);
  EXPECT_NEAR(infant.control("left_elbow"), -1 + 0.3 * 0.83, 1e-7);
  EXPECT_EQ(infant.control("left_knee"), 1);
  EXPECT_NEAR(infant.control("right_elbow"), 0.1 - 0.3, 1e-7);
  infant.data().ctrl[infant.id(mjOBJ_ACTUATOR, "act:left_elbow")] = 0.25;  // by the host
  infant.step();
  EXPECT_NEAR(infant.control("left_elbow"), 0.25 + 0.3 * 0.83, 1e-7);
  infant.turn(0);
  infant.wait({});
  EXPECT_EQ(infant.now(kNeck + std::string("/left")), 0);
  EXPECT_EQ(infant.control("left_elbow"), 0.25);
  EXPECT_EQ(infant.control("left_knee"), static_cast<double>(0.9F));
  EXPECT_EQ(infant.control("right_elbow"), static_cast<double>(0.1F));
}

// A command that equals what stands there with the reflex is a command all the same.
TEST(ReflexesInWorlds, KeepACommandAtItsLimit) {
  LookingAside infant(55, newborn(bit(Reflex::kTonicNeck)));
  std::vector<float> actions(infant.world().action_size(), 0.0F);
  actions[action_of(infant, "left_knee")] = 0.9F;
  infant.wait(actions);
  ASSERT_EQ(infant.control("left_knee"), 1);
  actions[action_of(infant, "left_knee")] = 1;
  infant.step(actions);
  infant.turn(0);
  infant.wait({});
  EXPECT_EQ(infant.control("left_knee"), 1);
}

// Weak motors are so for what the brain commands: reflexes come from below it.
TEST(ReflexesInWorlds, ComeAfterTheLimitsOfMotors) {
  env::AgentOptions agent = newborn(bit(Reflex::kTonicNeck));
  actuation::MotorLimits half;
  half.concern = [](const std::string&) { return true; };
  half.limits.gain = 0.5;
  half.limits.delay = 0.05;
  agent.motors = {half};
  LookingAside infant(55, agent);
  std::vector<float> actions(infant.world().action_size(), 0.0F);
  actions[action_of(infant, "left_elbow")] = -1;
  infant.wait(actions);
  EXPECT_NEAR(infant.control("left_elbow"), -0.5 + 0.3 * 0.83, 1e-7);
  EXPECT_NEAR(infant.control("left_knee"), 0.3, 1e-7);
}

TEST(ReflexesInWorlds, PullTheMuscleOfTheirSide) {
  env::AgentOptions agent = newborn(bit(Reflex::kTonicNeck));
  agent.actuation.mode = actuation::Mode::kMuscle;
  LookingAside infant(55, agent);
  std::vector<float> actions(infant.world().action_size(), 0.0F);
  actions[action_of(infant, "left_knee/positive")] = 0.9F;
  actions[action_of(infant, "right_elbow/negative")] = 0.2F;
  infant.wait(actions);
  Observation block(infant.world());
  infant.world().step(actions, block.data(), {});
  const auto activation = [&](const char* muscle) { return block.at("proprioception/activation", muscle); };
  EXPECT_NEAR(activation("act:left_elbow/positive"), 0.3, 1e-3);
  EXPECT_NEAR(activation("act:left_elbow/negative"), 0, 1e-3);
  EXPECT_NEAR(activation("act:left_knee/positive"), 1, 1e-3);
  EXPECT_NEAR(activation("act:right_elbow/negative"), 0.5, 1e-3);
}

// Under position control by a share of the range of motion, within it.
TEST(ReflexesInWorlds, MoveTheCommandedAngle) {
  env::AgentOptions agent = newborn(bit(Reflex::kTonicNeck));
  agent.actuation.mode = actuation::Mode::kPosition;
  LookingAside infant(55, agent);
  const int elbow = infant.id(mjOBJ_JOINT, "robot:left_elbow"), knee = infant.id(mjOBJ_JOINT, "robot:left_knee");
  const double* range = infant.model().jnt_range;
  std::vector<float> actions(infant.world().action_size(), 0.0F);
  actions[action_of(infant, "left_elbow")] = -1.5F;
  actions[action_of(infant, "head_swivel")] = 0.96F;
  infant.wait(actions);
  const auto held = [&](int joint) {
    return engine::lock_angle(infant.model(), engine::find_lock(infant.model(), joint));
  };
  EXPECT_NEAR(held(elbow), -1.5 + 0.3 * (range[2 * elbow + 1] - range[2 * elbow]), 1e-6);
  EXPECT_NEAR(held(knee), range[2 * knee + 1], 1e-9);
}

TEST(ReflexesInWorlds, LeaveLockedJointsAlone) {
  LookingAside infant(55, newborn(bit(Reflex::kTonicNeck)));
  infant.lock(infant.id(mjOBJ_JOINT, "robot:left_elbow"));
  infant.wait({});
  EXPECT_EQ(infant.control("left_elbow"), 0);
  EXPECT_NEAR(infant.control("left_knee"), 0.3, 1e-9);
  infant.world().physics().release(engine::find_lock(infant.model(), infant.id(mjOBJ_JOINT, "robot:left_elbow")));
  infant.step();
  EXPECT_NEAR(infant.control("left_elbow"), 0.3 * 0.83, 1e-9);
}

// Held, nothing; let go, it falls, and what the otoliths feel goes from 1 g to none at once. Arms open, then close.
TEST(ReflexesInWorlds, AFallThrowsTheArmsOpen) {
  Hanging infant("mitten", newborn(bit(Reflex::kMoro)), 1, true);
  infant.lock_all();
  // The weld that holds it gives way at first; after half a minute that is forgotten.
  for (int tick = 0; tick < 6400; ++tick) infant.step();
  EXPECT_LT(infant.delay("moro/left"), 0) << "while it is held";
  for (const body::Joint& joint : infant.world().agents()[0].body.joints) {
    if (const int lock = engine::find_lock(infant.model(), joint.id); lock >= 0) infant.world().physics().release(lock);
  }
  infant.world().physics().release(infant.id(mjOBJ_EQUALITY, "hold"));
  const double after = infant.delay("moro/left");
  // Filters take up to 0.03 s, nerves 10 ms there and back, the brain stem 25 ms.
  EXPECT_GE(after, 0.035);
  EXPECT_LT(after, 0.08);
  EXPECT_GT(infant.now("moro/right"), 0);
  double opened = 0, closed = 0;
  for (int tick = 0; tick < 400; ++tick) {
    infant.step();
    opened = std::max(opened, infant.control("left_shoulder_abduction"));
    closed = std::min(closed, infant.control("left_elbow"));
    EXPECT_EQ(infant.control("left_elbow"), infant.control("right_elbow"));
    EXPECT_TRUE(tick >= 60 || infant.control("left_elbow") >= 0);
  }
  EXPECT_NEAR(opened, 0.4, 1e-6);
  EXPECT_NEAR(closed, -0.4, 1e-6);
}

// The head turned back fast, as if it dropped.
TEST(ReflexesInWorlds, StartWhenTheHeadDropsBack) {
  for (const bool fast : {true, false}) {
    Hanging infant("mitten", newborn(bit(Reflex::kMoro)));
    const int dof = infant.model().jnt_dofadr[infant.id(mjOBJ_JOINT, "robot:head_tilt")];
    double most = 0;
    for (int tick = 0; tick < 60; ++tick) {
      if (tick < 4) infant.data().qvel[dof] = fast ? -4 : 0.1;
      infant.step();
      most = std::max(most, infant.now("moro/left"));
    }
    EXPECT_EQ(most > 0, fast);
  }
}

// The same bytes whatever a step is.
TEST(ReflexesInWorlds, DoNotDependOnFrameSkip) {
  const auto state = [](int frame_skip) {
    LookingAside infant(55, newborn(bit(Reflex::kTonicNeck) | bit(Reflex::kMoro)), frame_skip);
    infant.wait({}, 0.6);
    return std::pair(std::vector<double>(infant.data().qpos, infant.data().qpos + infant.model().nq),
                     infant.now(kNeck + std::string("/left")));
  };
  const auto one = state(1);
  EXPECT_EQ(state(2), one);
  EXPECT_EQ(state(5), one);
}

Bytes physical(env::World& world) {
  Bytes bytes(4096 * 16);
  ByteWriter to{Span<std::uint8_t>(bytes)};
  world.physics().save(to);
  bytes.resize(to.size());
  return bytes;
}

// Whoever has none, and whoever's are over, move alike to the bit.
TEST(ReflexesInWorlds, ChangeNothingWhenOffOrOutgrown) {
  Hanging none("fingers", newborn(0, 10)), over("fingers", newborn(bit(Reflex::kMoro) | bit(Reflex::kTonicNeck), 10));
  for (int i = 0; i < 200; ++i) {
    const std::vector<float> actions = some_actions(none.world(), i);
    none.world().step(actions, nullptr, {});
    over.world().step(actions, nullptr, {});
  }
  EXPECT_EQ(physical(none.world()), physical(over.world()));
  for (std::size_t i = 0; i < none.world().layout().size(); ++i) {
    EXPECT_EQ(none.world().layout()[i].name.find("reflex"), std::string::npos);
  }
}

// In the middle of one, on its way and with its habituation: what is loaded goes on as if nothing had happened; what
// has no memory of them starts rested, and an episode starts so too.
TEST(ReflexesInWorlds, ContinueFromAState) {
  const env::AgentOptions agent = newborn(bit(Reflex::kTonicNeck) | bit(Reflex::kMoro));
  LookingAside one(55, agent), other(0, agent);
  const std::string label = kNeck + std::string("/left");
  for (const double seconds : {0.02, 0.1, 1.0}) {
    one.wait({}, seconds);
    other.world().load(saved(one.world()));
    for (int i = 0; i < 30; ++i) {
      one.step();
      other.step();
      EXPECT_EQ(one.now(label), other.now(label));
      EXPECT_EQ(physical(one.world()), physical(other.world()));
    }
  }
  ASSERT_GT(one.now(label), 0.99);
  LookingAside blank(55, newborn(0));
  blank.wait({});
  const env::LoadReport report = other.world().load(saved(blank.world()));
  EXPECT_EQ(report.fresh_names, "receptors/reflexes");
  other.step();
  EXPECT_EQ(other.now(label), 0);
  one.world().reset(nullptr, nullptr);
  one.step();
  EXPECT_EQ(one.now(label), 0);
  EXPECT_EQ(one.control("left_elbow"), 0);
}

TEST(ReflexesInWorlds, MittensDoNotGrasp) {
  try {
    Hanging("mitten", newborn(bit(Reflex::kPalmarGrasp)));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kUnsupported);
    EXPECT_NE(std::string(error.what()).find("palmar_grasp"), std::string::npos);
  }
  env::CompiledWorld attached;
  attached.model = hanging("fingers", 1, kBall);
  attached.agents = {newborn(bit(Reflex::kMoro))};
  attached.options = without_renderer();
  EXPECT_THROW(env::Attached(attached, 0), Error) << "the host commands the motors";
  env::AgentOptions all = newborn(header::kReflex & ~MIMO_REFLEX_FELT);
  all.reflexes.where_possible = true;
  Hanging mitten("mitten", all), fingers("fingers", all);
  EXPECT_EQ(mitten.world().layout()[mitten.world().layout().size() - 1].shape[0], reflexes::kReflexes - 1);
  EXPECT_EQ(fingers.world().layout()[fingers.world().layout().size() - 1].shape[0], reflexes::kReflexes);
}

// A rod of 1 cm that lies across the palm, is pressed into it with 0.3 N for half a second, and then pulled with 0.5 N
// for five: how far it is from the palm in the end, m.
double rod_after_a_pull(std::uint32_t reflexes, const Vector3d& pull, double months = 1) {
  Hanging infant("fingers", newborn(reflexes, months), 1, false,
                 "<geom type='capsule' size='.005 .04' mass='.01' friction='1 .005 .0001'/>");
  infant.lock_all();
  for (const body::Joint& joint : infant.world().agents()[0].body.joints) {
    const std::string name = engine::name(infant.model(), engine::Kind::kJoint, joint.id);
    const bool finger = name.find("_hand") == std::string::npos && name.find("robot:left_") == 0 &&
                        (name.find("f_") != std::string::npos || name.find("left_th") != std::string::npos);
    if (finger) infant.world().physics().release(engine::find_lock(infant.model(), joint.id));
  }
  const Touch palm{"left_hand", {0, 0, 0.022}, {0, 1, 0}};
  infant.lay_across(palm, 0.013);
  for (int tick = 0; tick < 1100; ++tick) {
    infant.push_with(palm, tick < 100 ? 0.3 : 0);
    if (tick >= 100) infant.push_with({"left_hand", {}, pull}, -0.5);
    infant.step();
    if (infant.distance("left_hand", "thing") > 0.5) break;  // it is gone
  }
  return infant.distance("left_hand", "thing");
}

TEST(ReflexesInWorlds, AGraspHoldsARod) {
  for (const Vector3d& pull : {Vector3d(0, 0, 1), Vector3d(0, 1, 0)}) {
    EXPECT_LT(rod_after_a_pull(bit(Reflex::kPalmarGrasp), pull), 0.05);
    EXPECT_GT(rod_after_a_pull(0, pull), 0.5);
    EXPECT_GT(rod_after_a_pull(bit(Reflex::kPalmarGrasp), pull, 7), 0.5);
  }
}

// Held upright over a floor that its soles just reach, its trunk bent forward by that many degrees in all.
class OnItsFeet : public Hanging {
 public:
  explicit OnItsFeet(double degrees, bool free_hips = false)
      : Hanging("mitten", newborn(bit(Reflex::kStepping), 0.5), 1, true, kFloor) {
    lock_all();
    for (const char* name : {"robot:hip_bend1", "robot:hip_bend2"}) {
      const int joint = id(mjOBJ_JOINT, name);
      data().qpos[model().jnt_qposadr[joint]] = degrees / 2 * 3.14159265358979323846 / 180;
      lock(joint);
    }
    for (const char* name : {"robot:left_hip1", "robot:right_hip1"}) {
      if (free_hips) world().physics().release(engine::find_lock(model(), id(mjOBJ_JOINT, name)));
    }
    world().physics().forward();
    const body::Extent extent = body::extent(model(), data(), world().agents()[0].body);
    const int floor = model().jnt_qposadr[model().body_jntadr[id(mjOBJ_BODY, "thing")]];
    Eigen::Map<Vector3d>{data().qpos + floor} = Vector3d(0, 0, extent.low - 0.0505);
    Eigen::Map<Vector3d>{data().xfrc_applied + 6 * id(mjOBJ_BODY, "thing")} = Vector3d(0, 0, kWeight + kBorne);
  }
  // Counts how often each leg begins to be lifted, and whether both ever are at once.
  void walk(double seconds) {
    double before[2] = {0, 0};
    for (int tick = 0; tick < std::lround(seconds / kTick); ++tick) {
      step();
      const double lifted[2] = {now("stepping/left"), now("stepping/right")};
      for (int leg : {0, 1}) {
        if (before[leg] == 0 && lifted[leg] > 0) order.push_back(leg);
        before[leg] = lifted[leg];
        least = std::min(least, control(leg == 0 ? "left_hip_flex" : "right_hip_flex"));
      }
      together = together || (lifted[0] > 0 && lifted[1] > 0);
    }
  }
  std::vector<int> order;
  bool together = false;
  double least = 0;

 private:
  // A plate that is pressed up against the soles by 12 N.
  static constexpr double kWeight = 0.5 * 9.81, kBorne = 12;
  static constexpr const char* kFloor = "<geom type='box' size='.3 .3 .05' mass='.5'/>";
};

// Legs take turns as long as the trunk leans forward over feet that bear weight; upright, backward or far forward not.
TEST(ReflexesInWorlds, LegsStepInTurn) {
  OnItsFeet infant(16);
  infant.walk(4);
  ASSERT_GE(infant.order.size(), 5U);
  for (std::size_t i = 1; i < infant.order.size(); ++i) EXPECT_NE(infant.order[i], infant.order[i - 1]);
  EXPECT_FALSE(infant.together);
  EXPECT_EQ(infant.least, 0) << "its hips are locked";
  OnItsFeet loose(16, true);
  loose.walk(0.6);
  EXPECT_NEAR(loose.least, -0.4, 0.01);
  for (const double degrees : {0.0, -10.0}) {
    OnItsFeet still(degrees);
    still.walk(1);
    EXPECT_TRUE(still.order.empty()) << degrees;
  }
}

}  // namespace
}  // namespace mimo::test
