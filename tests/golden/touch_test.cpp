// The skin's sensors and what they feel, against the original (touch_*.json).
#include "support/touch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <ostream>

#include "base/format.h"
#include "compat/mujoco.h"
#include "senses/touch/surface.h"
#include "support/recording.h"

namespace mimo::test {
namespace {

using engine::Kind;
using senses::touch::Sensor;
using senses::touch::Skin;

Skin skin(const std::string& body, double scale) {
  senses::TouchOptions options;
  options.scale = scale;
  const mjModel& model = *benchmark_model(body);
  return Skin(model, senses::spacings(model, body::find_body(model, ""), options));
}

std::map<std::string, int> counts_by_body(const mjModel& model, const Skin& skin) {
  std::map<std::string, int> counts;
  for (const Sensor& sensor : skin.sensors()) ++counts[engine::name(model, Kind::kBody, sensor.body)];
  return counts;
}

TEST(GoldenTouch, PointsBeforePruningAreThoseOfTheOriginal) {
  const mjModel& model = *benchmark_model();
  std::size_t points = 0;
  for (int body = 1; body < model.nbody; ++body) {
    const double spacing = senses::touch::default_spacing(engine::name(model, Kind::kBody, body));
    if (spacing == 0) continue;
    for (const int geom : senses::touch::geoms_with_skin(model, body)) {
      points += senses::touch::sample(senses::touch::shape_of(model, geom), spacing).points.size();
    }
  }
  EXPECT_EQ(points, 7258u);
}

// Whether a point lies in or on another geom of its body than the one whose skin it belongs to.
bool at_a_seam(int body, const Vec3& point) {
  const mjModel& model = *benchmark_model();
  int touching = 0;
  for (const int geom : senses::touch::geoms_with_skin(model, body)) {
    senses::touch::OuterShape shape = senses::touch::shape_of(model, geom);
    shape.size.array() += 1e-6;
    const double* q = model.geom_quat + 4 * geom;
    const Vec3 local =
        Eigen::Quaterniond(q[0], q[1], q[2], q[3]).conjugate() * (point - Vec3(model.geom_pos + 3 * geom));
    touching += senses::touch::inside(shape, local);
  }
  return touching > 1;
}

std::vector<Vec3> recorded_points(const Json& list) {
  std::vector<Vec3> points;
  for (const auto& point : list) points.emplace_back(point[0], point[1], point[2]);
  return points;
}

bool among(const std::vector<Vec3>& points, const Vec3& place) {
  return std::any_of(points.begin(), points.end(), [&](const Vec3& p) { return (p - place).norm() < 1e-9; });
}

// Ours and the original's are the same but for points at seams, where the original tests against meshes that are
// inscribed in the geoms, and we against the geoms.
TEST(GoldenTouch, PlacesAreThoseOfTheOriginal) {
  const Skin mitten = skin("mitten", 0.25);
  std::map<std::string, std::vector<Vec3>> ours;
  for (const Sensor& sensor : mitten.sensors()) {
    ours[engine::name(*benchmark_model(), Kind::kBody, sensor.body)].push_back(sensor.position);
  }
  std::size_t common = 0;
  const Json recorded = read_json("touch_points_mitten_scale_0.25.json");
  for (const auto& [name, list] : recorded.items()) {
    const int body = engine::find_or_fail(*benchmark_model(), Kind::kBody, name);
    const std::vector<Vec3> theirs = recorded_points(list);
    for (const Vec3& point : ours[name]) {
      EXPECT_TRUE(among(theirs, point) || at_a_seam(body, point)) << name << " " << point.transpose();
    }
    for (const Vec3& point : theirs) {
      const bool both = among(ours[name], point);
      common += both;
      EXPECT_TRUE(both || at_a_seam(body, point)) << name << " " << point.transpose();
    }
  }
  EXPECT_GT(common, 370u);
}

struct CountCase {
  const char* key;
  const char* body;
  double scale;
  std::map<std::string, int> ours;  // where they differ; docs/differences.md lists them
  double near = 0.015;              // the sums, relative; with few sensors a seam is more of them
};
std::ostream& operator<<(std::ostream& out, const CountCase& c) { return out << c.key; }

class GoldenTouchCounts : public testing::TestWithParam<CountCase> {};

TEST_P(GoldenTouchCounts, AreNearlyThoseOfTheOriginal) {
  const Json recorded = read_json("touch_counts.json").at(GetParam().key);
  const std::string body = GetParam().body;
  const auto counts = counts_by_body(*benchmark_model(body), skin(body, GetParam().scale));
  int total = 0;
  for (const auto& [name, count] : counts) {
    total += count;
    const auto without_side = name.substr(name.find("right_") == 0 ? 6 : name.find("left_") == 0 ? 5 : 0);
    const auto different = GetParam().ours.find(without_side);
    EXPECT_EQ(count, different != GetParam().ours.end() ? different->second : recorded.at(name).get<int>()) << name;
  }
  EXPECT_EQ(counts.size() + 1, recorded.size());
  EXPECT_NEAR(total, recorded.at("TOTAL").get<int>(), GetParam().near * recorded.at("TOTAL").get<int>());
}

INSTANTIATE_TEST_SUITE_P(
    Scales, GoldenTouchCounts,
    testing::Values(CountCase{"v1_T0.25", "mitten", 0.25, {{"upper_body", 16}, {"hand", 13}, {"fingers", 122}}, 0.07},
                    CountCase{"v2_T0.25", "fingers", 0.25, {{"upper_body", 16}, {"hand", 11}}},
                    CountCase{"v2_T0.5",
                              "fingers",
                              0.5,
                              {{"upper_body", 54}, {"hand", 34}, {"lfmetacarpal", 9}, {"foot", 10}, {"toes", 9}},
                              0.017},
                    CountCase{"v1_T0.5", "mitten", 0.5, {{"upper_body", 54}, {"hand", 36}, {"foot", 14}, {"toes", 13}}},
                    CountCase{"v1_T1.0",
                              "mitten",
                              1,
                              {{"upper_body", 160}, {"hand", 160}, {"lower_leg", 34}, {"foot", 83}, {"toes", 38}}},
                    CountCase{"v1_T2.0",
                              "mitten",
                              2,
                              {{"upper_body", 565}, {"hand", 726}, {"lower_leg", 111}, {"foot", 266}, {"toes", 165}}},
                    CountCase{"v2_T1.0",
                              "fingers",
                              1,
                              {{"upper_body", 160},
                               {"hand", 142},
                               {"lfmetacarpal", 27},
                               {"lower_leg", 34},
                               {"foot", 79},
                               {"toes", 33},
                               {"big_toe", 23}}},
                    CountCase{"v2_T2.0",
                              "fingers",
                              2,
                              {{"upper_body", 565},
                               {"hand", 609},
                               {"lfmetacarpal", 114},
                               {"lower_leg", 111},
                               {"foot", 236},
                               {"toes", 144},
                               {"big_toe", 84}}}));

// The benchmark scene with the infant held and a ball that can slide up and down.
engine::ModelPtr held_under_a_ball(const Json& recorded) {
  const Json& ball = recorded.at("ball");
  const auto number = [&](const char* key) { return format("{}", ball.at(key).get<double>()); };
  scene::Scene scene(from_text(
      "<mujoco><include file='mimo/benchmark.xml'/><worldbody><body pos='" + number("x") + " " + number("y") + " " +
      number("z") + "'><joint name='ball_slide' type='slide' axis='0 0 1' damping='" + number("damping") +
      "'/><geom name='ball' class='room' size='" + number("size") + "' mass='" + number("mass") +
      "' condim='3'/></body></worldbody><equality><weld body1='mimo_location' solref='.01 1' "
      "solimp='.9999 .9999 .001 .5 1'/></equality></mujoco>"));
  const std::vector<double> quat = recorded.at("root_quat_wxyz");
  const document::Pose pose{{0, 0, 1}, {quat[0], quat[1], quat[2], quat[3]}};
  scene.add_body("mitten", "", &pose);
  engine::ModelPtr model = compile(scene);
  std::fill_n(const_cast<mjModel*>(model.get())->*compat::kLockFlags, model->neq, static_cast<mjtByte>(1));
  return model;
}

// What contacts push with follows from the version of MuJoCo, where the infant and the ball lie does not.
TEST(GoldenTouch, ForcesOfABallAtRest) {
  const Json scenes = read_json("touch_static.json"), by_mujoco_4 = read_json("mujoco4/touch_static.json");
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    const Json& recorded = scenes[scene];
    const Json& forces = MIMO_MUJOCO_4 ? by_mujoco_4[scene] : recorded.at("reference_from_mj_contactForce");
    SCOPED_TRACE("scene " + recorded.at("id").dump());
    const engine::ModelPtr model = held_under_a_ball(recorded);
    env::World world(model, {blind()}, without_renderer());
    set_positions(*model, recorded.at("qpos"), world.physics().data().qpos);
    Observation block(world);
    world.observe(block.data());
    const auto felt = sum_by_body(world, block["touch/force"]);
    const auto acting = loads(*model, world.data());
    for (const auto& [name, reference] : forces.items()) {
      const int body = engine::find_or_fail(*model, Kind::kBody, name);
      const Vec3 force = rotation_of(world.data(), body) * felt.at(body);
      const std::vector<double> expected = reference.at("force_world");
      const Vec3 original(expected[0], expected[1], expected[2]);
      EXPECT_LT((force - original).norm(), 0.02 * original.norm()) << name << " felt " << force.transpose();
      EXPECT_LT((force - acting.at(body).force).norm(), 1e-6 * acting.at(body).magnitude) << name;
    }
    for (const auto& [body, force] : felt) {
      const bool touched = recorded.at("touch").contains(engine::name(*model, Kind::kBody, body));
      EXPECT_EQ(force.norm() > 0, touched) << engine::name(*model, Kind::kBody, body);
    }
  }
}

}  // namespace
}  // namespace mimo::test
