// MuJoCo's skins: triangles that follow several bodies, so that they lie differently in every picture.
#pragma once

#include <array>
#include <vector>

#include "engine/model.h"
#include "rays/meshes.h"
#include "rays/vectors.h"

namespace mimo::rays {

// A skin in the model's reference pose. Which triangles a box of its tree holds is settled there, once for a model:
// pictures do not depend on those before.
class SkinPattern {
 public:
  SkinPattern(const mjModel& model, int id, const float* vertices);

  const Mesh& mesh() const { return mesh_; }
  // Moves the corners of a copy of the mesh to where the skin's vertices are now. Returns the place around which it
  // lies.
  Vec drape(const float* vertices, const float* normals, Mesh& mesh) const;

 private:
  Mesh mesh_;
  std::vector<std::array<int, 3>> corners_;  // vertices of the mesh's triangles
};

// Of all skins of a model.
std::vector<SkinPattern> skin_patterns(const engine::ModelPtr& model);

}  // namespace mimo::rays
