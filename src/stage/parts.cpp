#include "stage/parts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "stage/arrays.h"

namespace mimo::stage {
namespace {

std::vector<float> shares(const Arrays& arrays, const float* given, const char* name, float standard, double most = 1) {
  std::vector<float> result = arrays.copy_or<float>(given, name, {standard});
  arrays.check(result.data(), name, 1, 0, most, most == 1 ? kShare : kColor);
  return result;
}

bool is_mesh(int form) { return form == MIMO_FORM_MESH || form == MIMO_FORM_DISTANCE; }

bool is_form(int form) { return form >= MIMO_FORM_PLANE && form <= MIMO_FORM_DISTANCE; }

}  // namespace

// ---- Shapes, materials, lights, tendons ---------------------------------------------------------------------

Shapes::Shapes(const mimo_stage_shapes& given, const char* part) : object_type(given.object_type) {
  const Arrays arrays(part, given.count);
  forms = arrays.copy(given.forms, "forms");
  sizes = arrays.copy(given.sizes, "sizes", 3);
  arrays.check(sizes.data(), "sizes", 3, 0, kFarthest, kLength);
  arrays.take_looks(given, *this);
  data = arrays.copy_or<int>(given.data, "data", {-1});
}

render::Shapes Shapes::view() const {
  render::Shapes view;
  view.count = static_cast<int>(forms.size());
  view.types = forms.data();
  view.sizes = sizes.data();
  view.colors = colors.data();
  view.materials = materials.data();
  view.groups = groups.data();
  view.data = data.data();
  return view;
}

Materials::Materials(const mimo_stage_materials& given) {
  const Arrays arrays("materials", given.count);
  colors = arrays.copy(given.colors, "colors", 4);
  arrays.check(colors.data(), "colors", 4, 0, kMostNumber, kColor);
  emission = shares(arrays, given.emission, "emission", 0, kMostNumber);
  specular = shares(arrays, given.specular, "specular", 0.5F, kMostNumber);
  shininess = shares(arrays, given.shininess, "shininess", 0.5F, kMostNumber);
  reflectance = shares(arrays, given.reflectance, "reflectance", 0);
  textures = arrays.copy_or<int>(given.textures, "textures", {-1});
  repeats = arrays.copy_or<float>(given.repeats, "repeats", {1, 1});
  arrays.check(repeats.data(), "repeats", 2, -kMostNumber, kMostNumber, "-1e6 to 1e6");
  uniform = arrays.copy_or<unsigned char>(given.uniform, "uniform", {0});
  require(given.from_corner <= 1, "materials: from_corner is {}, expected 0 or 1", given.from_corner);
  from_corner = given.from_corner != 0;
}

render::Materials Materials::view() const {
  render::Materials view;
  view.count = static_cast<int>(textures.size());
  view.colors = colors.data();
  view.emission = emission.data();
  view.specular = specular.data();
  view.shininess = shininess.data();
  view.reflectance = reflectance.data();
  view.textures = textures.data();
  view.repeats = repeats.data();
  view.uniform = uniform.data();
  view.from_corner = from_corner;
  return view;
}

Lights::Lights(const mimo_stage_lights& given) {
  const Arrays arrays("lights", given.count);
  const auto rgb = [&](const float* from, const char* name, const std::vector<float>& standard) {
    std::vector<float> values = arrays.copy_or<float>(from, name, standard);
    arrays.check(values.data(), name, 3, 0, kMostNumber, kColor);
    return values;
  };
  types = arrays.copy(given.types, "types");
  active = arrays.copy_or<unsigned char>(given.active, "active", {1});
  for (std::size_t i = 0; i < types.size(); ++i)
    active[i] = active[i] != 0 && types[i] >= 0 && types[i] <= MIMO_LAMP_POINT;
  casts_shadow = arrays.copy_or<unsigned char>(given.casts_shadow, "casts_shadow", {1});
  ambient = rgb(given.ambient, "ambient", {0, 0, 0});
  diffuse = rgb(given.diffuse, "diffuse", {0.7F, 0.7F, 0.7F});
  specular = rgb(given.specular, "specular", {0.3F, 0.3F, 0.3F});
  attenuation = rgb(given.attenuation, "attenuation", {1, 0, 0});
  cutoff = shares(arrays, given.cutoff, "cutoff", 45, kMostNumber);
  exponent = shares(arrays, given.exponent, "exponent", 10, kMostNumber);
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] == MIMO_LAMP_POINT) cutoff[i] = 180;
  }
}

