/**
 * @file mimo/hpp/geometry.hpp
 * For programs that draw the world themselves: triangles, textures. Part of mimo.hpp, which programs
 * include. MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_GEOMETRY
#define MIMO_HPP_GEOMETRY

#include <cstdint>
#include <vector>

#include "../experimental.h"
#include "handles.hpp"

namespace mimo {
inline namespace v1_0 {

/// A geom as triangles, see mimo_mesh.
struct Mesh {
  std::vector<float> positions;        ///< Three for each vertex.
  std::vector<float> normals;          ///< Three for each vertex.
  std::vector<float> texcoords;        ///< Two for each vertex.
  std::vector<std::uint32_t> indices;  ///< Three for each triangle.
};

/// A texture as pixels, see mimo_texture.
struct Texture {
  std::int32_t type;  ///< A MIMO_TEXTURE_ constant.
  std::uint32_t width, height;
  std::vector<std::uint8_t> pixels;  ///< Red, green, blue, 255 of each pixel, row after row.
};

namespace detail {
inline Mesh mesh_of(const mimo_env *env, std::int32_t geom, std::int32_t axes, std::uint32_t segments, double plane) {
  mimo_mesh raw = {};
  check(mimo_mesh_init(&raw, sizeof raw));
  raw.axes = axes;
  raw.segments = segments;
  raw.plane = plane;
  check(mimo_env_mesh(env, geom, &raw));
  Mesh mesh;
  mesh.positions.resize(3 * raw.vertex_count);
  mesh.normals.resize(3 * raw.vertex_count);
  mesh.texcoords.resize(2 * raw.vertex_count);
  mesh.indices.resize(raw.index_count);
  raw.positions = mesh.positions.data();
  raw.normals = mesh.normals.data();
  raw.texcoords = mesh.texcoords.data();
  raw.indices = mesh.indices.data();
  raw.vertex_capacity = raw.vertex_count;
  raw.index_capacity = raw.index_count;
  check(mimo_env_mesh(env, geom, &raw));
  return mesh;
}

inline Texture texture_of(const mimo_env *env, std::int32_t id) {
  mimo_texture raw = {};
  raw.struct_size = sizeof raw;
  check(mimo_env_texture(env, id, &raw));
  Texture texture = {raw.type, raw.width, raw.height, {}};
  texture.pixels.resize(std::size_t(4) * raw.width * raw.height);
  raw.pixels = texture.pixels.data();
  raw.pixel_bytes = texture.pixels.size();
  check(mimo_env_texture(env, id, &raw));
  return texture;
}
}  // namespace detail

}  // namespace v1_0
}  // namespace mimo

#endif
