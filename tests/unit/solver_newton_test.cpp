// Our solver against MuJoCo's own: what is expected of newton_step is what mj_step gives from the same state.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <utility>

#include "base/random.h"
#include "compat/mujoco.h"
#include "solver/newton.h"
#include "support/random_model.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;

std::vector<double> copied(const double* values, int count) { return {values, values + count}; }

#if MIMO_MUJOCO_4

// MuJoCo 4 searches along lines otherwise and so comes to the least cost by other steps: each solver ends somewhere
// within its tolerance of 1e-10. How far that may be from the least its own solution shows, compared with one that it
// goes on with to 1e-16: ours is to be no farther, over all steps. A step that the number of iterations cuts short is
// nowhere near, and is not compared.
struct Distances {
  double ours = 0, theirs = 0;
  void add(const double* least, const double* our, const double* their, int count) {
    for (int i = 0; i < count; ++i) {
      ours = std::max(ours, std::abs(our[i] - least[i]) / (1 + std::abs(least[i])));
      theirs = std::max(theirs, std::abs(their[i] - least[i]) / (1 + std::abs(least[i])));
    }
  }
};

int compare(const mjModel& shared, int steps) {
  mjModel model = shared;
  compat::leave_out_islands(model.opt);
  mjModel patient = model;
  patient.opt.tolerance = 1e-16;
  patient.opt.ls_tolerance = 1e-8;
  patient.opt.iterations = 200;
  const Data theirs(mj_makeData(&model)), ours(mj_makeData(&model)), least(mj_makeData(&model));
  const bool cut_short = model.opt.iterations < 10;
  Random random(1);
  Distances velocity, acceleration, force, joint_force, sensor;
  int most = 0;
  for (int step = 0; step < steps; ++step) {
    for (int i = 0; i < model.nu; ++i) theirs->ctrl[i] = random.uniform(-1, 1);
    for (const Data* data : {&ours, &least}) mj_copyData(data->get(), &model, theirs.get());
    mj_step(&model, theirs.get());
    mj_step(&patient, least.get());
    solver::newton_step(&model, ours.get());
    EXPECT_EQ(ours->nefc, theirs->nefc);
    EXPECT_EQ(ours->time, theirs->time);
    EXPECT_EQ(ours->pstack, 0);
    velocity.add(least->qvel, ours->qvel, theirs->qvel, model.nv);
    acceleration.add(least->qacc_warmstart, ours->qacc_warmstart, theirs->qacc_warmstart, model.nv);
    force.add(least->efc_force, ours->efc_force, theirs->efc_force, theirs->nefc);
    joint_force.add(least->qfrc_constraint, ours->qfrc_constraint, theirs->qfrc_constraint, model.nv);
    sensor.add(least->sensordata, ours->sensordata, theirs->sensordata, model.nsensordata);
    most = std::max(most, static_cast<int>(theirs->nefc));
  }
  const std::pair<const char*, Distances> all[] = {{"velocity", velocity},
                                                   {"acceleration", acceleration},
                                                   {"force", force},
                                                   {"joint force", joint_force},
                                                   {"sensor", sensor}};
  for (const auto& [what, distances] : all) {
    if (cut_short) continue;
    EXPECT_LE(distances.ours, std::max(1e-9, distances.theirs)) << what;
  }
  return most;
}

#else

// Both solvers stop when another step would gain less than 1e-10 of the cost. They come there by the same steps, so
// that what remains is rounding.
void expect_near(const double* expected, const double* actual, int count, double tolerance, const std::string& what) {
  for (int i = 0; i < count; ++i) {
    ASSERT_NEAR(actual[i], expected[i], tolerance * (1 + std::abs(expected[i]))) << what << " " << i;
  }
}

