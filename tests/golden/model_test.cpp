// The infant's bodies and the objects of the rooms against the tables of the original's compiled models:
// whatever has a place and a shape. Colours and materials are not compared: ours are our own.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <map>
#include <string>

#include "body/body.h"
#include "repository_paths.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using engine::Kind;

// Each test runs for each folder of tables, the one named here.
std::string tested;

const mjModel& model() {
  static std::map<std::string, engine::ModelPtr> compiled;
  engine::ModelPtr& found = compiled[tested];
  if (found == nullptr) found = golden_model(tested);
  return *found;
}

std::string tables() { return std::string(MIMO_TEST_DATA) + "/" + tested + "/"; }

class GoldenModel : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { tested = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Scenes, GoldenModel,
                         ::testing::Values("v1_benchmark", "v2_benchmark", "reach", "standup", "selfbody", "catch",
                                           "showroom"),
                         [](const auto& scene) { return std::string(scene.param); });

std::string body_name(int body) { return engine::name(model(), Kind::kBody, body); }

// A geom's name in the tables: its own, or "(body#index)" for those that had none in the original.
std::string geom_key(int geom, const std::string& known) {
  const std::string name = engine::name(model(), Kind::kGeom, geom);
  const int body = model().geom_bodyid[geom];
  const int index = geom - model().body_geomadr[body];
  return known[0] == '(' ? "(" + body_name(body) + "#" + std::to_string(index) + ")" : name;
}

TEST_P(GoldenModel, Bodies) {
  const Table table(tables() + "bodies.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.nbody);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(body_name(id), row.text("name"));
    if (id > 0) {
      EXPECT_EQ(body_name(m.body_parentid[id]), row.text("parent"));
    }
    EXPECT_TRUE(close(row.numbers("pos"), m.body_pos + 3 * id));
    EXPECT_TRUE(same_rotation(row.numbers("quat_wxyz"), m.body_quat + 4 * id));
    EXPECT_TRUE(close(row.number("mass"), m.body_mass[id]));
    EXPECT_TRUE(close(row.numbers("ipos"), m.body_ipos + 3 * id));
    EXPECT_TRUE(same_rotation(row.numbers("iquat"), m.body_iquat + 4 * id));
    EXPECT_TRUE(close(row.numbers("inertia_diag"), m.body_inertia + 3 * id));
    EXPECT_TRUE(close(row.number("subtreemass"), m.body_subtreemass[id]));
    EXPECT_EQ(m.body_geomnum[id], row.integer("n_geoms"));
    EXPECT_EQ(m.body_jntnum[id], row.integer("n_joints"));
    EXPECT_EQ(m.body_mocapid[id], row.integer("mocap"));
  }
}

TEST_P(GoldenModel, Geoms) {
  const Table table(tables() + "geoms.csv");
  const mjModel& m = model();
  const std::map<std::string, int> types = {{"plane", mjGEOM_PLANE},       {"sphere", mjGEOM_SPHERE},
                                            {"capsule", mjGEOM_CAPSULE},   {"box", mjGEOM_BOX},
                                            {"cylinder", mjGEOM_CYLINDER}, {"ellipsoid", mjGEOM_ELLIPSOID}};
  ASSERT_EQ(static_cast<int>(table.size()), m.ngeom);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(geom_key(id, row.text("name")), row.text("name"));
    EXPECT_EQ(body_name(m.geom_bodyid[id]), row.text("body"));
    EXPECT_EQ(m.geom_type[id], types.at(row.text("type")));
    EXPECT_TRUE(close(row.numbers("size"), m.geom_size + 3 * id));
    EXPECT_TRUE(close(row.numbers("pos"), m.geom_pos + 3 * id));
    EXPECT_TRUE(same_rotation(row.numbers("quat_wxyz"), m.geom_quat + 4 * id));
    EXPECT_EQ(m.geom_contype[id], row.integer("contype"));
    EXPECT_EQ(m.geom_conaffinity[id], row.integer("conaffinity"));
    EXPECT_EQ(m.geom_condim[id], row.integer("condim"));
    EXPECT_EQ(m.geom_priority[id], row.integer("priority"));
    EXPECT_TRUE(close(row.numbers("friction"), m.geom_friction + 3 * id));
    EXPECT_TRUE(close(row.number("solmix"), m.geom_solmix[id]));
    EXPECT_TRUE(close(row.numbers("solref"), m.geom_solref + mjNREF * id));
    EXPECT_TRUE(close(row.numbers("solimp"), m.geom_solimp + mjNIMP * id));
    EXPECT_TRUE(close(row.number("margin"), m.geom_margin[id]));
    EXPECT_TRUE(close(row.number("gap"), m.geom_gap[id]));
    EXPECT_EQ(m.geom_group[id], row.integer("group"));
    EXPECT_TRUE(close(row.number("rbound"), m.geom_rbound[id]));
  }
}

