// One motor at a time at full strength for ten steps, without gravity and contacts (torque_response_v1.json).
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "support/recording.h"

namespace mimo::test {
namespace {

using engine::Kind;

void expect_response(engine::Physics& physics, const std::string& actuator, double control, const Json& recorded) {
  SCOPED_TRACE(actuator + (control > 0 ? " plus" : " minus"));
  const mjModel& model = physics.model();
  const mjData& data = physics.data();
  const int motor = engine::find_or_fail(model, Kind::kActuator, actuator);
  physics.reset();
  physics.data().ctrl[motor] = control;  // cut by the motor's force range
  physics.step(10);
  const int joint = engine::find_or_fail(model, Kind::kJoint, recorded.at("joint"));
  EXPECT_TRUE(close(recorded.at("qpos").get<double>(), data.qpos[model.jnt_qposadr[joint]]));
  EXPECT_TRUE(close(recorded.at("qvel").get<double>(), data.qvel[model.jnt_dofadr[joint]]));
  EXPECT_TRUE(close(recorded.at("torque").get<double>(), data.qfrc_actuator[model.jnt_dofadr[joint]]));
  expect_dofs("velocity", model, recorded.at("all_qvel"), data.qvel);
}

void expect_all_responses(engine::Jacobian jacobian) {
  const Json responses = read_json("torque_response_v1.json");
  ASSERT_EQ(responses.size(), 22u);
  engine::PhysicsOptions options;
  options.jacobian = jacobian;
  options.contacts = false;
  options.gravity = false;
  engine::Physics physics(benchmark_model(), options);
  for (const auto& [actuator, response] : responses.items()) {
    expect_response(physics, actuator, 1, response.at("plus"));
    expect_response(physics, actuator, -1, response.at("minus"));
  }
}

TEST(GoldenTorqueResponse, Dense) { expect_all_responses(engine::Jacobian::kDense); }
TEST(GoldenTorqueResponse, Sparse) { expect_all_responses(engine::Jacobian::kSparse); }

}  // namespace
}  // namespace mimo::test