// Steps under changing commands; each is taken twice from the same state. Returns the most constraints at a time.
int compare(const mjModel& model, int steps) {
  const Data theirs(mj_makeData(&model)), ours(mj_makeData(&model));
  Random random(1);
  int most = 0;
  for (int step = 0; step < steps && !::testing::Test::HasFatalFailure(); ++step) {
    for (int i = 0; i < model.nu; ++i) theirs->ctrl[i] = random.uniform(-1, 1);
    mj_copyData(ours.get(), &model, theirs.get());
    mj_step(&model, theirs.get());
    solver::newton_step(&model, ours.get());
    const std::string when = " after step " + std::to_string(step) + ", number";
    EXPECT_EQ(compat::iterations(*ours), compat::iterations(*theirs)) << when;
    EXPECT_EQ(ours->nefc, theirs->nefc) << when;
    EXPECT_EQ(ours->time, theirs->time);
    expect_near(theirs->qpos, ours->qpos, model.nq, 1e-11, "position" + when);
    expect_near(theirs->qvel, ours->qvel, model.nv, 1e-10, "velocity" + when);
    expect_near(theirs->qacc_warmstart, ours->qacc_warmstart, model.nv, 1e-8, "acceleration" + when);
    expect_near(theirs->efc_force, ours->efc_force, theirs->nefc, 1e-8, "force" + when);
    expect_near(theirs->qfrc_constraint, ours->qfrc_constraint, model.nv, 1e-8, "joint force" + when);
    expect_near(theirs->sensordata, ours->sensordata, model.nsensordata, 1e-8, "sensor" + when);
    EXPECT_EQ(ours->pstack, 0);
    most = std::max(most, theirs->nefc);
  }
  return most;
}

#endif

TEST(EngineNewton, MovesTheMittenBodyAsMujoco) { EXPECT_GT(compare(*benchmark_model(), 400), 100); }

TEST(EngineNewton, MovesFiveFingersAsMujoco) {
  EXPECT_GT(compare(*room_with_infant("benchmark", "fingers"), 250), 150);
}

// Everything that MuJoCo knows as a constraint, in one small model that never comes to rest.
constexpr char kZoo[] = R"(<mujoco>
  <option timestep="0.005" cone="CONE" jacobian="sparse" solver="Newton" iterations="ITERATIONS" tolerance="1e-10">
    <flag energy="enable" warmstart="WARM"/>
  </option>
  <worldbody>
    <geom type="plane" size="5 5 1" friction="0.6"/>
    <body name="a" pos="0 0 0.3"><freejoint/><geom type="box" size="0.1 0.1 0.1" condim="6"/>
      <body name="b" pos="0.2 0 0"><joint name="b" axis="0 1 0" limited="true" range="-20 20" frictionloss="0.3"/>
        <geom type="capsule" fromto="0 0 0 0.2 0 0" size="0.04" condim="4"/>
        <body name="c" pos="0.25 0 0"><joint name="c" axis="0 0 1" frictionloss="0.1"/>
          <geom type="sphere" size="0.05" condim="1"/><site name="tip"/></body>
      </body>
    </body>
    <body name="ball" pos="0 0.05 0.7"><joint type="ball" name="ball" limited="true" range="0 30"/>
      <geom type="capsule" fromto="0 0 0 0 0 0.3" size="0.03"/></body>
    <body name="welded" pos="1 0 0.5"><freejoint/><geom size="0.05"/></body>
    <body name="hung" pos="-1 0 0.5"><freejoint/><geom size="0.05"/></body>
    <body name="slider" pos="0 1 0.2"><joint type="slide" name="slide" axis="1 0 0"/><geom size="0.05"/></body>
  </worldbody>
  <tendon><fixed name="sum" limited="true" range="-0.2 0.2" frictionloss="0.05"><joint joint="c" coef="1"/><joint joint="b" coef="1"/></fixed></tendon>
  <equality>
    <weld body1="welded"/>
    <connect body1="hung" anchor="0 0 0.2"/>
    <joint joint1="slide" joint2="c" polycoef="0 0.2 0 0 0"/>
  </equality>
  <actuator><motor joint="b" gear="3"/><motor joint="c" gear="1"/><motor joint="slide" gear="2"/></actuator>
  <sensor><accelerometer site="tip"/><force site="tip"/></sensor>
</mujoco>)";

class EngineNewtonZoo : public ::testing::TestWithParam<std::tuple<const char*, const char*, const char*>> {};