// Angles of hinges in degrees; a free joint has its pose there.
void expect_angles(const Table::Row& row, const std::string& column, bool hinge, const double* actual) {
  std::vector<double> expected = row.numbers(column);
  if (hinge) {
    for (double& angle : expected) angle *= mjPI / 180;
  }
  EXPECT_TRUE(close(expected, actual)) << column;
}

TEST_P(GoldenModel, Joints) {
  const Table table(tables() + "joints.csv");
  const mjModel& m = model();
  const std::map<std::string, int> types = {{"free", mjJNT_FREE}, {"hinge", mjJNT_HINGE}};
  ASSERT_EQ(static_cast<int>(table.size()), m.njnt);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    const int dof = m.jnt_dofadr[id];
    const int qpos = m.jnt_qposadr[id];
    const bool hinge = row.text("type") == "hinge";
    EXPECT_EQ(engine::name(m, Kind::kJoint, id), row.text("name"));
    EXPECT_EQ(body_name(m.jnt_bodyid[id]), row.text("body"));
    EXPECT_EQ(m.jnt_type[id], types.at(row.text("type")));
    EXPECT_TRUE(close(row.numbers("axis"), m.jnt_axis + 3 * id));
    EXPECT_TRUE(close(row.numbers("pos"), m.jnt_pos + 3 * id));
    EXPECT_EQ(m.jnt_limited[id], row.integer("limited"));
    expect_angles(row, "range_deg", hinge, m.jnt_range + 2 * id);
    EXPECT_TRUE(close(row.numbers("range_rad"), m.jnt_range + 2 * id));
    EXPECT_TRUE(close(row.number("stiffness"), m.jnt_stiffness[id]));
    expect_angles(row, "springref_deg", hinge, m.qpos_spring + qpos);
    EXPECT_TRUE(close(row.numbers("ref_qpos0"), m.qpos0 + qpos));
    EXPECT_TRUE(close(row.numbers("solref_limit"), m.jnt_solref + mjNREF * id));
    EXPECT_TRUE(close(row.numbers("solimp_limit"), m.jnt_solimp + mjNIMP * id));
    EXPECT_TRUE(close(row.number("margin"), m.jnt_margin[id]));
    EXPECT_EQ(qpos, row.integer("qposadr"));
    EXPECT_EQ(dof, row.integer("dofadr"));
    for (int i = dof; i < dof + velocity_width(m, id); ++i) {
      EXPECT_TRUE(close(row.number("damping"), m.dof_damping[i]));
      EXPECT_TRUE(close(row.number("frictionloss"), m.dof_frictionloss[i]));
      EXPECT_TRUE(close(row.number("armature"), m.dof_armature[i]));
      EXPECT_TRUE(close(row.numbers("solref_friction"), m.dof_solref + mjNREF * i));
      EXPECT_TRUE(close(row.numbers("solimp_friction"), m.dof_solimp + mjNIMP * i));
    }
  }
}

