// What the infant feels of its own body: each field against the numbers it stands for.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <string>

#include "support/block.h"
#include "support/numbers.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using engine::Kind;

env::AgentOptions all_of_proprioception() {
  env::AgentOptions options = blind();
  options.proprioception.wanted |= MIMO_PROPRIOCEPTION_JOINT_TORQUE;
  return options;
}

// A world in the middle of things: the infant lies on the floor and struggles.
class Proprioception : public ::testing::Test {
 protected:
  Proprioception() : world_(benchmark_world(all_of_proprioception())), block_(*world_) {
    for (int step = 0; step < 80; ++step) world_->step(some_actions(*world_, step), block_.data(), {});
    EXPECT_GT(world_->data().ncon, 3);
  }
  const mjModel& model() const { return world_->model(); }
  const mjData& data() const { return world_->data(); }
  const body::Body& body() const { return world_->agents()[0].body; }

  std::unique_ptr<env::World> world_;
  Observation block_;
};

TEST_F(Proprioception, PositionAndVelocityAreTheJoints) {
  const auto position = block_["proprioception/position"];
  const auto velocity = block_["proprioception/velocity"];
  int i = 0;
  for (int joint = 0; joint < model().njnt; ++joint) {
    const std::string name = engine::name(model(), Kind::kJoint, joint);
    if (name.rfind("robot:", 0) != 0) continue;
    EXPECT_EQ(position[static_cast<std::size_t>(i)], static_cast<float>(data().qpos[model().jnt_qposadr[joint]]))
        << name;
    EXPECT_EQ(velocity[static_cast<std::size_t>(i)], static_cast<float>(data().qvel[model().jnt_dofadr[joint]]))
        << name;
    EXPECT_EQ(block_.at("proprioception/position", name), position[static_cast<std::size_t>(i)]);
    ++i;
  }
  EXPECT_EQ(i, 47);
}

TEST_F(Proprioception, TorqueIsTheSensors) {
  const auto torque = block_["proprioception/torque"];
  std::size_t i = 0;
  double largest = 0;
  for (int sensor = 0; sensor < model().nsensor; ++sensor) {
    const std::string name = engine::name(model(), Kind::kSensor, sensor);
    if (name.rfind("proprio:", 0) != 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = data().sensordata[model().sensor_adr[sensor] + axis];
      EXPECT_EQ(torque[i], static_cast<float>(expected)) << name;
      EXPECT_EQ(block_.at("proprioception/torque", name + "/" + "xyz"[axis]), torque[i]);
      largest = std::max(largest, std::abs(expected));
      ++i;
    }
  }
  EXPECT_EQ(i, 63u);
  EXPECT_GT(largest, 0.1);
}

TEST_F(Proprioception, ActuationIsControlAndGearTimesControl) {
  std::vector<float> actions = some_actions(*world_, 0);
  world_->step(actions, block_.data(), {});
  for (int motor = 0; motor < model().nu; ++motor) {
    const std::string name = engine::name(model(), Kind::kActuator, motor);
    const auto i = static_cast<std::size_t>(motor);
    const float low = static_cast<float>(model().actuator_forcerange[2 * motor]);
    const float high = static_cast<float>(model().actuator_forcerange[2 * motor + 1]);
    const float control = std::min(std::max(actions[i], low), high);
    EXPECT_EQ(block_.at("proprioception/control", name), control);
    EXPECT_FLOAT_EQ(block_.at("proprioception/motor_torque", name),
                    static_cast<float>(model().actuator_gear[6 * motor]) * control);
    // What MuJoCo applies at the joint is the same torque.
    const int dof = model().jnt_dofadr[model().actuator_trnid[2 * motor]];
    EXPECT_NEAR(data().qfrc_actuator[dof], block_.at("proprioception/motor_torque", name), 1e-6);
  }
}

// As in the original: u = min(q - (lo + th), (hi - th) - q) / th; the sense is max(0, -u).
TEST_F(Proprioception, LimitIsOneAtTheLimitAndMoreBeyond) {
  for (const double threshold : {0.035, 0.1}) {
    env::AgentOptions options = all_of_proprioception();
    options.proprioception.limit_threshold = threshold;
    const auto world = benchmark_world(options);
    Observation block(*world);
    struct Known {
      double distance;  // inside the limit, in thresholds
      double sense;
    };
    for (const Known known : {Known{0, 1}, {1, 0}, {0.5, 0.5}, {-1, 2}, {-0.25, 1.25}, {1.2, 0}}) {
      for (const bool upper : {false, true}) {
        for (const body::Joint& joint : world->agents()[0].body.joints) {
          const double inside = known.distance * threshold;
          world->physics().data().qpos[joint.qpos] = upper ? joint.high - inside : joint.low + inside;
        }
        world->observe(block.data());
        for (const float value : block["proprioception/limit"]) EXPECT_NEAR(value, known.sense, 1e-5);
      }
    }
  }
}

