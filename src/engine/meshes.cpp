#include "engine/meshes.h"

#include "base/format.h"
#include "engine/model.h"

namespace mimo::engine {

int hull_corners(const std::vector<std::array<double, 3>>& points) {
  std::string numbers;
  for (const auto& point : points) numbers += join(point, " ") + " ";
  const ModelPtr model = compile("<mujoco><asset><mesh name=\"m\" vertex=\"" + numbers +
                                     "\"/></asset><worldbody><geom type=\"mesh\" mesh=\"m\"/></worldbody></mujoco>",
                                 {}, {});
  return model->mesh_graph[model->mesh_graphadr[0]];
}

// No geom touches others with the mesh, so it gets no hull.
std::vector<std::array<double, 3>> vertices_of(const std::string& name, const std::string& bytes) {
  const Asset file{name, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}};
  const ModelPtr model =
      compile("<mujoco><asset><mesh name=\"m\" file=\"" + name + "\"/></asset></mujoco>", {file}, {});
  std::vector<std::array<double, 3>> vertices;
  for (int i = 0; i < model->nmeshvert; ++i) {
    const float* at = model->mesh_vert + static_cast<std::ptrdiff_t>(3) * i;
    vertices.push_back({at[0], at[1], at[2]});
  }
  return vertices;
}

}  // namespace mimo::engine
