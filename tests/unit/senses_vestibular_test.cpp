// The sense of balance, in the head's frame.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/block.h"
#include "support/numbers.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

std::vector<double> wide(const std::vector<float>& values) { return {values.begin(), values.end()}; }

// Held still, the accelerometer shows the reaction to gravity: 9.81 m/s^2 along what is up, in the head's frame.
TEST(Vestibular, AtRestShowsUp) {
  const double half = std::sqrt(0.5);
  for (const std::array<double, 4>& quat :
       {std::array<double, 4>{1, 0, 0, 0}, {half, 0, -half, 0}, {half, half, 0, 0}, {0, 0, 1, 0}}) {
    env::World world(held_infant(quat), {blind()}, without_renderer());
    world.physics().step(1500);
    Observation block(world);
    world.observe(block.data());
    const double* head = world.data().xmat + 9 * world.agents()[0].body.head;
    const std::vector<double> up = {9.81 * head[6], 9.81 * head[7], 9.81 * head[8]};  // the world's z in the head
    EXPECT_TRUE(close(up, wide(block["vestibular/acceleration"]).data(), {0, 2e-4}));
    EXPECT_TRUE(close({0, 0, 0}, wide(block["vestibular/angular_velocity"]).data(), {0, 1e-9}));
  }
}

// Pushes each part of the infant with its mass times an acceleration, so that the body moves as one.
void push(env::World& world, const Eigen::Vector3d& acceleration) {
  const mjModel& model = world.model();
  const int root = model.body_rootid[world.agents()[0].body.head];
  for (int body = 0; body < model.nbody; ++body) {
    if (model.body_rootid[body] != root) continue;
    Eigen::Map<Eigen::Vector3d>(world.physics().data().xfrc_applied + 6 * body) = model.body_mass[body] * acceleration;
  }
}

// In free fall there is nothing to feel but what springs and limits move the head by. A push of the whole body comes on
// top, as seen from the head.
TEST(Vestibular, FreeFallFeelsNothingButAPush) {
  const auto world = benchmark_world();
  Observation block(*world);
  world->reset(nullptr, block.data());
  const std::vector<double> falling = wide(block["vestibular/acceleration"]);
  EXPECT_LT(std::abs(falling[2]), 0.5);

  const Eigen::Vector3d acceleration(1.5, -2, 3);
  push(*world, acceleration);
  world->observe(block.data());
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Map<const Rows> head(world->data().xmat + 9 * world->agents()[0].body.head);
  Eigen::Vector3d felt = head.transpose() * acceleration;
  felt += Eigen::Map<const Eigen::Vector3d>(falling.data());
  EXPECT_TRUE(close({felt[0], felt[1], felt[2]}, wide(block["vestibular/acceleration"]).data(), {0, 1e-5}));
}

// The infant turns as a whole: the head turns with it. At qpos0 all frames are the world's.
TEST(Vestibular, TurningIsFelt) {
  env::EnvOptions floating = without_renderer();
  floating.physics.gravity = floating.physics.contacts = false;
  const auto world = benchmark_world(blind(), floating);
  const mjModel& model = world->model();
  const int root = engine::find_or_fail(model, engine::Kind::kJoint, "mimo_orientation");
  const std::vector<double> turning = {0.5, -1.25, 2};
  std::copy(turning.begin(), turning.end(), world->physics().data().qvel + model.jnt_dofadr[root] + 3);
  Observation block(*world);
  world->observe(block.data());
  EXPECT_TRUE(close(turning, wide(block["vestibular/angular_velocity"]).data(), {1e-6, 1e-6}));
}

}  // namespace
}  // namespace mimo::test
