// Stages of plain arrays by mimo.hpp.
#include <cmath>
#include <string>
#include <vector>

#include "mimo/mimo.hpp"
#include "support/capi.h"

namespace {

constexpr int kSide = 65, kPixels = kSide * kSide, kMiddle = kPixels / 2;
const double kUpright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
const double kEye[3] = {0, 0, 5};

// A ball of half a metre above a floor 1 m below its middle.
struct Things {
  std::int32_t forms[2] = {MIMO_FORM_SPHERE, MIMO_FORM_PLANE};
  double sizes[6] = {0.5, 0, 0, 0, 0, 0};
  float colors[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  mimo_stage_shapes geoms = mimo::stage_struct<mimo_stage_shapes>();

  Things() {
    geoms.count = 2;
    geoms.object_type = 5;
    geoms.forms = forms;
    geoms.sizes = sizes;
    geoms.colors = colors;
  }
};

struct Places {
  double positions[6] = {0, 0, 0, 0, 0, -1};
  double rotations[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  mimo_stage_poses poses = mimo::stage_struct<mimo_stage_poses>();

  explicit Places(double x) {
    positions[0] = x;
    poses.geom_count = 2;
    poses.geom_positions = positions;
    poses.geom_rotations = rotations;
  }
};

struct Shot {
  std::vector<std::uint8_t> rgb = std::vector<std::uint8_t>(3 * kPixels);
  std::vector<float> depth = std::vector<float>(kPixels);
  mimo_stage_view view = mimo::stage_view();

  explicit Shot(std::uint32_t pose) {
    view.pose = pose;
    view.width = view.height = kSide;
    view.position = kEye;
    view.rotation = kUpright;
    view.rgb = rgb.data();
    view.rgb_bytes = rgb.size();
    view.depth = depth.data();
    view.depth_count = depth.size();
  }
};

void test_pictures() {
  Things things;
  mimo_stage_config config = mimo::stage_struct<mimo_stage_config>();
  config.geoms = &things.geoms;
  mimo::Stage stage(config);
  const Places first(0), second(0.3);
  Shot one(0), other(0), both_first(0), both_second(1);
  stage.draw(first.poses, one.view);
  CHECK_NEAR(4.5, one.depth[kMiddle], 1e-4);
  CHECK_NEAR(6, one.depth[0], 1e-4);
  stage.draw(second.poses, other.view);
  stage.draw({&first.poses, &second.poses}, {&both_first.view, &both_second.view});
  CHECK(one.rgb == both_first.rgb && other.rgb == both_second.rgb && one.rgb != other.rgb);
  things.colors[4] = things.colors[5] = 0;
  stage.update(config);
  stage.draw(first.poses, one.view);
  CHECK(one.rgb[2] > 2 * one.rgb[0]);  // blue, but for highlights
}

void test_errors() {
  Things things;
  mimo_stage_air air = mimo::stage_air();
  mimo_stage_config config = mimo::stage_struct<mimo_stage_config>();
  config.geoms = &things.geoms;
  config.air = &air;
  air.near_plane = 100;
  try {
    mimo::Stage stage(config);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_INVALID_ARGUMENT);
    CHECK(std::string(error.what()).find("air: far_plane is 50, expected more than 100") != std::string::npos);
  }
}

}  // namespace

int main() {
  test_pictures();
  test_errors();
  return failures();
}
