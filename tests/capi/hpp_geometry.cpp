// mimo.hpp: shapes, materials, textures, lights and poses are what the C functions below them give.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <mimo/mimo.hpp>
#include <stdexcept>
#include <string>

#include "support/capi.h"

namespace {

void check_meshes(const mimo::Env& env) {
  const std::int32_t head = env.find(MIMO_GEOM, "head");
  const mimo::Mesh mesh = env.mesh(head), fine = env.mesh(head, MIMO_AXES_UNITY, 48);
  CHECK(!mesh.indices.empty() && mesh.positions.size() == mesh.normals.size());
  CHECK(mesh.positions.size() / 3 == mesh.texcoords.size() / 2);
  CHECK(fine.indices.size() > mesh.indices.size());
  const double radius = env.get_values(MIMO_GEOM_SIZE, {head})[0];
  double least = 1, most = 0;
  for (std::size_t i = 0; i < fine.positions.size(); i += 3) {
    const float* p = &fine.positions[i];
    const double far = std::sqrt(double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2]);
    least = std::min(least, far);
    most = std::max(most, far);
  }
  CHECK_NEAR(radius, most, 1e-6);  // corners lie on the sphere, and where textures are cut between them a little within
  CHECK(least > 0.99 * radius);
  try {
    env.mesh(head, MIMO_AXES_UNITY, 6);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(std::strstr(error.what(), "segments is 6") != nullptr);
  }
}

void check_materials(mimo::Env& env) {
  const std::int32_t head = env.find(MIMO_GEOM, "head");
  const mimo_appearance before = env.appearance(head);
  env.set_face("surprise");
  CHECK(before.visible == 1 && before.texture >= 0 && before.texture != env.appearance(head).texture);
  CHECK(static_cast<std::size_t>(before.texture) < env.texture_count());
  const mimo::Texture texture = env.texture(before.texture);
  CHECK(texture.type == MIMO_TEXTURE_CUBE && texture.height == 6 * texture.width);
  CHECK(texture.pixels.size() == std::size_t(4) * texture.width * texture.height && texture.pixels[3] == 255);
}

void check_places(const mimo::Env& env) {
  std::vector<float> ours = env.poses(MIMO_BODY), unity = env.poses(MIMO_BODY, MIMO_AXES_UNITY);
  CHECK(ours.size() == 7 * env.count(MIMO_BODY) && ours.size() == unity.size());
  for (std::size_t i = 0; i < ours.size(); i += 7) CHECK(unity[i] == -ours[i + 1] && unity[i + 1] == ours[i + 2]);
  std::vector<float> points = {1, 2, 3}, directions = points;
  mimo::convert_points(MIMO_AXES_UNREAL, points);
  mimo::convert_directions(MIMO_AXES_UNREAL, directions);
  CHECK(points[1] == -200.0F && directions[1] == -2.0F);
  float one[] = {1, 2, 3, 1, 0, 0, 0};  // a pose without a vector
  mimo::convert_poses(MIMO_AXES_UNREAL, one, 1);
  CHECK(one[1] == -200.0F && one[3] == 0.0F && one[6] == 1.0F);
  mimo::convert_points(MIMO_AXES_UNREAL, one, 1);
  CHECK(one[1] == 20000.0F);
  mimo::convert_directions(MIMO_AXES_UNREAL, one, 2);
  CHECK(one[1] == -20000.0F && one[2] == 30000.0F && one[6] == 1.0F);
  points.push_back(1);
  std::string told;
  try {
    mimo::convert_points(MIMO_AXES_UNREAL, points);
  } catch (const std::invalid_argument& error) {
    told = error.what();
  }
  CHECK(told == "points has 4 numbers, expected a multiple of 3");
  CHECK(env.light(MIMO_HEADLIGHT).directional == 1);
  CHECK(env.count(MIMO_LIGHT) > 0 && env.light(0, MIMO_AXES_GODOT).axes == MIMO_AXES_GODOT);
}

}  // namespace

int main() {
  mimo::Env env = mimo::make("benchmark");
  check_meshes(env);
  check_materials(env);
  check_places(env);
  return failures();
}