TEST_P(EngineNewtonZoo, EveryConstraintEqualsMujocos) {
  std::string xml = kZoo;
  const auto put = [&](const std::string& name, const char* value) { xml.replace(xml.find(name), name.size(), value); };
  put("CONE", std::get<0>(GetParam()));
  put("WARM", std::get<1>(GetParam()));
  put("ITERATIONS", std::get<2>(GetParam()));
  const engine::ModelPtr model = engine::compile(xml, {}, {});
  ASSERT_TRUE(solver::newton_step_serves(*model));
  EXPECT_GT(compare(*model, 600), 40);
}

INSTANTIATE_TEST_SUITE_P(Each, EngineNewtonZoo,
                         ::testing::Combine(::testing::Values("elliptic", "pyramidal"),
                                            ::testing::Values("enable", "disable"), ::testing::Values("50", "2")));

// Heaps of shapes of all kinds on chains of joints: contacts of all dimensions, bodies that no contact reaches.
TEST(EngineNewton, MovesRandomModelsAsMujoco) {
  Random random(1);
  int most = 0;
  for (int i = 0; i < 20 && !HasFatalFailure(); ++i) {
    SCOPED_TRACE(format("model {}", i));
    const engine::ModelPtr model = engine::compile(
        random_model(random, "timestep='0.002' cone='elliptic' jacobian='sparse' solver='Newton'"), {}, {});
    ASSERT_TRUE(solver::newton_step_serves(*model));
    most = std::max(most, compare(*model, 60));
  }
  EXPECT_GT(most, 60);
}

// A ball that bounces: steps with a contact and steps without any constraint.
TEST(EngineNewton, LeavesNoForceWhereConstraintsEnded) {
  const engine::ModelPtr model = engine::compile(
      "<mujoco><option timestep='0.005' jacobian='sparse'/><worldbody><geom type='plane' size='1 1 1' solref='-5000 "
      "0'/>"
      "<body pos='0 0 0.12'><freejoint/><geom size='0.1'/></body></worldbody></mujoco>",
      {}, {});
  const Data data(mj_makeData(model.get()));
  int touching = 0, flying_again = 0;
  for (int step = 0; step < 200; ++step) {
    solver::newton_step(model.get(), data.get());
    if (data->nefc > 0) ++touching;
    if (data->nefc > 0 || touching == 0) continue;
    ++flying_again;
    EXPECT_EQ(copied(data->qfrc_constraint, model->nv), std::vector<double>(6)) << step;
  }
  EXPECT_GT(touching, 0);
  EXPECT_GT(flying_again, 10);
}

// A contact of three dimensions on a line, alone. Where the least is, its cost tells: MuJoCo's for an elliptic cone.
class EngineLineSearch : public ::testing::Test {
 protected:
  EngineLineSearch() {
    contact_.dim = 3;
    contact_.mu = contact_.friction[0] = contact_.friction[1] = 0.51;
    compat::give_stack(data_, stack_, kRoom);
    data_.contact = &contact_;
    data_.ncon = 1;
    data_.nefc = 3;
    data_.efc_type = type_;
    data_.efc_id = id_;
    data_.efc_D = stiffness_;
  }

  // Cost of the contact and of the part without constraints.
  double cost(const solver::Line& line, double at) const {
    const auto value = [&](int i) { return line.start[i] + at * line.direction[i]; };
    const double mu = contact_.mu, normal = mu * value(0), tangent = mu * std::hypot(value(1), value(2));
    const double rest = at * (line.slope + 0.5 * at * line.curvature);
    if (normal >= mu * tangent) return rest;
    if (mu * normal + tangent <= 0) {
      return rest + 0.5 * (value(0) * value(0) + value(1) * value(1) + value(2) * value(2));
    }
    const double across = normal - mu * tangent;
    return rest + 0.5 * across * across / (mu * mu * (1 + mu * mu));
  }

  static constexpr int kRoom = 256;
  mjData data_{};
  mjContact contact_{};
  mjtNum stack_[kRoom], stiffness_[3] = {1, 1, 1};
  int type_[3] = {mjCNSTR_CONTACT_ELLIPTIC, mjCNSTR_CONTACT_ELLIPTIC, mjCNSTR_CONTACT_ELLIPTIC}, id_[3] = {};
};

