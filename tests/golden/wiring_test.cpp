// Motors, tendons, locks, sensors, contact rules and options of the scenes against the tables of the
// original's compiled models.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "compat/mujoco.h"
#include "repository_paths.h"
#include "support/numbers.h"
#include "support/recording.h"
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

class GoldenWiring : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { tested = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Scenes, GoldenWiring,
                         ::testing::Values("v1_benchmark", "v2_benchmark", "reach", "standup", "selfbody"),
                         [](const auto& scene) { return std::string(scene.param); });

std::string name_of(mjtObj type, int id) {
  const char* text = mj_id2name(&model(), type, id);
  return text == nullptr ? "" : text;
}

void expect_actuators() {
  const Table table(tables() + "actuators.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.nu);
  ASSERT_EQ(m.nuser_actuator, 3);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(name_of(mjOBJ_ACTUATOR, id), row.text("name"));
    EXPECT_EQ(row.text("transmission"), "joint");
    EXPECT_EQ(m.actuator_trntype[id], mjTRN_JOINT);
    EXPECT_EQ(name_of(mjOBJ_JOINT, m.actuator_trnid[2 * id]), row.text("joint"));
    EXPECT_TRUE(close(row.numbers("gear"), m.actuator_gear + 6 * id));
    EXPECT_EQ(m.actuator_ctrllimited[id], row.integer("ctrllimited"));
    EXPECT_TRUE(close(row.numbers("ctrlrange"), m.actuator_ctrlrange + 2 * id));
    EXPECT_EQ(m.actuator_forcelimited[id], row.integer("forcelimited"));
    EXPECT_TRUE(close(row.numbers("forcerange"), m.actuator_forcerange + 2 * id));
    EXPECT_EQ(row.text("dyntype") + row.text("gaintype") + row.text("biastype"), "nonefixednone");
    EXPECT_EQ(m.actuator_dyntype[id], mjDYN_NONE);
    EXPECT_EQ(m.actuator_gaintype[id], mjGAIN_FIXED);
    EXPECT_EQ(m.actuator_biastype[id], mjBIAS_NONE);
    EXPECT_TRUE(close(row.number("gainprm0"), m.actuator_gainprm[mjNGAIN * id]));
    const double* force = m.actuator_forcerange + 2 * id;
    const double gear = m.actuator_gear[6 * id];
    const double torques[2] = {force[0] * gear, force[1] * gear};
    EXPECT_TRUE(close(row.numbers("max_torque_neg_pos"), torques));
    EXPECT_TRUE(close(row.numbers("user_vmax_fmaxneg_fmaxpos"), m.actuator_user + 3 * id));
  }
}

// "robot:hip_bend1*1.0; robot:hip_bend2*-1.0"
std::map<std::string, double> coefficients(const std::string& text) {
  std::map<std::string, double> result;
  for (const std::string& part : split(text, ';')) {
    const std::vector<std::string> sides = split(part, '*');
    result[sides[0].substr(sides[0].find_first_not_of(' '))] = std::stod(sides[1]);
  }
  return result;
}

void expect_tendons() {
  const Table table(tables() + "tendons.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.ntendon);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(name_of(mjOBJ_TENDON, id), row.text("name"));
    std::map<std::string, double> actual;
    for (int wrap = m.tendon_adr[id]; wrap < m.tendon_adr[id] + m.tendon_num[id]; ++wrap) {
      EXPECT_EQ(m.wrap_type[wrap], mjWRAP_JOINT);
      actual[name_of(mjOBJ_JOINT, m.wrap_objid[wrap])] = m.wrap_prm[wrap];
    }
    EXPECT_EQ(actual, coefficients(row.text("joints_coefs")));
    EXPECT_EQ(m.tendon_limited[id], row.integer("limited"));
    EXPECT_TRUE(close(row.numbers("range"), m.tendon_range + 2 * id));
    EXPECT_TRUE(close(row.number("stiffness"), m.tendon_stiffness[id]));
    EXPECT_TRUE(close(row.number("damping"), m.tendon_damping[id]));
    EXPECT_TRUE(close(row.number("frictionloss"), m.tendon_frictionloss[id]));
    EXPECT_TRUE(close(row.number("springlength"), m.tendon_lengthspring[id]));
    EXPECT_TRUE(close(row.number("margin"), m.tendon_margin[id]));
    EXPECT_TRUE(close(row.numbers("solref_lim"), m.tendon_solref_lim + mjNREF * id));
    EXPECT_TRUE(close(row.numbers("solimp_lim"), m.tendon_solimp_lim + mjNIMP * id));
  }
}

TEST_P(GoldenWiring, Actuators) { expect_actuators(); }
TEST_P(GoldenWiring, Tendons) { expect_tendons(); }

// The original's room has the right hand's locks and sensors only; our infant keeps all that it has.
TEST(GoldenWiringOfCatch, ActuatorsAndTendons) {
  tested = "catch";
  expect_actuators();
  expect_tendons();
}

