// A world's data without room that its model cannot fill: what a step gives is what it gives with all of MuJoCo's room.
#include "engine/data.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <climits>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/model.h"

namespace mimo::test {
namespace {

using engine::ModelPtr;

// So many chains of five hinges with limits each that fall in a heap, half of a turn apart.
std::string heap(int chains, const std::string& options, const std::string& more = "", int rows = 300) {
  std::string xml = "<mujoco><option " + options + "/><size njmax='" + std::to_string(rows) +
                    "' nconmax='100'/><worldbody><geom type='plane' size='9 9 1'/>";
  for (int i = 0; i < chains; ++i) {
    const std::string name = "c" + std::to_string(i), height = std::to_string(0.3 + 0.25 * i);
    xml += "<body pos='0 0 " + height + "' euler='" + std::to_string(35 * i) + " 90 0'><freejoint/><geom size='0.03'/>";
    for (int link = 0; link < 5; ++link) {
      const std::string part = name + std::to_string(link);
      xml += "<body name='" + part + "' pos='0 0 0.2'><site name='" + part + "'/><joint name='" + part +
             "' axis='0 1 0' limited='true' range='-20 20'/><geom type='capsule' fromto='0 0 0 0 0 0.2' size='0.04'/>";
    }
    xml += "<geom size='0.05'/></body></body></body></body></body></body>";
  }
  return xml + "</worldbody>" + more + "</mujoco>";
}

ModelPtr compiled(const std::string& xml) { return engine::compile(xml, {}, {}); }

int entries(const mjData& data) { return std::accumulate(data.efc_J_rownnz, data.efc_J_rownnz + data.nefc, 0); }

using DocumentOfRows = std::function<std::string(int)>;

// Steps both, with room for the rows that occur and not one more, and expects equal bytes.
void compare(const DocumentOfRows& document) {
  constexpr int kSteps = 200;
  int most = 0;
  {
    const ModelPtr model = compiled(document(300));
    const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
    for (int step = 0; step < kSteps; ++step) mj_step(model.get(), full.get()), most = std::max(most, full->nefc);
    ASSERT_EQ(full->warning[mjWARN_CNSTRFULL].number, 0);
    ASSERT_GT(most, 40);
  }
  const ModelPtr model = compiled(document(most));
  const engine::DataPtr lean = engine::make_data(*model);
  const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
  for (int step = 0; step < 2 * kSteps; ++step) {
    mj_step(model.get(), lean.get());
    mj_step(model.get(), full.get());
    if (mj_isSparse(model.get()) != 0) {
      ASSERT_LE(entries(*full), engine::jacobian_room(*model));
    }
    if (step != kSteps - 1) continue;
    mj_resetData(model.get(), lean.get());
    mj_resetData(model.get(), full.get());
  }
  EXPECT_EQ(std::vector<double>(lean->qpos, lean->qpos + model->nq),
            std::vector<double>(full->qpos, full->qpos + model->nq));
  EXPECT_EQ(std::vector<double>(lean->qacc, lean->qacc + model->nv),
            std::vector<double>(full->qacc, full->qacc + model->nv));
  EXPECT_EQ(lean->nefc, full->nefc);
  EXPECT_EQ(full->warning[mjWARN_CNSTRFULL].number, 0);
}

TEST(Data, StepsLikeMujocosData) {
  for (const char* options : {"jacobian='sparse'", "jacobian='dense'", "jacobian='sparse' solver='PGS'",
                              "jacobian='dense' solver='PGS'", "jacobian='sparse' solver='CG'",
                              "jacobian='sparse' noslip_iterations='3'", "jacobian='sparse' cone='elliptic'"}) {
    SCOPED_TRACE(options);
    compare([&](int rows) { return heap(6, options, "", rows); });
  }
}

// Tendons over joints of three chains and through places on all six, with limits, friction and equalities.
const std::string kTendons =
    "<tendon><fixed name='joints' limited='true' range='-0.1 0.1'><joint joint='c00' coef='1'/><joint joint='c10' "
    "coef='1'/><joint joint='c24' coef='1'/></fixed><fixed name='other' frictionloss='0.1'><joint joint='c34' "
    "coef='1'/><joint joint='c44' coef='-1'/></fixed><spatial name='places' limited='true' range='0 1' "
    "frictionloss='0.2'><site site='c04'/><site site='c14'/><site site='c24'/><site site='c34'/><site "
    "site='c44'/><site "
    "site='c54'/></spatial></tendon><equality><tendon tendon1='joints' tendon2='other'/><tendon tendon1='places' "
    "polycoef='2 0 0 0 0'/></equality>";

TEST(Data, StepsTendonsLikeMujocosData) {
  compare([](int rows) { return heap(6, "jacobian='sparse'", kTendons, rows); });
}

// No row but those of equalities: 20 of the ends of two chains, of three rows each, and one of a tendon over all
// joints.
TEST(Data, RowsFillTheRoomThatTheyHave) {
  std::string equalities = "<equality><tendon tendon1='all'/>", joints;
  for (int i = 0; i < 20; ++i) equalities += "<connect body1='c04' body2='c14' anchor='0 0 0.2'/>";
  for (int link = 0; link < 5; ++link) {
    for (const char* chain : {"c0", "c1", "c2"}) {
      joints += "<joint coef='1' joint='" + std::string(chain) + std::to_string(link) + "'/>";
    }
  }
  const std::string options = "jacobian='sparse'><flag contact='disable' limit='disable'/></option><option";
  const ModelPtr model = compiled(
      heap(3, options, "<tendon><fixed name='all'>" + joints + "</fixed></tendon>" + equalities + "</equality>",
           20 * 3 + 1));
  const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
  mj_forward(model.get(), full.get());
  ASSERT_EQ(full->nefc, model->njmax);
  EXPECT_EQ(entries(*full), 20 * 3 * 22 + 15);
  EXPECT_EQ(engine::jacobian_room(*model), 61 * 22 + (3 + 1) * 33);
}

// A chain has 6 degrees of freedom of its free joint and 5 hinges, one behind the other: 11 to its end, 22 of two.
// There are 300 rows, and a tendon has three that may concern all 66.
TEST(Data, ARowIsAsWideAsTwoChains) {
  const std::string tendon = "<tendon><fixed><joint joint='c00' coef='1'/></fixed></tendon>";
  EXPECT_EQ(engine::jacobian_room(*compiled(heap(6, "jacobian='sparse'"))), 300 * 22);
  EXPECT_EQ(engine::jacobian_room(*compiled(heap(1, "jacobian='sparse'"))), 300 * 11);  // all that there are
  EXPECT_EQ(engine::jacobian_room(*compiled(heap(6, "jacobian='dense'"))), 300 * 66);
  EXPECT_EQ(engine::jacobian_room(*compiled(heap(6, "jacobian='sparse'", tendon))), 300 * 22 + 3 * 66);
}

#if !MIMO_MUJOCO_4
// 300 rows of 66 make two matrices, the Jacobian and its transpose, and one of 300 x 300, of entries of 12 bytes. A row
// has 8 integers and 14 numbers besides, a row of the transpose 3 integers. All that lies behind what counts as buffer.
TEST(Data, TakesAFractionOfMujocosMemory) {
  const ModelPtr model = compiled(heap(6, "jacobian='sparse'"));
  const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
  const int matrices = 12 * (2 * 300 * 66 + 300 * 300), rows = 300 * (8 * 4 + 14 * 8) + 66 * 3 * 4;
  const int spared = matrices + rows + 100 * static_cast<int>(sizeof(mjContact));
  EXPECT_NEAR(full->nbuffer - engine::make_data(*model)->nbuffer, spared, 64 * 200);  // but for alignment
}

// 40 chains have 440 degrees of freedom; MuJoCo counts the entries of the Jacobian by int.
TEST(Data, RefusesMoreEntriesThanMujocoCounts) {
  mjModel model = *compiled(heap(40, "jacobian='sparse'"));
  model.njmax = INT_MAX / 440 + 1;
  try {
    engine::make_data(model);
    FAIL() << "made";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kOutOfMemory);
    EXPECT_NE(error.message().find("at most 4880644"), std::string::npos) << error.message();
  }
}
#endif

}  // namespace
}  // namespace mimo::test
