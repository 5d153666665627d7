// Our search for contacts against MuJoCo's own: the same contacts, to the bit and in the same order.
#include "engine/collision.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "base/format.h"
#include "base/random.h"
#include "engine/model.h"
#include "support/random_model.h"

namespace mimo::test {
namespace {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;

void expect_same(const mjContact& theirs, const mjContact& ours) {
  const auto same = [](const double* expected, const double* actual, int count) {
    return std::equal(expected, expected + count, actual);
  };
  EXPECT_EQ(ours.geom1, theirs.geom1);
  EXPECT_EQ(ours.geom2, theirs.geom2);
  EXPECT_EQ(ours.dim, theirs.dim);
  EXPECT_EQ(ours.exclude, theirs.exclude);
  EXPECT_EQ(ours.dist, theirs.dist);
  EXPECT_EQ(ours.includemargin, theirs.includemargin);
  EXPECT_TRUE(same(theirs.pos, ours.pos, 3));
  EXPECT_TRUE(same(theirs.frame, ours.frame, 9));
  EXPECT_TRUE(same(theirs.friction, ours.friction, 5));
  EXPECT_TRUE(same(theirs.solref, ours.solref, mjNREF));
  EXPECT_TRUE(same(theirs.solimp, ours.solimp, mjNIMP));
  EXPECT_EQ(ours.efc_address, -1);
}

// In random poses of a model. Returns how many contacts there were.
int compare(const mjModel& model, Random& random, int poses) {
  const Data theirs(mj_makeData(&model)), ours(mj_makeData(&model));
  int found = 0;
  for (int pose = 0; pose < poses && !::testing::Test::HasFailure(); ++pose) {
    for (int i = 0; i < model.nq; ++i) theirs->qpos[i] = random.uniform(-0.4, 0.4);
    mj_kinematics(&model, theirs.get());
    mj_copyData(ours.get(), &model, theirs.get());
    mj_collision(&model, theirs.get());
    engine::collide(model, *ours);
    EXPECT_EQ(ours->ncon, theirs->ncon) << "pose " << pose;
    for (int i = 0; i < std::min(ours->ncon, theirs->ncon); ++i) {
      SCOPED_TRACE(format("pose {}, contact {} of geoms {} and {}", pose, i, theirs->contact[i].geom1,
                          theirs->contact[i].geom2));
      expect_same(theirs->contact[i], ours->contact[i]);
    }
    found += theirs->ncon;
  }
  return found;
}

struct Search {
  const char* rules;
  int least;  // contacts in all
};
class EngineCollision : public ::testing::TestWithParam<Search> {};

TEST_P(EngineCollision, FindsMujocosContacts) {
  Random random(1);
  int found = 0;
  for (int i = 0; i < 20 && !HasFailure(); ++i) {
    SCOPED_TRACE(format("model {}", i));
    const engine::ModelPtr model = engine::compile(random_model(random, GetParam().rules), {}, {});
    found += compare(*model, random, 20);
  }
  EXPECT_GT(found, GetParam().least);
}

INSTANTIATE_TEST_SUITE_P(Each, EngineCollision,
                         ::testing::Values(Search{"", 2000}, Search{"collision='dynamic'", 2000},
                                           Search{"collision='predefined'", 50},
                                           Search{"o_margin='0.05'><flag override='enable'/></option><option ", 2000},
                                           Search{"><flag filterparent='disable'/></option><option ", 2000}));

// MuJoCo compares such a plane's body with some others twice.
TEST(EngineCollision, LeavesPlanesOfOtherBodiesToMujoco) {
  const engine::ModelPtr model = engine::compile(
      "<mujoco><worldbody><body><geom type='plane' size='1 1 .1'/><geom size='.1'/></body>"
      "<body pos='0 0 .05'><freejoint/><geom size='.1'/></body></worldbody></mujoco>",
      {}, {});
  Random random(1);
  EXPECT_GT(compare(*model, random, 20), 0);
}

TEST(EngineCollision, FindsNothingWhereContactsAreOff) {
  const engine::ModelPtr model = engine::compile(
      "<mujoco><option><flag contact='disable'/></option><worldbody><geom size='.1'/><body><freejoint/><geom "
      "size='.1'/></body></worldbody></mujoco>",
      {}, {});
  const Data data(mj_makeData(model.get()));
  mj_kinematics(model.get(), data.get());
  data->ncon = 1;
  engine::collide(*model, *data);
  EXPECT_EQ(data->ncon, 0);
}

}  // namespace
}  // namespace mimo::test