TEST_P(GoldenWiring, Equalities) {
  const Table table(tables() + "equalities.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.neq);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(name_of(mjOBJ_EQUALITY, id), row.text("name"));
    const bool weld = row.text("type") == "weld";
    const mjtObj object = weld ? mjOBJ_BODY : mjOBJ_JOINT;
    EXPECT_EQ(m.eq_type[id], weld ? mjEQ_WELD : mjEQ_JOINT);
    EXPECT_EQ(name_of(object, m.eq_obj1id[id]), row.text("obj1"));
    EXPECT_EQ(m.eq_obj2id[id] < 0 ? "" : name_of(object, m.eq_obj2id[id]), row.text("obj2"));
    if (!weld && (m.*compat::kLockFlags)[id] != 0)
      continue;  // the original locks after loading: see GoldenSelfbody.SitsLocked
    EXPECT_EQ((m.*compat::kLockFlags)[id], row.integer("active"));
    EXPECT_TRUE(close(row.numbers("data"), m.eq_data + mjNEQDATA * id));
    EXPECT_TRUE(close(row.numbers("solref"), m.eq_solref + mjNREF * id));
    EXPECT_TRUE(close(row.numbers("solimp"), m.eq_solimp + mjNIMP * id));
  }
}

TEST_P(GoldenWiring, Sensors) {
  const Table table(tables() + "sensors.csv");
  const mjModel& m = model();
  const std::map<std::string, int> types = {
      {"accelerometer", mjSENS_ACCELEROMETER}, {"gyro", mjSENS_GYRO}, {"torque", mjSENS_TORQUE}};
  ASSERT_EQ(static_cast<int>(table.size()), m.nsensor);
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const int id = row.integer("id");
    EXPECT_EQ(name_of(mjOBJ_SENSOR, id), row.text("name"));
    EXPECT_EQ(m.sensor_type[id], types.at(row.text("type")));
    EXPECT_EQ(row.text("object_type"), "site");
    EXPECT_EQ(m.sensor_objtype[id], mjOBJ_SITE);
    EXPECT_EQ(name_of(mjOBJ_SITE, m.sensor_objid[id]), row.text("object"));
    EXPECT_EQ(m.sensor_dim[id], row.integer("dim"));
    EXPECT_EQ(m.sensor_adr[id], row.integer("adr"));
    EXPECT_TRUE(close(row.number("noise"), m.sensor_noise[id]));
    EXPECT_TRUE(close(row.number("cutoff"), m.sensor_cutoff[id]));
  }
}