render::Lights Lights::view() const {
  render::Lights view;
  view.count = static_cast<int>(types.size());
  view.types = types.data();
  view.active = active.data();
  view.casts_shadow = casts_shadow.data();
  view.ambient = ambient.data();
  view.diffuse = diffuse.data();
  view.specular = specular.data();
  view.attenuation = attenuation.data();
  view.cutoff = cutoff.data();
  view.exponent = exponent.data();
  return view;
}

Tendons::Tendons(const mimo_stage_tendons& given) : object_type(given.object_type) {
  const Arrays arrays("tendons", given.count);
  widths = arrays.copy(given.widths, "widths");
  arrays.check(widths.data(), "widths", 1, 0, kFarthest, kLength);
  arrays.take_looks(given, *this);
}

// ---- All parts together -------------------------------------------------------------------------------------

mimo_stage_air default_air() {
  mimo_stage_air air{};
  air.struct_size = sizeof air;
  air.headlight = 1;
  air.near_plane = 0.01;
  air.far_plane = 50;
  air.fog_start = 3;
  air.fog_end = 10;
  air.haze = 0.3;
  std::fill_n(air.haze_color, 3, 1.0F);
  std::fill_n(air.ambient, 3, 0.1F);
  std::fill_n(air.diffuse, 3, 0.4F);
  std::fill_n(air.specular, 3, 0.5F);
  return air;
}

namespace {

void check_air(const mimo_stage_air& air) {
  const auto check = [](const char* name, double value, double low, double high, const char* expected) {
    require(value >= low && value <= high, "air: {} is {}, expected {}", name, value, expected);
  };
  require(air.headlight <= 1, "air: headlight is {}, expected 0 or 1", air.headlight);
  require(air.reserved == 0, "air: reserved is {}, expected 0", air.reserved);
  check("near_plane", air.near_plane, 1e-12, kFarthest, "metres above 0");
  require(air.far_plane > air.near_plane && air.far_plane <= kFarthest,
          "air: far_plane is {}, expected more than {}, near_plane", air.far_plane, air.near_plane);
  check("fog_start", air.fog_start, 0, kFarthest, kLength);
  check("fog_end", air.fog_end, 0, kFarthest, kLength);
  check("haze", air.haze, 0, 1, kShare);
  check("sun_reach", air.sun_reach, 0, kFarthest, kLength);
  const Arrays three("air", 1);
  three.check(air.fog_color, "fog_color", 3, 0, kMostNumber, kColor);
  three.check(air.haze_color, "haze_color", 3, 0, kMostNumber, kColor);
  three.check(air.ambient, "ambient", 3, 0, kMostNumber, kColor);
  three.check(air.diffuse, "diffuse", 3, 0, kMostNumber, kColor);
  three.check(air.specular, "specular", 3, 0, kMostNumber, kColor);
}

// A part that is given, or an empty one where there is none yet.
template <typename Part, typename Struct, typename... Name>
bool renew(std::shared_ptr<const Part>& part, const Struct* given, Name... name) {
  if (given != nullptr) {
    part = std::make_shared<const Part>(*given, name...);
  } else if (part == nullptr) {
    part = std::make_shared<const Part>(Struct{}, name...);
  } else {
    return false;
  }
  return true;
}

}  // namespace