// Newton's steps alone go from 0.26 to 1.66 and back here.
TEST_F(EngineLineSearch, DoesNotBounceInACone) {
  const double start[] = {-4, 8, 3}, direction[] = {-2, -8, -6};
  const solver::Line line = {start, direction, -1.2, 1.06};
  const double at = solver::find_least(data_, line, 1e-9);
  EXPECT_GT(at, 0);
  EXPECT_LT(cost(line, at), cost(line, 0));
  EXPECT_LE(cost(line, at), cost(line, at - 1e-4));
  EXPECT_LE(cost(line, at), cost(line, at + 1e-4));
}

// Rounding keeps the slope from getting that small: the search ends at the neighbours of the least.
TEST_F(EngineLineSearch, EndsAtTheLimitOfRounding) {
  const double start[] = {-3, 2, 1}, direction[] = {2, -2, 7};
  const solver::Line line = {start, direction, -6.2, 7.87};
  const double at = solver::find_least(data_, line, 0), near = solver::find_least(data_, line, 1e-6);
  EXPECT_NEAR(at, near, 1e-6);
  EXPECT_GT(at, 0);
}

// Where there is nothing to solve, all else that a step does must be the same to the bit.
TEST(EngineNewton, IsMujocosStepWithoutConstraints) {
  const engine::ModelPtr shared = benchmark_model();
  mjModel model = *shared;
  model.opt.disableflags |= mjDSBL_CONSTRAINT;
  model.opt.enableflags |= mjENBL_ENERGY;
  const Data theirs(mj_makeData(&model)), ours(mj_makeData(&model));
  Random random(1);
  for (int step = 0; step < 50; ++step) {
    for (int i = 0; i < model.nu; ++i) theirs->ctrl[i] = ours->ctrl[i] = random.uniform(-1, 1);
    mj_step(&model, theirs.get());
    solver::newton_step(&model, ours.get());
    ASSERT_EQ(copied(ours->qpos, model.nq), copied(theirs->qpos, model.nq)) << step;
    ASSERT_EQ(copied(ours->qvel, model.nv), copied(theirs->qvel, model.nv)) << step;
    ASSERT_EQ(copied(ours->sensordata, model.nsensordata), copied(theirs->sensordata, model.nsensordata)) << step;
    ASSERT_EQ(copied(ours->cfrc_int, 6 * model.nbody), copied(theirs->cfrc_int, 6 * model.nbody)) << step;
    ASSERT_EQ(copied(ours->energy, 2), copied(theirs->energy, 2)) << step;
  }
}

TEST(EngineNewton, LeavesOtherSettingsToMujoco) {
  const auto serves = [](auto&& change) {
    mjModel model = *benchmark_model();
    change(model.opt);
    return solver::newton_step_serves(model);
  };
  EXPECT_TRUE(serves([](mjOption&) {}));
  EXPECT_FALSE(serves([](mjOption& opt) { opt.jacobian = mjJAC_DENSE; }));
  EXPECT_FALSE(serves([](mjOption& opt) { opt.solver = mjSOL_CG; }));
  EXPECT_FALSE(serves([](mjOption& opt) { opt.integrator = mjINT_RK4; }));
  EXPECT_FALSE(serves([](mjOption& opt) { opt.noslip_iterations = 3; }));
  EXPECT_FALSE(serves([](mjOption& opt) { opt.enableflags |= mjENBL_FWDINV; }));
}

// To the bit, so that a host that calls mj_step itself gets what a world gives.
TEST(EngineNewton, OnRequestStepsAreMujocos) {
  const auto steps = [](const engine::PhysicsOptions& options) {
    engine::Physics physics(benchmark_model(), options);
    return trajectory(physics, 200);
  };
  engine::PhysicsOptions mujocos;
  mujocos.own_solver = false;
  const engine::ModelPtr model = benchmark_model();
  const Data data(mj_makeData(model.get()));
  std::vector<double> expected;
  for (int i = 0; i < 200; ++i) {
    mj_step(model.get(), data.get());
    expected.insert(expected.end(), data->qpos, data->qpos + model->nq);
    expected.insert(expected.end(), data->qvel, data->qvel + model->nv);
  }
  EXPECT_EQ(steps(mujocos), expected);
  EXPECT_NE(steps(engine::PhysicsOptions()), expected) << "the default is the other solver, and rounds otherwise";
}

}  // namespace
}  // namespace mimo::test