TEST_P(GoldenModel, InitialPose) {
  const Table table(tables() + "qpos0.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.njnt);
  for (int id = 0; id < m.njnt; ++id) {
    const Table::Row row = table[static_cast<std::size_t>(id)];
    SCOPED_TRACE(row.label());
    const std::string key = joint_key(m, id);
    EXPECT_EQ(row.text("joint"), key.rfind("free:", 0) == 0 ? "(" + key + ")" : key);
    const std::vector<double> expected = row.numbers("qpos0");
    ASSERT_EQ(static_cast<int>(expected.size()), position_width(m, id));
    EXPECT_TRUE(close(expected, m.qpos0 + m.jnt_qposadr[id]));
  }
}

TEST_P(GoldenModel, Sites) {
  const Table table(tables() + "sites.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.nsite);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(engine::name(m, Kind::kSite, id), row.text("name"));
    EXPECT_EQ(body_name(m.site_bodyid[id]), row.text("body"));
    EXPECT_EQ(row.text("type"), "sphere");
    EXPECT_EQ(m.site_type[id], mjGEOM_SPHERE);
    EXPECT_TRUE(close(row.numbers("size"), m.site_size + 3 * id));
    EXPECT_TRUE(close(row.numbers("pos"), m.site_pos + 3 * id));
    EXPECT_TRUE(same_rotation(row.numbers("quat_wxyz"), m.site_quat + 4 * id));
    EXPECT_EQ(m.site_group[id], row.integer("group"));
  }
}

std::vector<double> rotated(const double* quat, double x, double y, double z) {
  const double vector[3] = {x, y, z};
  std::vector<double> result(3);
  mju_rotVecQuat(result.data(), vector, quat);
  return result;
}

TEST_P(GoldenModel, Cameras) {
  const Table table(tables() + "cameras.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.ncam);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    const double* quat = m.cam_quat + 4 * id;
    EXPECT_EQ(engine::name(m, Kind::kCamera, id), row.text("name"));
    EXPECT_EQ(body_name(m.cam_bodyid[id]), row.text("body"));
    EXPECT_EQ(row.text("mode"), "fixed");
    EXPECT_EQ(m.cam_mode[id], mjCAMLIGHT_FIXED);
    EXPECT_TRUE(close(row.numbers("pos"), m.cam_pos + 3 * id));
    EXPECT_TRUE(same_rotation(row.numbers("quat_wxyz"), quat));
    EXPECT_TRUE(close(row.numbers("x_axis"), rotated(quat, 1, 0, 0).data()));
    EXPECT_TRUE(close(row.numbers("y_axis"), rotated(quat, 0, 1, 0).data()));
    EXPECT_TRUE(close(row.numbers("view_dir"), rotated(quat, 0, 0, -1).data()));
    EXPECT_TRUE(close(row.number("fovy"), m.cam_fovy[id]));
    EXPECT_TRUE(close(row.number("ipd"), m.cam_ipd[id]));
  }
}

// Sums over the infant, as the body room computes them.
TEST_P(GoldenModel, Derived) {
  const Table table(tables() + "derived.csv");
  std::map<std::string, std::vector<double>> known;
  for (const Table::Row& row : table.rows()) known[row.text("quantity")] = row.numbers("value");
  const engine::Physics physics(engine::ModelPtr(engine::ModelPtr(), &model()), {});
  const body::Body body = body::find_body(physics.model(), "");
  EXPECT_TRUE(close(known.at("mimo_subtree_mass_kg")[0], body::mass(physics.model(), body)));
  EXPECT_TRUE(
      close(known.at("mimo_aabb_extent_xyz_at_qpos0_m")[2], body::height(physics.model(), physics.data(), body)));
  EXPECT_EQ(known.at("n_robot_joints")[0], static_cast<double>(body.joints.size()));
  EXPECT_EQ(known.at("n_act_actuators")[0], static_cast<double>(body.actuators.size()));
  EXPECT_EQ(known.at("ncon_at_qpos0")[0], physics.data().ncon);
}

}  // namespace
}  // namespace mimo::test
