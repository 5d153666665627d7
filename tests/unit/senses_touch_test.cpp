// The sense of touch of infants in their world.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/format.h"
#include "compat/mujoco.h"
#include "support/block.h"
#include "support/scenes.h"
#include "support/tiny.h"
#include "support/touch.h"

namespace mimo::test {
namespace {

using engine::Kind;
using senses::TouchFrame;
using senses::touch::Response;

// Every body felt what acts on it.
void expect_conserved(const env::World& world, const Observation& block, TouchFrame frame) {
  auto acting = loads(world.model(), world.data());
  for (const auto& [body, sum] : sum_by_body(world, block["touch/force"])) {
    const Vec3 felt = frame == TouchFrame::kWorld ? sum : Vec3(rotation_of(world.data(), body) * sum);
    const Load& load = acting[body];
    EXPECT_LE((felt - load.force).norm(), 1e-6 * load.magnitude) << engine::name(world.model(), Kind::kBody, body);
  }
}

int self_contacts(const env::World& world) {
  const body::Body& body = world.agents()[0].body;
  const auto own = [&](int geom) {
    const int id = world.model().geom_bodyid[geom];
    return std::find(body.bodies.begin(), body.bodies.end(), id) != body.bodies.end();
  };
  int count = 0;
  for (int i = 0; i < world.data().ncon; ++i) {
    count += own(world.data().contact[i].geom1) && own(world.data().contact[i].geom2);
  }
  return count;
}

using Case = std::tuple<Response, TouchFrame, double>;
class Touch : public ::testing::TestWithParam<Case> {};

// An infant that struggles on the floor: contacts with the floor and with itself, in all directions.
TEST_P(Touch, ForcesAreConservedOverAThousandContacts) {
  env::AgentOptions options = blind();
  options.touch.response = std::get<0>(GetParam());
  options.touch.frame = std::get<1>(GetParam());
  options.touch.scale = std::get<2>(GetParam());
  const auto world = benchmark_world(options);
  Observation block(*world);
  int contacts = 0, own = 0;
  for (int step = 0; step < 300; ++step) {
    world->step(some_actions(*world, step), block.data(), {});
    expect_conserved(*world, block, options.touch.frame);
    contacts += world->data().ncon;
    own += self_contacts(*world);
  }
  EXPECT_GE(contacts, 1000);
  EXPECT_GE(own, 30);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Touch,
                         ::testing::Values(Case{Response::kLinear, TouchFrame::kBody, 1.0},
                                           Case{Response::kNearest, TouchFrame::kWorld, 1.0},
                                           Case{Response::kGaussian, TouchFrame::kBody, 0.5},
                                           Case{Response::kLinear, TouchFrame::kWorld, 0.1}));

TEST(TouchInfant, FieldsAreDescribed) {
  env::AgentOptions options = blind();
  options.touch.wanted |= MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
  options.touch.frame = TouchFrame::kSkin;
  const auto world = benchmark_world(options);
  std::map<std::string, const observation::Field*> fields;
  for (std::size_t i = 0; i < world->layout().size(); ++i) fields[world->layout()[i].name] = &world->layout()[i];
  const std::size_t sensors = sensors_of(*world).size();
  EXPECT_EQ(fields.at("touch/force")->shape, (std::vector<std::size_t>{sensors, 3}));
  EXPECT_EQ(fields.at("touch/force")->unit, "N");
  EXPECT_EQ(fields.at("touch/force")->frame, "skin");
  EXPECT_EQ(fields.at("touch/slip")->shape, (std::vector<std::size_t>{sensors, 2}));
  EXPECT_EQ(fields.at("touch/slip")->unit, "m/s");
  EXPECT_EQ(fields.at("touch/friction_use")->shape, (std::vector<std::size_t>{sensors, 1}));
  for (const auto& [name, field] : fields) {
    EXPECT_TRUE(name.rfind("touch/", 0) != 0 || field->time == observation::Time::kLastStart);
  }
}

TEST(TouchInfant, HasNoFieldWithoutSkin) {
  env::AgentOptions options = blind();
  options.touch.everywhere = 0;
  const auto world = benchmark_world(options);
  for (std::size_t i = 0; i < world->layout().size(); ++i) EXPECT_NE(world->layout()[i].name.rfind("touch/", 0), 0u);
  EXPECT_TRUE(sensors_of(*world).empty());
}

TEST(TouchInfant, BodiesWithoutSkinFeelNothingAndTheOthersStillDo) {
  env::AgentOptions options = blind();
  options.touch.everywhere = 0;
  options.touch.spacing = {{"hip", 0.02}, {"head", 0.05}};
  const auto world = benchmark_world(options);
  const int hip = engine::find_or_fail(world->model(), Kind::kBody, "hip");
  const int head = engine::find_or_fail(world->model(), Kind::kBody, "head");
  for (const auto& sensor : sensors_of(*world)) EXPECT_TRUE(sensor.body == hip || sensor.body == head);
  Observation block(*world);
  bool felt = false;
  for (int step = 0; step < 200; ++step) {
    world->step(some_actions(*world, step), block.data(), {});
    expect_conserved(*world, block, TouchFrame::kBody);
    for (const auto& [body, sum] : sum_by_body(*world, block["touch/force"])) felt = felt || sum.norm() > 0.1;
  }
  EXPECT_TRUE(felt);
}

TEST(TouchInfant, RefusesUnknownBodiesAndListsTheKnownOnes) {
  env::AgentOptions options = blind();
  options.touch.spacing = {{"left_tentacle", 0.01}};
  expect_error(Status::kNotFound, "no body \"left_tentacle\" with a surface for skin; there are: hip, lower_body",
               [&] { benchmark_world(options); });
  options.touch.spacing = {{"mimo_location", 0.01}};  // it has no geoms
  expect_error(Status::kNotFound, "no body \"mimo_location\"", [&] { benchmark_world(options); });
  options.touch.spacing = {{"head", 1e-6}};
  expect_error(Status::kInvalidArgument, "between the sensors of body \"head\" would make about 6.79e+10 sensors",
               [&] { benchmark_world(options); });
}

// An infant held in the air with its right palm level, and a ball at a place above it that does not roll away.
engine::ModelPtr held_with_ball(const Vec3& place, double radius, double mass) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-80 * 3.14159265358979323846 / 180, Vec3::UnitX()));
  const document::Pose pose{{0, 0, 1}, {turn.w(), turn.x(), turn.y(), turn.z()}};
  scene::Scene scene(from_text(
      format("<mujoco><include file='mimo/parts/options.xml'/><worldbody><body pos='{} {} {}'><freejoint/>"
             "<geom size='{}' mass='{}' condim='6' friction='1 0.01 0.01' solref='0.005 1'/></body></worldbody>"
             "<equality><weld body1='mimo_location' solref='.01 1' solimp='.9999 .9999 .001 .5 1'/></equality>"
             "</mujoco>",
             place.x(), place.y(), place.z(), radius, mass)));
  scene.add_body("mitten", "", &pose);
  engine::ModelPtr model = compile(scene);
  std::fill_n(const_cast<mjModel*>(model.get())->*compat::kLockFlags, model->neq, static_cast<mjtByte>(1));
  return model;
}