TEST_P(GoldenWiring, ContactPairs) {
  const Table table(tables() + "contact_pairs.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.npair);
  for (int id = 0; id < m.npair; ++id) {
    const Table::Row row = table[static_cast<std::size_t>(id)];
    SCOPED_TRACE(row.label());
    EXPECT_EQ(name_of(mjOBJ_GEOM, m.pair_geom1[id]), row.text("geom1"));
    EXPECT_EQ(name_of(mjOBJ_GEOM, m.pair_geom2[id]), row.text("geom2"));
    EXPECT_EQ(m.pair_dim[id], row.integer("condim"));
    EXPECT_TRUE(close(row.numbers("friction"), m.pair_friction + 5 * id));
    EXPECT_TRUE(close(row.numbers("solref"), m.pair_solref + mjNREF * id));
    EXPECT_TRUE(close(row.numbers("solimp"), m.pair_solimp + mjNIMP * id));
    EXPECT_TRUE(close(row.number("margin"), m.pair_margin[id]));
    EXPECT_TRUE(close(row.number("gap"), m.pair_gap[id]));
  }
}

// The original locks the joints of the sitting pose when the environment is made; here the document does.
TEST(GoldenSelfbody, SitsLocked) {
  tested = "selfbody";
  const mjModel& m = model();
  const Json stored = read_json("poses.json").at("selfbody").at("stored");
  int locked = 0;
  for (int id = 0; id < m.neq; ++id) {
    if (m.eq_type[id] != mjEQ_JOINT || (m.*compat::kLockFlags)[id] == 0) continue;
    const std::string joint = name_of(mjOBJ_JOINT, m.eq_obj1id[id]);
    EXPECT_EQ(m.eq_data[mjNEQDATA * id], stored.at(joint)[0].get<double>()) << joint;
    ++locked;
  }
  EXPECT_EQ(locked, 47 - 8) << "all joints but the right arm's";
}

// The infant always has its two excludes (eyeballs and collar); the original's task scenes lack them.
void expect_excludes() {
  constexpr int kMore = MIMO_MUJOCO_4 ? 0 : 1;  // by which the ids in the one number of both are larger
  const Table table(tables() + "contact_excludes.csv");
  const mjModel& m = model();
  ASSERT_EQ(static_cast<int>(table.size()), m.nexclude);
  for (int id = 0; id < m.nexclude; ++id) {
    const Table::Row row = table[static_cast<std::size_t>(id)];
    SCOPED_TRACE(row.label());
    const int signature = m.exclude_signature[id];
    EXPECT_EQ(signature, row.integer("signature") - (1 - kMore) * 0x10001);
    EXPECT_EQ(name_of(mjOBJ_BODY, (signature >> 16) - kMore), row.text("body1"));
    EXPECT_EQ(name_of(mjOBJ_BODY, (signature & 0xffff) - kMore), row.text("body2"));
  }
}

TEST(GoldenWiringOfBenchmark, ContactExcludes) {
  for (const char* version : {"v1_benchmark", "v2_benchmark"}) {
    tested = version;
    expect_excludes();
  }
}

std::map<std::string, std::vector<double>> options_of(const mjModel& m) {
  const mjOption& o = m.opt;
  const auto three = [](const double* v) { return std::vector<double>(v, v + 3); };
  const auto integer = [](int v) { return std::vector<double>{static_cast<double>(v)}; };
  return {
#if !MIMO_MUJOCO_4  // which looks for how far two shapes go into each other by another method
    {"apirate", {o.apirate}}, {"mpr_tolerance", {o.mpr_tolerance}}, {"mpr_iterations", integer(o.mpr_iterations)},
        {"collision", integer(o.collision)},
#endif
        {"timestep", {o.timestep}}, {"impratio", {o.impratio}}, {"tolerance", {o.tolerance}},
        {"noslip_tolerance", {o.noslip_tolerance}}, {"gravity", three(o.gravity)}, {"wind", three(o.wind)},
        {"magnetic", three(o.magnetic)}, {"density", {o.density}}, {"viscosity", {o.viscosity}},
        {"o_margin", {o.o_margin}}, {"o_solref", std::vector<double>(o.o_solref, o.o_solref + mjNREF)},
        {"o_solimp", std::vector<double>(o.o_solimp, o.o_solimp + mjNIMP)}, {"integrator", integer(o.integrator)},
        {"cone", integer(o.cone)}, {"solver", integer(o.solver)}, {"iterations", integer(o.iterations)},
        {"noslip_iterations", integer(o.noslip_iterations)}, {"disableflags", integer(o.disableflags)},
        {"enableflags", integer(o.enableflags)}, {"size_nq", integer(m.nq)}, {"size_nv", integer(m.nv)},
        {"size_nu", integer(m.nu)}, {"size_nbody", integer(m.nbody)}, {"size_njnt", integer(m.njnt)},
        {"size_ngeom", integer(m.ngeom)}, {"size_nsite", integer(m.nsite)}, {"size_ncam", integer(m.ncam)},
        {"size_nlight", integer(m.nlight)}, {"size_ntendon", integer(m.ntendon)}, {"size_neq", integer(m.neq)},
        {"size_npair", integer(m.npair)}, {"size_nexclude", integer(m.nexclude)}, {"size_nsensor", integer(m.nsensor)},
        {"size_nsensordata", integer(m.nsensordata)}, {"size_nkey", integer(m.nkey)}, {"size_nmesh", integer(m.nmesh)},
    {
      "size_nuser_actuator", integer(m.nuser_actuator)
    }
  };
}

TEST_P(GoldenWiring, Options) {
  // Names that repeat a number, our own art, and the one option that differs on purpose.
  std::set<std::string> skipped = {"integrator_name", "cone_name", "solver_name",  "size_ntex",
                                   "size_nmat",       "jacobian",  "jacobian_name"};
#if MIMO_MUJOCO_4
  skipped.insert({"apirate", "collision", "mpr_iterations", "mpr_tolerance"});
#endif
  const std::set<std::string> benchmark_only = {"size_nlight", "size_nexclude"};  // light is art; see ContactExcludes
  const bool task = tested.find("benchmark") == std::string::npos;
  const Table table(tables() + "options.csv");
  const auto actual = options_of(model());
  std::size_t compared = 0;
  for (const Table::Row& row : table.rows()) {
    SCOPED_TRACE(row.label());
    const std::string option = row.text("option");
    if (skipped.count(option) > 0) continue;
    if (task && benchmark_only.count(option) > 0) continue;
    ASSERT_EQ(actual.count(option), 1u) << option << " is not compared with anything";
    const std::vector<double> expected = row.numbers("value");
    ASSERT_EQ(expected.size(), actual.at(option).size()) << option;
    EXPECT_TRUE(close(expected, actual.at(option).data())) << option;
    ++compared;
  }
  EXPECT_EQ(compared, actual.size() - (task ? benchmark_only.size() : 0));
  EXPECT_EQ(model().opt.jacobian, mjJAC_SPARSE) << "built-in scenes solve with a sparse Jacobian";
}

}  // namespace
}  // namespace mimo::test
