// Reflexes in worlds: what sets each off, which motors it pulls, how they add to what the agent commands.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>

#include "body/nerves.h"
#include "reflexes/table.h"
#include "support/block.h"
#include "support/infants.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;
using reflexes::Reflex;

constexpr double kTick = 0.005;

std::uint32_t bit(Reflex reflex) { return 1U << static_cast<int>(reflex); }

// An infant of that age that hangs on a weld 1 m above the origin, without a floor; and a ball, which flies free.
engine::ModelPtr hanging(const std::string& body, double months) {
  scene::Scene scene(
      from_text("<mujoco><include file='mimo/parts/options.xml'/><worldbody><body name='ball' pos='0 2 1'><freejoint/>"
                "<geom type='sphere' size='.005' mass='.0005'/></body></worldbody>"
                "<equality><weld name='hold' body1='mimo_location' active='true' solref='.01 1' solimp='.9999 .9999 "
                ".001 .5 1'/></equality></mujoco>"));
  const scene::Pose pose{{0, 0, 1}, {1, 0, 0, 0}};
  scene.add_body(body, "", &pose);
  scene.grow("", aged(months));
  return compile(scene);
}

env::AgentOptions newborn(std::uint32_t reflexes, double months = 1) {
  env::AgentOptions options = blind();
  options.touch.force = false;
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
  Hanging(const std::string& body, const env::AgentOptions& agent, int frame_skip = 1, bool gravity = false)
      : world_(hanging(body, agent.growth.age), {agent}, options(frame_skip, gravity)), block_(world_) {
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
  void place_ball(const Touch& touch, double away) {
    const Vector3d at =
        Vector3d(data().xpos + 3 * id(mjOBJ_BODY, touch.body)) + frame(touch) * (touch.point + away * touch.from);
    move_ball(at);
  }
  void push_with(const Touch& touch, double newtons) {
    Eigen::Map<Vector3d>{data().xfrc_applied + 6 * id(mjOBJ_BODY, "ball")} = -newtons * (frame(touch) * touch.from);
  }
  void take_away() {
    move_ball(Vector3d(0, 2, 1));
    push_with({"ball", {}, Vector3d::UnitX()}, 0);
  }

 private:
  Eigen::Matrix3d frame(const Touch& touch) {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data().xmat + 9 * id(mjOBJ_BODY, touch.body));
  }
  void move_ball(const Vector3d& to) {
    const int joint = model().body_jntadr[id(mjOBJ_BODY, "ball")];
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
      place_ball(touch, away);
      world().physics().update_contacts();
      if (data().ncon > 0) return place_ball(touch, away + 0.0002);
    }
    ADD_FAILURE() << "no skin there";
  }
  double pressed() const {
    double sum = 0;
    const mjData& now = const_cast<Touching*>(this)->data();
    const int ball = model().body_geomadr[id(mjOBJ_BODY, "ball")];
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

TEST(ReflexesInWorlds, ATouchGivesOneOfItsSideAfterItsLatency) {
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

TEST(ReflexesInWorlds, OtherPlacesGiveNone) {
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

TEST(ReflexesInWorlds, AreOverAtTheirAge) {
  Touching hand("fingers", Reflex::kPalmarGrasp, 7);
  EXPECT_EQ(hand.press(on_palm(), 1, 0.1).left, 0);
  Touching leg("fingers", Reflex::kWithdrawal, 12);  // 4.6 g there
  EXPECT_EQ(leg.press(on_heel(), 0.04, 0.04).left, 0);
  EXPECT_NEAR(leg.press(on_heel(), 0.06, 0.04).left, 1, 1e-6);
}

TEST(ReflexesInWorlds, AreHabituatedTo) {
  Touching infant("fingers", Reflex::kWithdrawal, 0);
  for (const double expected : {1.0, 0.8, 0.64}) {
    EXPECT_NEAR(infant.press(on_heel(), 0.02, 0.0118, 1).left, expected, 1e-6);
    infant.take_away();
    for (int i = 0; i < 400; ++i) infant.step();
  }
}

}  // namespace
}  // namespace mimo::test