TEST(TouchInfant, FeelsTheWeightOfABallOnThePalm) {
  constexpr double kMass = 0.2, kRadius = 0.03, kWeight = kMass * 9.81;
  const engine::Physics alone(held_with_ball({0, 0, 5}, kRadius, kMass), {});
  const int hand = engine::find_or_fail(alone.model(), Kind::kBody, "right_hand");
  const Vec3 palm(alone.data().geom_xpos + 3 * alone.model().body_geomadr[hand]);

  env::AgentOptions options = blind();
  options.touch.frame = TouchFrame::kWorld;
  env::World world(held_with_ball(palm + Vec3(0, 0, 0.01 + kRadius), kRadius, kMass), {options}, without_renderer());
  Observation block(world);
  for (int step = 0; step < 500; ++step) world.step({}, block.data(), {});
  for (const auto& [body, sum] : sum_by_body(world, block["touch/force"])) {
    const Vec3 expected(0, 0, body == hand ? -kWeight : 0);
    EXPECT_LE((sum - expected).norm(), body == hand ? 0.02 * kWeight : 0)
        << engine::name(world.model(), Kind::kBody, body) << " felt " << sum.transpose();
  }
}

// One lies on the other: each feels the other, with its own skin.
TEST(TouchInfant, TwoInfantsFeelEachOther) {
  scene::Scene scene(
      from_text("<mujoco><include file='mimo/parts/options.xml'/><option gravity='0 0 0'/><worldbody/></mujoco>"));
  const document::Pose here{{0, 0, 1}, {1, 0, 0, 0}}, there{{0.09, 0, 1}, {1, 0, 0, 0}};
  scene.add_body("mitten", "anna/", &here);
  scene.add_body("mitten", "ben/", &there);
  env::AgentOptions anna = blind(), ben = blind();
  anna.name = "anna";
  ben.name = "ben";
  anna.touch.frame = ben.touch.frame = TouchFrame::kWorld;
  env::World world(compile(scene), {anna, ben}, without_renderer());
  Observation block(world);
  world.observe(block.data());
  Vec3 sums[2] = {Vec3::Zero(), Vec3::Zero()};
  double magnitude = 0;
  const char* fields[2] = {"anna/touch/force", "ben/touch/force"};
  for (std::size_t agent = 0; agent < 2; ++agent) {
    for (const auto& [body, sum] : sum_by_body(world, block[fields[agent]], agent)) {
      sums[agent] += sum;
      magnitude += sum.norm();
    }
  }
  EXPECT_GT(sums[0].norm(), 0.1);
  EXPECT_LT((sums[0] + sums[1]).norm(), 1e-6 * magnitude);
}

}  // namespace
}  // namespace mimo::test
