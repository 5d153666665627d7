// Poses, masses and passive forces in recorded joint positions (kinematics_*.json).
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "compat/mujoco.h"
#include "support/recording.h"

namespace mimo::test {
namespace {

using engine::Kind;

// Diagonal of the joint-space inertia, one number a degree of freedom.
std::vector<double> inertia_diagonal(const mjModel& model, const mjData& data) {
  std::vector<double> diagonal;
  for (int dof = 0; dof < model.nv; ++dof) {
    compat::visit_inertia(model, data, dof, [&](int other, double value) {
      if (other == dof) diagonal.push_back(value);
    });
  }
  return diagonal;
}

void expect_poses(const mjModel& model, const mjData& data, const Json& recorded) {
  ASSERT_EQ(static_cast<int>(recorded.at("xpos").size()), model.nbody);
  for (int body = 0; body < model.nbody; ++body) {
    const std::string name = engine::name(model, Kind::kBody, body);
    EXPECT_TRUE(close(recorded.at("xpos").at(name), data.xpos + 3 * body)) << name;
    EXPECT_TRUE(same_rotation(recorded.at("xquat").at(name), data.xquat + 4 * body)) << name;
  }
  ASSERT_EQ(static_cast<int>(recorded.at("cam_xpos").size()), model.ncam);
  for (int camera = 0; camera < model.ncam; ++camera) {
    const std::string name = engine::name(model, Kind::kCamera, camera);
    EXPECT_TRUE(close(recorded.at("cam_xpos").at(name), data.cam_xpos + 3 * camera)) << name;
  }
}

void expect_recorded_poses(const std::string& body, const std::string& file) {
  const Json poses = read_json(file);
  ASSERT_EQ(poses.size(), 7u);
  engine::Physics physics(benchmark_model(body), {});
  const mjModel& model = physics.model();
  mjData& data = physics.data();
  const int root = engine::find_or_fail(model, Kind::kBody, "mimo_location");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    SCOPED_TRACE("pose " + std::to_string(i));
    if (i == 0) {
      expect_positions(model, poses[i].at("qpos"), data.qpos, {});  // where a world starts
    }
    set_positions(model, poses[i].at("qpos"), data.qpos);
    physics.forward();
    expect_poses(model, data, poses[i]);
    EXPECT_TRUE(close(poses[i].at("mimo_com"), data.subtree_com + 3 * root));
    expect_dofs("inertia", model, poses[i].at("inertia_diag"), inertia_diagonal(model, data).data());
    expect_dofs("bias force", model, poses[i].at("bias_force"), data.qfrc_bias);
    expect_dofs("passive force", model, poses[i].at("passive_force"), data.qfrc_passive);
  }
}

TEST(GoldenKinematics, Mitten) { expect_recorded_poses("mitten", "kinematics_v1.json"); }
TEST(GoldenKinematics, Fingers) { expect_recorded_poses("fingers", "kinematics_v2.json"); }

}  // namespace
}  // namespace mimo::test
