// Our search for contacts against MuJoCo's own: the same contacts, to the bit and in the same order.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "base/format.h"
#include "base/random.h"
#include "compat/mujoco.h"
#include "engine/guard.h"
#include "engine/model.h"
#include "solver/collision.h"
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
    engine::guarded([&] { mj_collision(&model, theirs.get()); });  // which may warn that its buffer is full
    engine::guarded([&] { solver::collide(model, *ours); });
    EXPECT_EQ(ours->warning[mjWARN_CONTACTFULL].number, theirs->warning[mjWARN_CONTACTFULL].number) << "pose " << pose;
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

constexpr char kField[] =
    "/><asset><hfield name='field' nrow='3' ncol='3' size='1 1 .2 .1'/></asset>"
    "<worldbody><geom type='hfield' hfield='field' pos='0 0 -.2'/></worldbody><option ";
constexpr char kMocap[] =
    "/><worldbody><body mocap='true' pos='.1 0 0'><geom type='capsule' size='.2 .3'/></body></worldbody><option ";

INSTANTIATE_TEST_SUITE_P(OurSearch, EngineCollision,
                         ::testing::Values(Search{"", 2000},
                                           Search{"><flag filterparent='disable'/></option><option ", 2000},
                                           Search{"/><size nconmax='5'/><option ", 1000}, Search{kField, 2000},
                                           Search{kMocap, 2000}));

// What collide() leaves to mj_collision; these fail where it does not.
INSTANTIATE_TEST_SUITE_P(LeftToMujoco, EngineCollision,
                         ::testing::Values(Search{"o_margin='0.05'><flag override='enable'/></option><option ", 2000},
                                           Search{"/><default><geom margin='-.05'/></default><option ", 1000}));

#if !MIMO_MUJOCO_4  // where documents have no such choice
INSTANTIATE_TEST_SUITE_P(OurChoice, EngineCollision, ::testing::Values(Search{"collision='dynamic'", 2000}));
INSTANTIATE_TEST_SUITE_P(ChoiceLeftToMujoco, EngineCollision, ::testing::Values(Search{"collision='predefined'", 50}));
#endif

// Up to 512 shapes the search is ours.
TEST(EngineCollision, FindsMujocosContactsOfAnyNumberOfShapes) {
  Random random(1);
  for (const int shapes : {512, 513}) {
    SCOPED_TRACE(format("{} shapes", shapes));
    std::string xml = "<mujoco><size nconmax='1000'/><worldbody>";
    for (int i = 0; i < 3; ++i) xml += "<body><freejoint/><geom size='.2'/></body>";
    for (int i = 3; i < shapes; ++i) {
      xml += format("<geom size='.05' pos='{} {} {}'/>", random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                    random.uniform(-0.4, 0.4));
    }
    const engine::ModelPtr model = engine::compile(xml + "</worldbody></mujoco>", {}, {});
    ASSERT_EQ(model->ngeom, shapes);
    EXPECT_GT(compare(*model, random, 20), 1000);
  }
}

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
  solver::collide(*model, *data);
  EXPECT_EQ(data->ncon, 0);
}

}  // namespace
}  // namespace mimo::test
