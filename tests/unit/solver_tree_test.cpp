// Our poses, velocities, forces of motors and rows of constraints against MuJoCo's own stages: the same numbers, to the
// bit.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/format.h"
#include "base/random.h"
#include "compat/mujoco.h"
#include "engine/model.h"
#include "solver/rows.h"
#include "solver/tree.h"
#include "support/random_model.h"

#if !MIMO_MUJOCO_4

namespace mimo::test {
namespace {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;

// Joints of all kinds, also several of one body and away from its origin, with limits, friction and a tendon; bodies
// without joints and without mass; motors on all of them, with limits and without.
constexpr const char* kJoints = R"(<mujoco><option jacobian='sparse' cone='elliptic' impratio='2'/>
  <default><geom condim='4' friction='.8 .02 .001' solimp='.8 .95 .5 .4 2'/></default><worldbody>
  <geom name='floor' type='plane' size='2 2 .1' pos='0 0 .5'/><geom name='fixed' size='.3' pos='1 1 .6'/>
  <body name='told' mocap='true' pos='1 0 0'><geom size='.4'/></body>
  <body name='root' pos='0 0 1'><freejoint name='free'/><geom type='box' size='.1 .2 .3' pos='.02 0 0'/><site name='s'/>
    <body pos='.2 0 0' euler='10 20 30'><inertial pos='.01 .02 .03' quat='1 .1 .2 .3' mass='2' diaginertia='.1 .2 .3'/>
      <joint name='h1' axis='1 0 0' pos='.1 .2 0' damping='.3' stiffness='2' springref='.2' frictionloss='.1'/>
      <joint name='h2' axis='0 1 .5' pos='0 .1 .1' limited='true' range='-20 30' margin='.1'/>
      <geom type='capsule' size='.05 .1' euler='0 40 0'/>
      <body pos='0 .3 0'><joint name='slide' type='slide' axis='0 .3 1' limited='true' range='-.1 .5' solreflimit='-90 -9'/>
        <geom size='.07' pos='.1 0 0' condim='6'/>
        <body pos='0 0 .2' quat='1 .2 0 0'><site name='t' pos='.1 .2 .3' quat='1 0 .3 0'/>
          <body pos='.1 0 0'><joint name='ball' type='ball' pos='.03 0 .02' limited='true' range='0 40' frictionloss='.2'/>
            <geom size='.2' condim='1'/></body>
        </body>
      </body>
    </body>
    <body pos='-.2 0 0'><joint name='h3' axis='0 0 1' frictionloss='.3' solreffriction='.05 .7'/>
      <geom type='ellipsoid' size='.05 .1 .07'/></body>
  </body></worldbody>
  <contact><pair geom1='floor' geom2='fixed' condim='3'/></contact>
  <tendon><fixed name='both' limited='true' range='-.2 .1' solimplimit='.7 .9 .3 .5 {}'>
    <joint joint='h1' coef='1'/><joint joint='h3' coef='-.5'/></fixed></tendon>
  <actuator>
    <motor joint='h1' gear='3'/><motor joint='h2' gear='-2' ctrllimited='true' ctrlrange='-.5 .4'/>
    <motor joint='slide' forcelimited='true' forcerange='-.1 .1'/><motor joint='h1'/>{}
  </actuator></mujoco>)";
constexpr const char* kOtherMotors =
    "<motor joint='ball' gear='1 2 3'/><position joint='h3' kp='3'/>"
    "<adhesion body='root' gain='30' ctrlrange='0 1'/>";
constexpr const char* kRules = "cone='elliptic' jacobian='sparse'";

struct Numbers {
  const char* name;
  mjtNum* mjData::*array;
  int count;
};

std::vector<Numbers> poses(const mjModel& m) {
  return {{"qpos", &mjData::qpos, m.nq},
          {"mocap_quat", &mjData::mocap_quat, 4 * m.nmocap},
          {"xpos", &mjData::xpos, 3 * m.nbody},
          {"xquat", &mjData::xquat, 4 * m.nbody},
          {"xmat", &mjData::xmat, 9 * m.nbody},
          {"xipos", &mjData::xipos, 3 * m.nbody},
          {"ximat", &mjData::ximat, 9 * m.nbody},
          {"xanchor", &mjData::xanchor, 3 * m.njnt},
          {"xaxis", &mjData::xaxis, 3 * m.njnt},
          {"geom_xpos", &mjData::geom_xpos, 3 * m.ngeom},
          {"geom_xmat", &mjData::geom_xmat, 9 * m.ngeom},
          {"site_xpos", &mjData::site_xpos, 3 * m.nsite},
          {"site_xmat", &mjData::site_xmat, 9 * m.nsite},
          {"subtree_com", &mjData::subtree_com, 3 * m.nbody},
          {"cinert", &mjData::cinert, 10 * m.nbody},
          {"cdof", &mjData::cdof, 6 * m.nv}};
}

std::vector<Numbers> velocities(const mjModel& m) {
  return {{"actuator_velocity", &mjData::actuator_velocity, m.nu},
          {"ten_velocity", &mjData::ten_velocity, m.ntendon},
          {"cvel", &mjData::cvel, 6 * m.nbody},
          {"cdof_dot", &mjData::cdof_dot, 6 * m.nv},
          {"qfrc_passive", &mjData::qfrc_passive, m.nv},
          {"qfrc_bias", &mjData::qfrc_bias, m.nv}};
}

std::vector<Numbers> motors(const mjModel& m) {
  return {{"actuator_force", &mjData::actuator_force, m.nu}, {"qfrc_actuator", &mjData::qfrc_actuator, m.nv}};
}

Data random_data(const mjModel& model, Random& random) {
  Data data(mj_makeData(&model));
  const auto fill = [&](double* numbers, int count) {
    for (int i = 0; i < count; ++i) numbers[i] = random.uniform(-1, 1);
  };
  fill(data->qpos, model.nq);
  fill(data->qvel, model.nv);
  fill(data->ctrl, model.nu);
  fill(data->mocap_pos, 3 * model.nmocap);
  fill(data->mocap_quat, 4 * model.nmocap);
  return data;
}

void forget(const std::vector<Numbers>& all, mjData& data) {
  for (const Numbers& numbers : all) std::fill_n(data.*numbers.array, numbers.count, -1.0);
}

void expect_same(const std::vector<Numbers>& all, const mjData& ours, const mjData& theirs) {
  for (const Numbers& numbers : all) {
    const double *own = ours.*numbers.array, *other = theirs.*numbers.array;
    EXPECT_EQ(std::vector<double>(own, own + numbers.count), std::vector<double>(other, other + numbers.count))
        << numbers.name;
  }
}

// In random states of joints of all kinds, with motors on single joints and others, and of random models.
template <typename Compare>
void each(Compare&& compare) {
  Random random(1);
  for (int i = 0; i < 12; ++i) {
    const std::string document =
        i < 2 ? format(kJoints, i == 0 ? 1.5 : 3, i == 0 ? "" : kOtherMotors) : random_model(random, kRules);
    const engine::ModelPtr model = engine::compile(document, {}, {});
    for (int state = 0; state < 5; ++state) {
      SCOPED_TRACE(format("model {}, state {}", i, state));
      const Data theirs = random_data(*model, random), ours(mj_makeData(model.get()));
      mj_copyData(ours.get(), model.get(), theirs.get());
      mj_forward(model.get(), theirs.get());
      compare(*model, *theirs, *ours);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(SolverTree, PutsEverythingWhereMujocoDoes) {
  each([](const mjModel& model, const mjData& theirs, mjData& ours) {
    solver::update_poses(model, ours);
    expect_same(poses(model), ours, theirs);
  });
}

TEST(SolverTree, MovesAsMujocoDoes) {
  each([](const mjModel& model, const mjData& theirs, mjData& ours) {
    mj_copyData(&ours, &model, &theirs);
    forget(velocities(model), ours);
    solver::update_velocities(model, ours);
    expect_same(velocities(model), ours, theirs);
  });
}

TEST(SolverTree, MotorsPullAsMujocos) {
  each([](const mjModel& model, const mjData& theirs, mjData& ours) {
    mj_copyData(&ours, &model, &theirs);
    forget(motors(model), ours);
    solver::actuate(model, ours);
    expect_same(motors(model), ours, theirs);
  });
}

template <typename T>
std::vector<T> copied(const T* values, int count) {
  return {values, values + count};
}

void expect_same_rows(const mjData& ours, const mjData& theirs) {
  const int rows = theirs.nefc, entries = theirs.efc_J_rowadr[rows - 1] + theirs.efc_J_rownnz[rows - 1];
  ASSERT_EQ(ours.nefc, rows);
  ASSERT_EQ(ours.nf, theirs.nf);
  ASSERT_EQ(ours.maxuse_efc, theirs.maxuse_efc);
  for (const auto array : {&mjData::efc_type, &mjData::efc_id, &mjData::efc_J_rownnz, &mjData::efc_J_rowadr}) {
    ASSERT_EQ(copied(ours.*array, rows), copied(theirs.*array, rows));
  }
  ASSERT_EQ(copied(ours.efc_J_colind, entries), copied(theirs.efc_J_colind, entries));
  ASSERT_EQ(copied(ours.efc_J, entries), copied(theirs.efc_J, entries));
  for (const auto array : {&mjData::efc_pos, &mjData::efc_margin, &mjData::efc_frictionloss, &mjData::efc_R,
                           &mjData::efc_D, &mjData::efc_diagApprox}) {
    ASSERT_EQ(copied(ours.*array, rows), copied(theirs.*array, rows));
  }
  ASSERT_EQ(copied(ours.efc_KBIP, 4 * rows), copied(theirs.efc_KBIP, 4 * rows));
  for (int i = 0; i < theirs.ncon; ++i) {
    ASSERT_EQ(ours.contact[i].mu, theirs.contact[i].mu);
    ASSERT_EQ(ours.contact[i].efc_address, theirs.contact[i].efc_address);
    ASSERT_EQ(ours.contact[i].exclude, theirs.contact[i].exclude);
  }
}

// As after the search for contacts; the transposed Jacobian is of no step.
void forget_rows(const mjModel& model, mjData& data) {
  std::fill_n(data.efc_JT, model.njmax * model.nv, -7.0);
  std::fill_n(data.actuator_moment, model.nu * model.nv, -7.0);
  data.nefc = data.nf = data.maxuse_efc = 0;
  for (int i = 0; i < data.ncon; ++i) {
    data.contact[i].efc_address = -1;
    data.contact[i].mu = 0;
    if (data.contact[i].exclude == 4) data.contact[i].exclude = 0;
  }
}

TEST(SolverTree, MakesMujocosRows) {
  int kinds[mjCNSTR_CONTACT_ELLIPTIC + 1] = {};
  each([&](const mjModel& model, const mjData& theirs, mjData& ours) {
    mj_copyData(&ours, &model, &theirs);
    forget_rows(model, ours);
    solver::make_constraints(model, ours);
    mj_transmission(&model, &ours);
    expect_same_rows(ours, theirs);
    ASSERT_EQ(copied(ours.actuator_moment, model.nu * model.nv), copied(theirs.actuator_moment, model.nu * model.nv));
    for (int row = 0; row < theirs.nefc; ++row) ++kinds[theirs.efc_type[row]];
  });
  for (const int kind : {mjCNSTR_FRICTION_DOF, mjCNSTR_LIMIT_JOINT, mjCNSTR_LIMIT_TENDON, mjCNSTR_CONTACT_FRICTIONLESS,
                         mjCNSTR_CONTACT_ELLIPTIC}) {
    EXPECT_GT(kinds[kind], 5) << kind;
  }
}

TEST(SolverTree, TakesThePowersOfTheSystem) {
  Random random(4);
  for (const double power : {0.5, 1.0, 1.5, 2.0}) {
    const volatile double same = power;  // lest the compiler multiplies
    int certain = 0;
    for (int i = 0; i < 300000; ++i) {
      const double x = random.uniform(0, 1);
      double found = 0;
      if (!solver::find_power(x, power, found)) continue;
      ASSERT_EQ(found, std::pow(x, same)) << x << " to the power of " << power;
      ++certain;
    }
    EXPECT_GT(certain, 280000) << power;
  }
  double found = 0;
  EXPECT_FALSE(solver::find_power(0.79741866146197138, 2, found));  // glibc 2.36 does not give the nearest number
  EXPECT_FALSE(solver::find_power(0.5, 3, found));
}

// Where there is no room for all rows it warns and leaves out the same ones.
TEST(SolverTree, LeavesOutMujocosRows) {
  int warnings = 0;
  for (int room = 1; room < 30; ++room) {
    SCOPED_TRACE(room);
    std::string document = format(kJoints, 2, "");
    document.insert(document.find("<option"), format("<size njmax='{}'/>", room));
    const engine::ModelPtr model = engine::compile(document, {}, {});
    Random random(3);
    const Data theirs = random_data(*model, random), ours(mj_makeData(model.get()));
    mj_forward(model.get(), theirs.get());
    mj_copyData(ours.get(), model.get(), theirs.get());
    forget_rows(*model, *ours);
    ours->warning[mjWARN_CNSTRFULL].number = 0;
    solver::make_constraints(*model, *ours);
    expect_same_rows(*ours, *theirs);
    ASSERT_EQ(ours->warning[mjWARN_CNSTRFULL].number, theirs->warning[mjWARN_CNSTRFULL].number);
    warnings += theirs->warning[mjWARN_CNSTRFULL].number;
  }
  EXPECT_GT(warnings, 10);
}

TEST(SolverTree, MotorsRestWhereAControlIsNoNumber) {
  const engine::ModelPtr model = engine::compile(format(kJoints, 2, ""), {}, {});
  const Data data(mj_makeData(model.get()));
  mj_forward(model.get(), data.get());
  std::fill_n(data->ctrl, model->nu, 0.3);
  data->ctrl[1] = std::numeric_limits<double>::quiet_NaN();  // of a motor with limits
  solver::actuate(*model, *data);
  EXPECT_EQ(data->warning[mjWARN_BADCTRL].number, 1);
  EXPECT_EQ(data->warning[mjWARN_BADCTRL].lastinfo, 1);
  EXPECT_EQ(std::vector<double>(data->actuator_force, data->actuator_force + model->nu),
            std::vector<double>(static_cast<std::size_t>(model->nu), 0.0));
}

}  // namespace
}  // namespace mimo::test

#endif
