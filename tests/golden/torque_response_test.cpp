// One motor at a time at full strength for ten steps, without gravity and contacts (torque_response_*.json).
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "support/recording.h"

namespace mimo::test {
namespace {

using engine::Kind;

// On MuJoCo 4 our solver, which serves sparse Jacobians, ends elsewhere than MuJoCo's: that is itself up to 3.5e-6 away
// from where a tolerance of 1e-16 leads in these ten steps (record.py, run with both).
Tolerance tolerance_of(engine::Jacobian jacobian) {
  return {kRelative, MIMO_MUJOCO_4 && jacobian == engine::Jacobian::kSparse ? 4e-6 : kFloor};
}

void expect_response(engine::Physics& physics, const std::string& actuator, double control, const Json& recorded,
                     const Tolerance& tolerance) {
  SCOPED_TRACE(actuator + (control > 0 ? " plus" : " minus"));
  const mjModel& model = physics.model();
  const mjData& data = physics.data();
  const int motor = engine::find_or_fail(model, Kind::kActuator, actuator);
  physics.reset();
  physics.data().ctrl[motor] = control;  // cut by the motor's force range
  physics.step(10);
  const int joint = engine::find_or_fail(model, Kind::kJoint, recorded.at("joint"));
  EXPECT_TRUE(close(recorded.at("qpos").get<double>(), data.qpos[model.jnt_qposadr[joint]], tolerance));
  EXPECT_TRUE(close(recorded.at("qvel").get<double>(), data.qvel[model.jnt_dofadr[joint]], tolerance));
  EXPECT_TRUE(close(recorded.at("torque").get<double>(), data.qfrc_actuator[model.jnt_dofadr[joint]], tolerance));
  expect_dofs("velocity", model, recorded.at("all_qvel"), data.qvel, tolerance);
}

struct Recording {
  const char* body;
  const char* file;
  std::size_t motors;
};
constexpr Recording kMitten = {"mitten", "torque_response_v1.json", 22};
constexpr Recording kFingers = {"fingers", "torque_response_v2.json", 44};

void expect_all_responses(const Recording& recording, engine::Jacobian jacobian) {
  const Json responses = recorded_motion(recording.file);
  ASSERT_EQ(responses.size(), recording.motors);
  engine::PhysicsOptions options;
  options.jacobian = jacobian;
  options.contacts = false;
  options.gravity = false;
  engine::Physics physics(benchmark_model(recording.body), options);
  for (const auto& [actuator, response] : responses.items()) {
    expect_response(physics, actuator, 1, response.at("plus"), tolerance_of(jacobian));
    expect_response(physics, actuator, -1, response.at("minus"), tolerance_of(jacobian));
  }
}

TEST(GoldenTorqueResponse, MittenDense) { expect_all_responses(kMitten, engine::Jacobian::kDense); }
TEST(GoldenTorqueResponse, MittenSparse) { expect_all_responses(kMitten, engine::Jacobian::kSparse); }
TEST(GoldenTorqueResponse, FingersDense) { expect_all_responses(kFingers, engine::Jacobian::kDense); }
TEST(GoldenTorqueResponse, FingersSparse) { expect_all_responses(kFingers, engine::Jacobian::kSparse); }

}  // namespace
}  // namespace mimo::test
