// Recorded trajectories (trajectories_v1.json): a fall, and floating under random control.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "support/recording.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using engine::Jacobian;

engine::PhysicsOptions floating(Jacobian jacobian) {
  engine::PhysicsOptions options;
  options.jacobian = jacobian;
  options.contacts = false;
  options.gravity = false;
  return options;
}

engine::PhysicsOptions falling(Jacobian jacobian) {
  engine::PhysicsOptions options;
  options.jacobian = jacobian;
  return options;
}

// Actions for each step, in the order of the model's actuators; none for a passive body.
using Controls = std::vector<std::vector<double>>;

Controls recorded_controls(const mjModel& model) {
  const Table table(std::string(MIMO_TEST_DATA) + "/controls_v1.csv");
  EXPECT_EQ(static_cast<int>(table.columns().size()), model.nu);
  Controls controls;
  for (const Table::Row& row : table.rows()) {
    controls.emplace_back();
    for (int id = 0; id < model.nu; ++id) {
      controls.back().push_back(row.number(engine::name(model, engine::Kind::kActuator, id)));
    }
  }
  return controls;
}

void expect_trajectory(const Json& states, engine::Physics& physics, const Controls& controls, int last_step,
                       const Tolerance& tolerance = {}) {
  int step = 0;
  for (const Json& state : states) {
    const int until = state.at("step");
    if (until > last_step) break;
    for (; step < until; ++step) {
      if (!controls.empty()) {
        const std::vector<double>& row = controls.at(static_cast<std::size_t>(step));
        std::copy(row.begin(), row.end(), physics.data().ctrl);
      }
      physics.step(1);
    }
    SCOPED_TRACE("step " + std::to_string(step));
    expect_positions(physics.model(), state.at("qpos"), physics.data().qpos, tolerance);
    expect_dofs("velocity", physics.model(), state.at("qvel"), physics.data().qvel, tolerance);
    EXPECT_EQ(state.at("ncon"), physics.data().ncon);
  }
  EXPECT_EQ(step, last_step);
}

// With a dense Jacobian, as the original solves, every state agrees; the last ones lie deep in the contacts.
TEST(GoldenTrajectories, PassiveFallDense) {
  engine::Physics physics(benchmark_model(), falling(Jacobian::kDense));
  expect_trajectory(read_json("trajectories_v1.json").at("passive_fall"), physics, {}, 200);
}

// The sparse solution differs by rounding, which contacts amplify: compared up to step 120. Velocities near zero agree
// to 3e-11, hence the larger floor.
TEST(GoldenTrajectories, PassiveFallSparse) {
  engine::Physics physics(benchmark_model(), falling(Jacobian::kSparse));
  expect_trajectory(read_json("trajectories_v1.json").at("passive_fall"), physics, {}, 120, {kRelative, 1e-10});
}

TEST(GoldenTrajectories, FloatingDense) {
  engine::Physics physics(benchmark_model(), floating(Jacobian::kDense));
  expect_trajectory(read_json("trajectories_v1.json").at("floating_no_contact_no_gravity_random_control"), physics,
                    recorded_controls(physics.model()), 200);
}

TEST(GoldenTrajectories, FloatingSparse) {
  engine::Physics physics(benchmark_model(), floating(Jacobian::kSparse));
  expect_trajectory(read_json("trajectories_v1.json").at("floating_no_contact_no_gravity_random_control"), physics,
                    recorded_controls(physics.model()), 200);
}

}  // namespace
}  // namespace mimo::test