TEST_F(Proprioception, LimitIsZeroInTheMiddle) {
  for (const body::Joint& joint : body().joints) {
    world_->physics().data().qpos[joint.qpos] = (joint.low + joint.high) / 2;
  }
  world_->observe(block_.data());
  EXPECT_EQ(block_["proprioception/limit"], std::vector<float>(47, 0.f));
}

// A body with one hinge whose torque sensor sits on the axis: the sensor's component along the axis is the torque
// about the joint, whatever motor, spring, damper, limit and contacts do.
TEST_F(Proprioception, JointTorqueIsTheSensorsComponentAlongTheAxis) {
  const char* hinges[][2] = {{"left_elbow", "left_elbow"},     {"right_elbow", "right_elbow"},
                             {"left_knee", "left_knee"},       {"right_knee", "right_knee"},
                             {"left_fingers", "left_fingers"}, {"right_fingers", "right_fingers"},
                             {"left_toes", "left_toes"},       {"right_toes", "right_toes"}};
  for (const auto& [joint_name, sensor_name] : hinges) {
    SCOPED_TRACE(joint_name);
    const int joint = engine::find_or_fail(model(), Kind::kJoint, std::string("robot:") + joint_name);
    const int sensor = engine::find_or_fail(model(), Kind::kSensor, std::string("proprio:") + sensor_name);
    const int site = model().sensor_objid[sensor];
    ASSERT_EQ(model().site_bodyid[site], model().jnt_bodyid[joint]);
    ASSERT_EQ(model().body_jntnum[model().jnt_bodyid[joint]], 1);
    ASSERT_EQ(copy(model().site_pos + 3 * site, 3), copy(model().jnt_pos + 3 * joint, 3));
    ASSERT_EQ(copy(model().site_quat + 4 * site, 4), (std::vector<double>{1, 0, 0, 0}));
    double expected = 0;
    for (int i = 0; i < 3; ++i) {
      expected += model().jnt_axis[3 * joint + i] * data().sensordata[model().sensor_adr[sensor] + i];
    }
    EXPECT_NEAR(block_.at("proprioception/joint_torque", std::string("robot:") + joint_name), expected,
                1e-6 * std::max(1.0, std::abs(expected)));
  }
}

// Statics, without MuJoCo's sensors: an infant held still on its back carries the weight of each limb's far part.
// Torque on the limb = -(sum of (centre of mass - anchor) x m g), along the joint's axis.
TEST(ProprioceptionStatics, JointTorqueCarriesTheWeight) {
  env::World world(held_infant({std::sqrt(0.5), 0, -std::sqrt(0.5), 0}), {all_of_proprioception()}, without_renderer());
  world.physics().step(1500);
  Observation block(world);
  world.observe(block.data());
  const mjModel& m = world.model();
  const mjData& d = world.data();
  double largest = 0;
  for (const body::Joint& joint : world.agents()[0].body.joints) {
    const int body = m.jnt_bodyid[joint.id];
    double moment[3] = {0, 0, 0};
    for (int part = body; part < m.nbody; ++part) {
      int ancestor = part;
      while (ancestor > body) ancestor = m.body_parentid[ancestor];
      if (ancestor != body) continue;
      const double x = d.xipos[3 * part] - d.xanchor[3 * joint.id];
      const double y = d.xipos[3 * part + 1] - d.xanchor[3 * joint.id + 1];
      const double weight = -9.81 * m.body_mass[part];
      moment[0] += y * weight;
      moment[1] -= x * weight;
    }
    const double* axis = d.xaxis + 3 * joint.id;
    const double expected = -(axis[0] * moment[0] + axis[1] * moment[1] + axis[2] * moment[2]);
    EXPECT_NEAR(block.at("proprioception/joint_torque", engine::name(m, Kind::kJoint, joint.id)), expected, 2e-6);
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_GT(largest, 5) << "the trunk weighs on the spine";
}

}  // namespace
}  // namespace mimo::test
