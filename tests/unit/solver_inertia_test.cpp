// Our matrix of inertia and Euler's method against MuJoCo's own: the same numbers, to the bit.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/format.h"
#include "base/random.h"
#include "compat/mujoco.h"
#include "engine/model.h"
#include "solver/matrices.h"
#include "support/random_model.h"

#if !MIMO_MUJOCO_4

namespace mimo::test {
namespace {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;

std::vector<double> copied(const double* values, int count) { return {values, values + count}; }

// What a step has found before it moves on, in a random state.
Data random_data(const mjModel& model, Random& random) {
  Data data(mj_makeData(&model));
  for (int i = 0; i < model.nq; ++i) data->qpos[i] = random.uniform(-0.4, 0.4);
  for (int i = 0; i < model.nv; ++i) data->qvel[i] = random.uniform(-1, 1);
  mj_forward(&model, data.get());
  return data;
}

class EngineInertia : public ::testing::TestWithParam<const char*> {
 protected:
  // In random states of random models with these rules.
  template <typename Compare>
  void each(Compare&& compare) const {
    Random random(1);
    for (int i = 0; i < 20 && !HasFatalFailure(); ++i) {
      const engine::ModelPtr model = engine::compile(random_model(random, GetParam()), {}, {});
      for (int state = 0; state < 5 && !HasFatalFailure(); ++state) {
        SCOPED_TRACE(format("model {}, state {}", i, state));
        const Data theirs = random_data(*model, random), ours(mj_makeData(model.get()));
        mj_copyData(ours.get(), model.get(), theirs.get());
        compare(*model, *theirs, *ours);
      }
    }
  }
};

TEST_P(EngineInertia, IsMujocosMatrixAndFactor) {
  each([](const mjModel& model, const mjData& theirs, mjData& ours) {
    for (double* array : {ours.qM, ours.qLD}) std::fill_n(array, model.nM, -1.0);
    std::fill_n(ours.qLDiagInv, model.nv, -1.0);
    std::fill_n(ours.crb, 10 * model.nbody, -1.0);
    solver::update_inertia(model, ours);
    ASSERT_EQ(copied(ours.qM, model.nM), copied(theirs.qM, model.nM));
    ASSERT_EQ(copied(ours.qLD, model.nM), copied(theirs.qLD, model.nM));
    ASSERT_EQ(copied(ours.qLDiagInv, model.nv), copied(theirs.qLDiagInv, model.nv));
  });
}

TEST_P(EngineInertia, MovesOnAsMujocosEuler) {
  each([](const mjModel& model, mjData& theirs, mjData& ours) {
    mj_Euler(&model, &theirs);
    solver::integrate(model, ours);
    ASSERT_EQ(copied(ours.qvel, model.nv), copied(theirs.qvel, model.nv));
    ASSERT_EQ(copied(ours.qpos, model.nq), copied(theirs.qpos, model.nq));
    ASSERT_EQ(ours.time, theirs.time);
  });
}

// Without dampers, and with them, which are taken at the end of a step.
INSTANTIATE_TEST_SUITE_P(Each, EngineInertia,
                         ::testing::Values("", "/><default><joint damping='.2' armature='.01'/></default><option "));

}  // namespace
}  // namespace mimo::test

#endif
