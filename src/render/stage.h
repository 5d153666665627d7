// What is drawn, as plain arrays: shapes, materials, textures, lights, and where they are. Nothing is owned, and
// nothing here knows a simulation. Models of MuJoCo become one in model_stage.h; hosts give their own through the C
// API.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace mimo::render {

// Types of shapes, as MuJoCo numbers them.
enum ShapeType : int {
  kPlaneShape = 0,
  kFieldShape = 1,
  kSphereShape = 2,
  kCapsuleShape = 3,
  kEllipsoidShape = 4,
  kCylinderShape = 5,
  kBoxShape = 6,
  kMeshShape = 7,
  kDistanceShape = 8,  // drawn as its mesh
};

// Groups are 0 to 5; a mask has a bit for each that is shown.
constexpr unsigned kUsualGroups = 0x7;
inline bool is_shown(int group, unsigned mask = kUsualGroups) { return (mask >> std::clamp(group, 0, 5) & 1U) != 0; }

// Pointers are of arrays with one entry (or as many as are said) for each.
struct Shapes {
  int count = 0;
  const int* types = nullptr;
  const double* sizes = nullptr;   // 3
  const float* colors = nullptr;   // 4
  const int* materials = nullptr;  // -1: none
  const int* groups = nullptr;     // null: all 0
  const int* data = nullptr;       // which mesh or field; null: none has one
  int first_id = -1;               // what segmentation shows of the first, counting up; -1: of all
  unsigned shown = kUsualGroups;   // groups
  bool prescaled = false;          // planes and meshes have textures by their size, as MuJoCo's geoms have
};

struct Materials {
  int count = 0;
  const float* colors = nullptr;  // 4
  const float* emission = nullptr;
  const float* specular = nullptr;
  const float* shininess = nullptr;
  const float* reflectance = nullptr;
  const int* textures = nullptr;   // of colour, -1: none
  int texture_stride = 1;          // from one material to the next
  const float* repeats = nullptr;  // 2
  const unsigned char* uniform = nullptr;
  bool from_corner = false;  // flat textures begin at a corner of a shape, not in its middle
};

enum TextureType : int { kFlatTexture = 0, kCubeTexture = 1, kSkyTexture = 2 };

// Their pixels lie one after the other.
struct Textures {
  int count = 0;
  const int* types = nullptr;
  const int* widths = nullptr;
  const int* heights = nullptr;
  const int* channels = nullptr;  // null: 3
  const unsigned char* pixels = nullptr;
  const int* color_spaces = nullptr;    // MuJoCo's: 2 of flat textures that are coded by sRGB; null:
  const unsigned char* srgb = nullptr;  // instead; null: none is

  // MuJoCo draws cubes and skies as they are.
  bool is_srgb(int i) const {
    if (color_spaces != nullptr) return color_spaces[i] == 2 && types[i] == kFlatTexture;
    return srgb != nullptr && srgb[i] != 0;
  }
};

struct Meshes {
  int count = 0;
  const int* first_vertex = nullptr;
  const int* first_normal = nullptr;
  const int* first_texcoord = nullptr;  // -1: has none
  const int* first_triangle = nullptr;
  const int* triangle_count = nullptr;
  const float* vertices = nullptr;   // 3
  const float* normals = nullptr;    // 3
  const float* texcoords = nullptr;  // 2
  // Corners: counted from the mesh's first.
  const int* triangles = nullptr;           // 3
  const int* normal_triangles = nullptr;    // 3
  const int* texcoord_triangles = nullptr;  // 3
};

struct Fields {
  int count = 0;
  const int* rows = nullptr;
  const int* columns = nullptr;
  const int* first = nullptr;
  const double* sizes = nullptr;  // 4
  const float* heights = nullptr;
};

struct Lights {
  int count = 0;
  const int* types = nullptr;                  // 1: directional; null:
  const unsigned char* directional = nullptr;  // instead
  const unsigned char* active = nullptr;
  const unsigned char* casts_shadow = nullptr;
  const float* ambient = nullptr;      // 3
  const float* diffuse = nullptr;      // 3
  const float* specular = nullptr;     // 3
  const float* attenuation = nullptr;  // 3
  const float* cutoff = nullptr;       // degrees
  const float* exponent = nullptr;

  bool is_directional(int i) const { return types != nullptr ? types[i] == 1 : directional[i] != 0; }
};

// Lengths are metres, colours three numbers.
struct Air {
  double near_plane = 0.01, far_plane = 50;
  double fog_start = 3, fog_length = 7;
  double haze = 0.3;
  const float* fog_color = nullptr;
  const float* haze_color = nullptr;
  bool headlight = true;
  const float* ambient = nullptr;  // of the headlight
  const float* diffuse = nullptr;
  const float* specular = nullptr;
  double sun_reach = 0;  // of the shadows of parallel light, from its position and axis; 0: everywhere
};

struct Stage {
  Shapes geoms, sites;
  Materials materials;
  Textures textures;
  Meshes meshes;
  Fields fields;
  Lights lights;
  Air air;
};

// Positions and row-major rotations.
struct Places {
  const double* positions = nullptr;  // 3
  const double* rotations = nullptr;  // 9
};

struct Poses {
  Places geoms, sites;
  const double* light_positions = nullptr;   // 3
  const double* light_directions = nullptr;  // 3
};

}  // namespace mimo::render
