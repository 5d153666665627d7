// What MuJoCo's compiler knows of MJCF, and the meshes, pictures and textures that it reads.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/model.h"

namespace mimo::engine {

// What MuJoCo's compiler knows of MJCF: elements, where they may stand, and their attributes.

struct SchemaElement {
  std::set<std::string, std::less<>> attributes;
  std::map<std::string, SchemaElement, std::less<>> children;
  bool nests = false;  // may hold itself, like <body>
};

// The element <mujoco>, asked of the MuJoCo that runs; the same object every time.
const SchemaElement& schema();

// Whether a MuJoCo 2 runs, whose documents newer versions do not all understand, nor it theirs.
bool is_mujoco_2();

// How many bytes a model can have: MuJoCo 2 counts them in an int, and crashes where that wraps.
double most_model_bytes();

// "MuJoCo 2.2.2", the one that runs.
std::string compiler_name();

// What the compiler makes of meshes, asked of models that have nothing else.

// How many corners the convex hull of points has, which must not be flat.
int hull_corners(const std::vector<std::array<double, 3>>& points);

// The vertices of a mesh's file, "mesh.obj", as they are in there. Throws what compile throws.
std::vector<std::array<double, 3>> vertices_of(const std::string& name, const std::string& bytes);

// Pictures for textures, decoded before a model is compiled.

// Whether the compiler takes decoded pictures, which it knows by any extension but ".png". Newer ones keep what they
// have decoded themselves.
bool takes_decoded();

// PNG files as the compiler's own format: width, height, and three bytes a pixel. In the order given.
using Bytes = std::vector<unsigned char>;
std::vector<Bytes> decode(const std::vector<Asset>& pictures);

// Pictures on surfaces, which make nearly all of a model's bytes.

// The same model; where all its textures are those of another one, it uses these, keeps that one alive for it, and
// holds none of its own.
ModelPtr with_textures_of(const ModelPtr& owner, ModelPtr model);

// Whether they are the same bytes in memory.
bool share_textures(const mjModel& one, const mjModel& other);

}  // namespace mimo::engine
