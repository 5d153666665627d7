// Pictures of small models, drawn by the ray renderer.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/format.h"
#include "engine/physics.h"
#include "rays/renderer.h"
#include "render/renderer.h"

namespace mimo::test {

constexpr double kPi = 3.14159265358979323846;

struct Shot {
  int width, height;
  std::vector<std::uint8_t> rgb;
  std::vector<float> depth;
  std::vector<std::int32_t> ids;

  Shot(int w, int h)
      : width(w),
        height(h),
        rgb(static_cast<std::size_t>(w) * h * 3),
        depth(static_cast<std::size_t>(w) * h),
        ids(static_cast<std::size_t>(w) * h) {}
  render::Picture picture() { return {width, height, rgb.data(), depth.data(), ids.data()}; }
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
  int id(int x, int y) const { return ids[at(x, y)]; }
  int middle_id() const { return id(width / 2, height / 2); }
  std::array<int, 3> color(int x, int y) const {
    const std::uint8_t* c = rgb.data() + 3 * at(x, y);
    return {c[0], c[1], c[2]};
  }
  std::array<int, 3> middle() const { return color(width / 2, height / 2); }
};

// A model at rest, and pictures of it.
class Studio {
 public:
  explicit Studio(const std::string& xml, const rays::Options& options = {})
      : Studio(engine::compile(xml, {}, {}), options) {}
  Studio(engine::ModelPtr model, const rays::Options& options)
      : model_(std::move(model)), physics_(model_, {}), renderer_(rays::make_renderer(model_, options)) {
    physics_.forward();
  }

  const mjModel& model() const { return *model_; }
  mjModel& change() { return const_cast<mjModel&>(*model_); }  // nobody else has it
  engine::Physics& physics() { return physics_; }
  render::Renderer& renderer() { return *renderer_; }

  // An odd number of pixels a side: one is in the middle.
  Shot shoot(const render::View& view, int width = 33, int height = 33) {
    Shot shot(width, height);
    renderer_->draw(*model_, physics_.data(), view, shot.picture());
    return shot;
  }

 private:
  engine::ModelPtr model_;
  engine::Physics physics_;
  std::unique_ptr<render::Renderer> renderer_;
};

// A scene with a dark headlight, near plane 1 cm, far plane 50 m, where `visual` does not say otherwise.
inline std::string world(const std::string& body, const std::string& assets = "", const std::string& visual = "") {
  const auto unless_given = [&visual](const std::string& element, const std::string& attributes) {
    return visual.find("<" + element + " ") == std::string::npos ? "<" + element + " " + attributes + "/>" : "";
  };
  return "<mujoco><statistic extent='1' center='0 0 0'/><visual>" +
         unless_given("headlight", "ambient='0 0 0' diffuse='0 0 0' specular='0 0 0'") +
         unless_given("map", "znear='0.01' zfar='50'") + "<quality offsamples='0'/>" + visual +
         "</visual><asset><material name='mat' specular='0' shininess='0'/>" + assets + "</asset><worldbody>" + body +
         "</worldbody></mujoco>";
}

// Straight down at the origin from a height.
inline render::View from_above(double height, double fovy = 40) {
  return render::orbit_view({0, 0, 0}, height, 90, -90, fovy);
}

inline ::testing::AssertionResult color_near(const std::array<double, 3>& expected, const std::array<int, 3>& actual,
                                             double tolerance = 1.01) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(std::min(expected[k], 1.0) * 255 - actual[k]) > tolerance) {
      return ::testing::AssertionFailure()
             << format("{} {} {} expected, drawn {} {} {}", expected[0] * 255, expected[1] * 255, expected[2] * 255,
                       actual[0], actual[1], actual[2]);
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace mimo::test
