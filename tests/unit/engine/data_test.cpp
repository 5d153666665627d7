// A world's data without room that its model cannot fill: what a step gives is what it gives with all of MuJoCo's room.
#include "engine/data.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "engine/compat.h"
#include "engine/model.h"

namespace mimo::test {
namespace {

using engine::ModelPtr;

// So many chains of five hinges each that fall in a heap, half of a turn apart; each has a motor and a limit.
std::string heap(int chains, const std::string& options, const std::string& more = "") {
  std::string xml =
      "<mujoco><option " + options + "/><size njmax='300' nconmax='100'/><worldbody><geom type='plane' size='9 9 1'/>";
  for (int i = 0; i < chains; ++i) {
    const std::string name = "c" + std::to_string(i), height = std::to_string(0.3 + 0.25 * i);
    xml += "<body pos='0 0 " + height + "' euler='" + std::to_string(35 * i) + " 90 0'><freejoint/><geom size='0.03'/>";
    for (int link = 0; link < 5; ++link) {
      xml += "<body pos='0 0 0.2'><joint name='" + name + std::to_string(link) +
             "' axis='0 1 0' limited='true' range='-20 20'/><geom type='capsule' fromto='0 0 0 0 0 0.2' size='0.04'/>";
    }
    xml += "<geom size='0.05'/></body></body></body></body></body></body>";
  }
  return xml + "</worldbody>" + more + "</mujoco>";
}

// Steps both and expects equal bytes. Returns the most constraints at a time.
int compare(const ModelPtr& model) {
  const engine::DataPtr lean = engine::make_data(*model);
  const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
  int most = 0;
  for (int step = 0; step < 400; ++step) {
    mj_step(model.get(), lean.get());
    mj_step(model.get(), full.get());
    most = std::max(most, full->nefc);
    if (step == 200) {
      mj_resetData(model.get(), lean.get());
      mj_resetData(model.get(), full.get());
    }
  }
  EXPECT_EQ(std::vector<double>(lean->qpos, lean->qpos + model->nq),
            std::vector<double>(full->qpos, full->qpos + model->nq));
  EXPECT_EQ(std::vector<double>(lean->qacc, lean->qacc + model->nv),
            std::vector<double>(full->qacc, full->qacc + model->nv));
  EXPECT_EQ(lean->nefc, full->nefc);
  EXPECT_EQ(full->warning[mjWARN_CNSTRFULL].number, 0);
  return most;
}

ModelPtr compiled(const std::string& xml) { return engine::compile(xml, {}, {}); }

TEST(Data, StepsAsMujocosOwn) {
  for (const char* options : {"jacobian='sparse'", "jacobian='dense'", "jacobian='sparse' solver='PGS'",
                              "jacobian='dense' solver='PGS'", "jacobian='sparse' solver='CG'",
                              "jacobian='sparse' noslip_iterations='3'", "jacobian='sparse' cone='elliptic'"}) {
    SCOPED_TRACE(options);
    EXPECT_GT(compare(compiled(heap(6, options))), 40);
  }
}

TEST(Data, StepsTendonsAsMujocosOwn) {
  const std::string tendon =
      "<tendon><fixed limited='true' range='-0.1 0.1'><joint joint='c00' coef='1'/><joint joint='c10' coef='1'/>"
      "<joint joint='c24' coef='1'/></fixed></tendon>";
  EXPECT_GT(compare(compiled(heap(6, "jacobian='sparse'", tendon))), 40);
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
// 300 rows of 66 make two matrices, the Jacobian and its transpose, and one of 300 x 300, of entries of 12 bytes.
TEST(Data, TakesAFractionOfMujocosOwn) {
  const ModelPtr model = compiled(heap(6, "jacobian='sparse'"));
  const engine::DataPtr full(mj_makeData(model.get()), mj_deleteData);
  const int spared = 12 * (2 * 300 * 66 + 300 * 300);
  EXPECT_NEAR(full->nbuffer - engine::make_data(*model)->nbuffer, spared, 64 * 200);  // but for alignment
}
#endif

}  // namespace
}  // namespace mimo::test
