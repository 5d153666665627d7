#include "render/paint.h"

#include <algorithm>

#include "compat/mujoco.h"

namespace mimo::render {

Paint paint_of(const mjModel& model, int material, const float* rgba) {
  Paint paint;
  // MuJoCo takes an element's own colour only where it differs from the default.
  const bool is_default = rgba[0] == 0.5F && rgba[1] == 0.5F && rgba[2] == 0.5F && rgba[3] == 1.0F;
  std::copy_n(material >= 0 && is_default ? model.mat_rgba + 4 * material : rgba, 4, paint.color.begin());
  if (material < 0) return paint;
  paint.emission = model.mat_emission[material];
  paint.specular = model.mat_specular[material];
  paint.shininess = model.mat_shininess[material];
  paint.reflectance = model.mat_reflectance[material];
  paint.texture = compat::color_texture(model, material);
  return paint;
}

bool form_of(int type, Form& form) {
  switch (type) {
    case mjGEOM_PLANE: form = Form::kPlane; return true;
    case mjGEOM_SPHERE: form = Form::kSphere; return true;
    case mjGEOM_CAPSULE: form = Form::kCapsule; return true;
    case mjGEOM_ELLIPSOID: form = Form::kEllipsoid; return true;
    case mjGEOM_CYLINDER: form = Form::kCylinder; return true;
    case mjGEOM_BOX: form = Form::kBox; return true;
    case mjGEOM_MESH:
    case mjGEOM_HFIELD:
    case mjGEOM_SKIN: form = Form::kMesh; return true;
    default: return false;
  }
}

bool is_shown(int group) { return std::clamp(group, 0, 5) <= 2; }

}  // namespace mimo::render
