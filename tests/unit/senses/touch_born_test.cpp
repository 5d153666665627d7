// Sensors that are placed on a body as it was at 18 months and move with its skin.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "senses/touch/skin.h"
#include "support/tiny.h"

namespace mimo::senses::touch {
namespace {

// A capsule with a box on its side, and a head, as they are now; `born` goes into the section custom.
engine::ModelPtr infant(const std::string& capsule, const std::string& box, const std::string& head,
                        const std::string& born = "") {
  return test::compiled("<mujoco><custom>" + born + "</custom><worldbody><body name='mimo_location'><freejoint/>" +
                        "<geom type='capsule' " + capsule + "/><geom type='box' " + box +
                        "/><body name='head' pos='0 0 .2'><geom name='head' " + head +
                        "/></body></body></worldbody></mujoco>");
}

constexpr const char* kSizes = "<numeric name='mimo:born_sizes' data='.03 .05 0 .02 .03 .01 .04 0 0'/>";
constexpr const char* kPlaces = "<numeric name='mimo:born_places' data='0 0 0 .05 0 0 0 0 0'/>";

engine::ModelPtr born() { return infant("size='.03 .05'", "size='.02 .03 .01' pos='.05 0 0'", "size='.04'"); }

engine::ModelPtr grown(const std::string& said = std::string(kSizes) + kPlaces) {
  return infant("size='.06 .08'", "size='.03 .06 .04' pos='.09 0 .01'", "size='.05'", said);
}

Skin skin(const mjModel& model) {
  return Skin(model, {{1, 0.008}, {2, 0.01}}, BornGeoms(model, body::find_body(model, "")));
}

// By the shapes' own rules: the sphere's points go 5/4 as far; the capsule's side is 2 times as thick and 8/5 as long,
// with half spheres at its ends; the box is scaled along each axis.
Vec3 where_it_goes(const Sensor& sensor) {
  const Vec3& at = sensor.position;
  if (sensor.geom == 2) return 1.25 * at;
  if (sensor.geom == 1) return {0.09 + 1.5 * (at.x() - 0.05), 2 * at.y(), 0.01 + 4 * at.z()};
  const double side = std::clamp(at.z(), -0.05, 0.05);
  return {2 * at.x(), 2 * at.y(), 1.6 * side + 2 * (at.z() - side)};
}

TEST(TouchBorn, SensorsMoveWithTheSkin) {
  const engine::ModelPtr young = born(), old = grown();
  const Skin was = skin(*young), is = skin(*old);
  ASSERT_EQ(is.sensors().size(), was.sensors().size());
  int capsule_ends = 0;
  for (std::size_t i = 0; i < is.sensors().size(); ++i) {
    const Sensor& sensor = is.sensors()[i];
    EXPECT_EQ(sensor.geom, was.sensors()[i].geom);
    EXPECT_LT((sensor.position - where_it_goes(was.sensors()[i])).norm(), 1e-15) << i;
    EXPECT_EQ(sensor.frame, was.sensors()[i].frame);
    capsule_ends += sensor.geom == 0 && std::abs(sensor.position.z()) > 0.1399;
  }
  EXPECT_EQ(capsule_ends, 2) << "poles at .08 + .06";
}

TEST(TouchBorn, DistancesAreThoseOfTheSkinAsItIs) {
  const engine::ModelPtr old = grown();
  const Skin is = skin(*old);
  EXPECT_NEAR(is.spacing(2), 0.01 * 1.25, 1e-15);
  // Areas: capsules 4 pi r (r + h), boxes 8 (ab + bc + ca).
  const double pi = std::acos(-1.0);
  const double before = 4 * pi * .03 * .08 + 8 * (.02 * .03 + .03 * .01 + .01 * .02);
  const double after = 4 * pi * .06 * .14 + 8 * (.03 * .06 + .06 * .04 + .04 * .03);
  EXPECT_NEAR(is.spacing(1), 0.008 * std::sqrt(after / before), 1e-15);
  // On the map of the head's uppermost sensor its neighbours are 5/4 as far as they were.
  const engine::ModelPtr young = born();
  const Skin was = skin(*young);
  const int top = is.nearest_of_body(2, Vec3(0, 0, 1));
  ASSERT_EQ(top, was.nearest_of_body(2, Vec3(0, 0, 1)));
  ASSERT_EQ(is.maps().of(top).size(), was.maps().of(top).size());
  for (std::size_t i = 0; i < is.maps().of(top).size(); ++i) {
    EXPECT_NEAR(static_cast<double>(is.maps().of(top)[i].x), 1.25 * static_cast<double>(was.maps().of(top)[i].x), 1e-7);
  }
}

// A document that says nothing is that of an infant that has not grown.
TEST(TouchBorn, ChangesNothingWithoutABirth) {
  const engine::ModelPtr old = grown("");
  const Skin is = skin(*old);
  const Skin plain(*old, {{1, 0.008}, {2, 0.01}});
  ASSERT_EQ(is.sensors().size(), plain.sensors().size());
  EXPECT_GT(is.sensors().size(), skin(*born()).sensors().size());
  for (std::size_t i = 0; i < is.sensors().size(); ++i)
    EXPECT_EQ(is.sensors()[i].position, plain.sensors()[i].position);
}

TEST(TouchBorn, RefusesNumbersThatDoNotFit) {
  const auto refused = [](const std::string& message, const std::string& said) {
    const engine::ModelPtr model = grown(said);
    test::expect_error(Status::kModel, message, [&] { skin(*model); });
  };
  refused("numeric mimo:born_sizes has 6 numbers, expected three for each of the infant's 3 geoms",
          std::string("<numeric name='mimo:born_sizes' data='.03 .05 0 .02 .03 .01'/>") + kPlaces);
  refused("numeric mimo:born_places has 0 numbers", kSizes);
  refused("a size of geom \"head\" is not above 0",
          std::string("<numeric name='mimo:born_sizes' data='.03 .05 0 .02 .03 .01 0 0 0'/>") + kPlaces);
}

}  // namespace
}  // namespace mimo::senses::touch
