// The seven faces: in one world only, part of its state, and easy to tell apart for another infant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/fail.h"
#include "body/face.h"
#include "render/renderer.h"
#include "support/access.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

constexpr int kPixels = 64;
using Rgb = std::vector<std::uint8_t>;

env::EnvOptions drawn_by(const std::string& renderer) {
  env::EnvOptions options;
  options.renderer = env::renderer_from(renderer);
  return options;
}

std::unique_ptr<env::World> world_with(const std::string& face, const std::string& renderer = "ray") {
  env::AgentOptions agent = blind();
  agent.face = face;
  return benchmark_world(agent, drawn_by(renderer));
}

// The head as an eye sees it: 60 degrees over 64 pixels, from half a metre before the face, or a little aside.
Rgb look_in_the_face(env::World& world, double aside = 0, double above = 0, const std::string& head = "head") {
  const int geom = engine::find_or_fail(world.model(), engine::Kind::kGeom, head);
  const double* at = world.data().geom_xpos + 3 * geom;
  Rgb rgb(3 * kPixels * kPixels);
  render::Picture picture{kPixels, kPixels, rgb.data()};
  render::Viewpoint from;
  from.look_at = {at[0], at[1] + aside, at[2] + above};
  from.distance = 0.5 + world.model().geom_size[3 * geom];
  from.azimuth = 180;
  from.fovy = 60;
  world.draw(from, picture);
  return rgb;
}

std::string face_of(const env::World& world, std::size_t agent = 0) {
  return world.faces()[static_cast<std::size_t>(world.face(agent))].name;
}

void show(env::World& world, const char* face, std::int32_t agent = 0) {
  set(world, MIMO_AGENT_FACE, {agent}, {static_cast<double>(id_of(world, MIMO_FACE, face))});
}

// Sum of the differences of all colours, 0 to 255 each.
long difference(const Rgb& a, const Rgb& b) {
  long sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum;
}

// Pixels that differ by at least an eighth of the range in some colour.
int clearly_different(const Rgb& a, const Rgb& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(a[k] - b[k]));
    count += most >= 32;
  }
  return count;
}

class Faces : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      env::make_renderer(benchmark_model(), drawn_by(GetParam()), {});
    } catch (const Error& error) {
      if (error.status() != Status::kUnsupported) throw;
      GTEST_SKIP() << error.message();
    }
  }
};

// Half a metre away a pixel is 9 mm wide and the whole head 16 pixels. Whoever saw the faces once knows them again when
// the head is a quarter of a pixel, a half or a whole one elsewhere.
TEST_P(Faces, AreToldApartByAnInfant) {
  std::vector<Rgb> known;
  for (const char* face : body::kFaces) known.push_back(look_in_the_face(*world_with(face, GetParam())));
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(clearly_different(known[i], known[k]), 6) << body::kFaces[i] << " and " << body::kFaces[k];
    }
    const auto world = world_with(body::kFaces[i], GetParam());
    for (const auto& [aside, above] : {std::pair{0.002, 0.0}, {0.0045, -0.002}, {-0.0045, 0.0045}, {0.009, 0.0}}) {
      const Rgb seen = look_in_the_face(*world, aside, above);
      std::vector<long> far;
      for (const Rgb& other : known) far.push_back(difference(seen, other));
      const auto nearest = std::min_element(far.begin(), far.end()) - far.begin();
      EXPECT_STREQ(body::kFaces[static_cast<std::size_t>(nearest)], body::kFaces[i]) << aside << " " << above;
    }
  }
}

TEST_P(Faces, BelongToOneWorld) {
  const auto one = world_with("", GetParam()), two = world_with("", GetParam());
  const Rgb neutral = look_in_the_face(*one);
  EXPECT_EQ(face_of(*one), "neutral");
  show(*one, "anger");
  EXPECT_EQ(face_of(*one), "anger");
  EXPECT_EQ(face_of(*two), "neutral");
  EXPECT_EQ(look_in_the_face(*two), neutral);
  const Rgb angry = look_in_the_face(*one);
  EXPECT_NE(angry, neutral);
  one->reset(nullptr, nullptr);
  EXPECT_EQ(face_of(*one), "anger");
  EXPECT_EQ(look_in_the_face(*one), angry);
  show(*one, "neutral");
  EXPECT_EQ(look_in_the_face(*one), neutral);
}

INSTANTIATE_TEST_SUITE_P(Render, Faces, ::testing::Values("ray", "osmesa"));

TEST(Faces, ArePartOfTheState) {
  const auto glad = world_with("enjoyment"), plain = world_with("");
  Bytes state(glad->state_bytes()), before(plain->state_bytes());
  glad->save(Span<std::uint8_t>(state));
  plain->save(Span<std::uint8_t>(before));
  EXPECT_NE(state, before);
  plain->load(Span<const std::uint8_t>(state));
  EXPECT_EQ(face_of(*plain), "enjoyment");
  EXPECT_EQ(look_in_the_face(*plain), look_in_the_face(*glad));
  plain->load(Span<const std::uint8_t>(before));
  EXPECT_EQ(face_of(*plain), "neutral");
}

TEST(Faces, EachAgentHasItsOwn) {
  scene::Scene scene(named("free"));
  const document::Pose here{{0, 0, 0.4}, {1, 0, 0, 0}}, there{{0, 1, 0.4}, {1, 0, 0, 0}};
  scene.add_body("mitten", "anna/", &here);
  scene.add_body("mitten", "ben/", &there);
  env::AgentOptions anna = blind(), ben = blind();
  anna.name = "anna";
  ben.name = "ben";
  ben.face = "fear";
  env::World world(compile(scene), {anna, ben}, drawn_by("ray"));
  EXPECT_EQ(face_of(world, 0), "neutral");
  EXPECT_EQ(face_of(world, 1), "fear");
  const Rgb before = look_in_the_face(world, 0, 0, "anna/head");
  show(world, "anger", 1);
  EXPECT_EQ(look_in_the_face(world, 0, 0, "anna/head"), before);
  show(world, "anger", 0);
  EXPECT_NE(look_in_the_face(world, 0, 0, "anna/head"), before);
}

TEST(Faces, Unknown) {
  const auto world = world_with("");
  try {
    show(*world, "boredom");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kNotFound);
    EXPECT_NE(error.message().find("neutral, enjoyment, sadness, surprise, disgust, anger, fear"), std::string::npos)
        << error.message();
  }
  EXPECT_EQ(face_of(*world), "neutral");
  EXPECT_THROW(world_with("boredom"), Error);
}

}  // namespace
}  // namespace mimo::test
