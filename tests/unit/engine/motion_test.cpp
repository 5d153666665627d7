// What places on bodies feel, against MuJoCo's own accelerometers and gyroscopes.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "engine/physics.h"
#include "engine/present.h"
#include "support/numbers.h"

namespace mimo::test {
namespace {

using engine::Kind;

// A tree of every joint type, one body with three hinges of which two share an axis, damped and driven; a site with
// sensors on each body.
constexpr const char* kTree = R"(
<mujoco>
  <option timestep="0.002" integrator="INTEGRATOR"/>
  <default><joint damping="0.02" armature="0.001"/><geom size="0.05"/></default>
  <worldbody>
    <geom type="plane" size="0 0 1"/>
    <body name="a" pos="0 0 0.5">
      <freejoint/><geom type="box" size="0.1 0.08 0.05"/><site name="a" pos="0.03 0.02 0.01" euler="10 20 30"/>
      <body name="b" pos="0.15 0 0">
        <joint type="ball"/><geom/><site name="b" pos="0 0.05 0" euler="0 40 0"/>
        <body name="c" pos="0.15 0 0">
          <joint type="hinge" axis="1 0 0"/><joint type="hinge" axis="0 1 0"/><joint type="hinge" axis="0 1 0"/>
          <geom/><site name="c" pos="0.02 0 0.03"/>
          <body name="d" pos="0 0.2 0">
            <joint type="slide" axis="0 0 1" range="-0.2 0.2" limited="true"/><geom/><site name="d" euler="90 0 0"/>
            <body name="e" pos="0 0.1 0"><geom/><site name="e" pos="0.1 0 0"/></body>
          </body>
        </body>
      </body>
    </body>
  </worldbody>
  <sensor>
    <accelerometer site="a"/><gyro site="a"/><accelerometer site="b"/><gyro site="b"/><accelerometer site="c"/><gyro site="c"/>
    <accelerometer site="d"/><gyro site="d"/><accelerometer site="e"/><gyro site="e"/>
  </sensor>
</mujoco>)";

std::string tree(const std::string& integrator) {
  std::string text = kTree;
  return text.replace(text.find("INTEGRATOR"), 10, integrator);
}

void expect_same(const mjModel& model, const mjData& data, double tolerance) {
  for (int site = 0; site < model.nsite; ++site) {
    const engine::Motion motion = engine::motion_of(model, data, {Kind::kSite, site});
    const double* sensors = data.sensordata + 6 * site;
    EXPECT_TRUE(close({sensors, sensors + 3}, motion.acceleration.data(), {tolerance, tolerance})) << "site " << site;
    EXPECT_TRUE(close({sensors + 3, sensors + 6}, motion.angular_velocity.data(), {1e-12, 1e-12})) << "site " << site;
    // The same place, seen from the body's own frame.
    using Rows = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
    const int body = model.site_bodyid[site];
    const engine::Motion of_body = engine::motion_of(model, data, {Kind::kBody, body});
    const Eigen::Vector3d there = engine::acceleration_at(of_body, Eigen::Vector3d(model.site_pos + 3 * site));
    const Eigen::Vector3d same = Rows(data.site_xmat + 9 * site).transpose() * (Rows(data.xmat + 9 * body) * there);
    EXPECT_TRUE(close({sensors, sensors + 3}, same.data(), {1e-9 + tolerance, 1e-9 + tolerance})) << "site " << site;
  }
}

void push(engine::Physics& physics, int step) {
  for (int dof = 0; dof < physics.model().nv; ++dof) {
    physics.data().qfrc_applied[dof] = 0.3 * std::sin(0.7 * step + 1.3 * dof);
  }
}

// The positions and velocities of a step's end are there already, its accelerations are of the start.
TEST(Motion, AgreesWithSensorsAfterSteps) {
  engine::Physics physics(engine::compile(tree("Euler"), {}, {}), {});
  for (int step = 0; step < 400; ++step) {
    push(physics, step);
    physics.step(1);
    expect_same(physics.model(), physics.data(), 1e-8);
  }
}

TEST(Motion, AgreesWithSensorsOfTheStateAsItIs) {
  engine::Physics physics(engine::compile(tree("RK4"), {}, {}), {});
  for (int step = 0; step < 50; ++step) {
    push(physics, step);
    physics.step(4);
    physics.forward();
    expect_same(physics.model(), physics.data(), 1e-8);
  }
}

TEST(Motion, MeasuresNothingAtRestWithoutGravity) {
  engine::PhysicsOptions weightless;
  weightless.gravity = false;
  engine::Physics physics(engine::compile(tree("Euler"), {}, {}), weightless);
  physics.step(10);
  const engine::Motion motion = engine::motion_of(physics.model(), physics.data(), {Kind::kSite, 0});
  EXPECT_TRUE(close({0, 0, 0}, motion.acceleration.data(), {1e-12, 1e-12}));
  expect_same(physics.model(), physics.data(), 1e-12);
}

// A body's own frame is what a site in its origin would be.
TEST(Motion, MeasuresBodiesLikeSites) {
  std::string text = tree("Euler");
  text.replace(text.find("pos=\"0.02 0 0.03\""), 17, "pos=\"0 0 0\"      ");
  engine::Physics physics(engine::compile(text, {}, {}), {});
  push(physics, 3);
  physics.step(30);
  const mjModel& model = physics.model();
  const engine::Motion site = engine::motion_of(model, physics.data(), {Kind::kSite, 2});
  const engine::Motion body =
      engine::motion_of(model, physics.data(), {Kind::kBody, engine::find_or_fail(model, Kind::kBody, "c")});
  EXPECT_EQ(site.acceleration, body.acceleration);
  EXPECT_EQ(site.angular_velocity, body.angular_velocity);
}

}  // namespace
}  // namespace mimo::test
