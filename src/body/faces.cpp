#include "body/faces.h"

#include <algorithm>
#include <string_view>

#include "base/choice.h"
#include "base/fail.h"
#include "base/names.h"

namespace mimo::body {
namespace {

constexpr std::string_view kPrefix = names::kFace;

std::string_view material_name(const mjModel& model, int material) { return model.names + model.name_matadr[material]; }

bool is_face(const mjModel& model, int material) {
  return material >= 0 && material_name(model, material).substr(0, kPrefix.size()) == kPrefix;
}

}  // namespace

const Face& Faces::find(const std::string& name) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Face& face) { return face.name == name; });
  if (geom < 0) fail(Status::kNotFound, "face is \"{}\", but this agent has no face", name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Face& face : all) names.push_back(face.name);
  fail(Status::kNotFound, "no face named \"{}\"; {}", name, choice_of(name, std::move(names)));
}

const Face* Faces::shown(const mjModel& model) const {
  if (geom < 0) return nullptr;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Face& face) { return face.material == model.geom_matid[geom]; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<Face> faces_of(const mjModel& model) {
  std::vector<Face> faces;
  for (int material = 0; material < model.nmat; ++material) {
    if (!is_face(model, material)) continue;
    faces.push_back({std::string(material_name(model, material).substr(kPrefix.size())), material});
  }
  return faces;
}

Faces find_faces(const mjModel& model, const Body& body) {
  Faces faces;
  if (body.head < 0) return faces;
  const int first = model.body_geomadr[body.head];
  for (int geom = first; geom < first + model.body_geomnum[body.head] && faces.geom < 0; ++geom) {
    if (is_face(model, model.geom_matid[geom])) faces.geom = geom;
  }
  faces.all = faces_of(model);
  return faces;
}

}  // namespace mimo::body