Parts::Parts(const Given& given) { take(given); }

Parts::Parts(const Parts& other, const Given& given) : Parts(other) { take(given); }

void Parts::take(const Given& given) {
  renew(geoms_, given.geoms, "geoms");
  renew(sites_, given.sites, "sites");
  renew(materials_, given.materials);
  renew(tendons_, given.tendons);
  renew(lights_, given.lights);
  bool changed = renew(meshes_, given.meshes);
  changed = renew(fields_, given.fields) || changed;
  changed = renew(textures_, given.textures) || changed;
  changed = renew(surfaces_, given.surfaces) || changed;
  if (given.air != nullptr) {
    check_air(*given.air);
    air_ = *given.air;
  }
  check();
  if (!changed) return;
  assets_ = std::make_shared<const rays::Assets>(textures_->made, meshes_->made, fields_->made, surfaces_->moving);
}

void Parts::check() const {
  const auto check_materials = [&](const char* part, const std::vector<int>& used) {
    Arrays(part, used.size()).check_index(used, "materials", materials(), "a material");
  };
  for (const auto& [part, shapes] : {std::pair{"geoms", geoms_.get()}, {"sites", sites_.get()}}) {
    check_materials(part, shapes->materials);
    const Arrays arrays(part, shapes->forms.size());
    for (std::size_t i = 0; i < shapes->forms.size(); ++i) {
      if (is_mesh(shapes->forms[i])) arrays.check_one(shapes->data[i], i, "data", meshes_->count, "a mesh");
      if (shapes->forms[i] == MIMO_FORM_FIELD) {
        arrays.check_one(shapes->data[i], i, "data", fields_->count, "a height field");
      }
    }
  }
  check_materials("surfaces", surfaces_->materials);
  check_materials("tendons", tendons_->materials);
  Arrays("materials", materials_->textures.size())
      .check_index(materials_->textures, "textures", textures_->count, "a texture");
}

render::Stage Parts::view() const {
  render::Stage stage;
  stage.geoms = geoms_->view();
  stage.geoms.first_id = 0;
  stage.geoms.prescaled = true;
  stage.sites = sites_->view();
  stage.sites.first_id = stage.geoms.count;
  stage.materials = materials_->view();
  stage.lights = lights_->view();
  render::Air& air = stage.air;
  air.near_plane = air_.near_plane;
  air.far_plane = air_.far_plane;
  air.fog_start = air_.fog_start;
  air.fog_length = air_.fog_end - air_.fog_start;
  air.haze = air_.haze;
  air.fog_color = air_.fog_color;
  air.haze_color = air_.haze_color;
  air.headlight = air_.headlight != 0;
  air.ambient = air_.ambient;
  air.diffuse = air_.diffuse;
  air.specular = air_.specular;
  air.sun_reach = air_.sun_reach;
  return stage;
}

std::vector<std::string> Parts::omissions() const {
  std::vector<std::string> lines;
  for (const auto& [part, shapes] : {std::pair{"geom", geoms_.get()}, {"site", sites_.get()}}) {
    for (std::size_t i = 0; i < shapes->forms.size(); ++i) {
      if (is_form(shapes->forms[i])) continue;
      lines.push_back(format("{} {} is not drawn: its form is {}, expected 0 to 8", part, i, shapes->forms[i]));
    }
  }
  int on = air_.headlight != 0 ? 1 : 0;
  for (std::size_t i = 0; i < lights_->types.size(); ++i) {
    const int type = lights_->types[i];
    if (type < 0 || type > MIMO_LAMP_POINT) {
      lines.push_back(format("light {} is not drawn: its type is {}, expected 0 to 2", i, type));
    } else if (lights_->active[i] != 0 && ++on > rays::kMaxLights) {
      lines.push_back(format("light {} is not drawn: a picture has at most {} lights", i, rays::kMaxLights));
    }
  }
  return lines;
}

}  // namespace mimo::stage
