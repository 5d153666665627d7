#include "stage/poses.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/format.h"
#include "stage/arrays.h"

namespace mimo::stage {
namespace {

// Numbers of one array of the poses. The usual case costs one comparison each.
template <typename T>
void check_numbers(const T* values, std::size_t length, std::size_t width, const char* name, std::size_t which,
                   double least = -kFarthest) {
  for (std::size_t i = 0; i < length; ++i) {
    if (values[i] >= least && values[i] <= kFarthest) continue;
    fail(Status::kInvalidArgument, "poses[{}]: {} is {}, expected a finite number{}", which, place_in(name, i, width),
         values[i], least == 0 ? ", 0 or more" : "");
  }
}

void check_there(const void* array, std::size_t count, const char* name, const char* of, std::size_t which) {
  require(array != nullptr || count == 0, "poses[{}]: {} is NULL, but {} is {}", which, name, of, count);
}

void check_count(std::size_t count, std::size_t expected, const char* name, std::size_t which) {
  require(count == 0 || count == expected, "poses[{}]: {} is {}, expected {}, or 0", which, name, count, expected);
}

struct Names {
  const char *count, *positions, *rotations, *quaternions;
};

void check_places(std::size_t count, const double* positions, const double* rotations, const double* quaternions,
                  std::size_t expected, const Names& names, std::size_t which) {
  check_count(count, expected, names.count, which);
  if (count == 0) return;
  check_there(positions, count, names.positions, names.count, which);
  require((rotations == nullptr) != (quaternions == nullptr), "poses[{}]: {} and {} are {}, expected one of them",
          which, names.rotations, names.quaternions, rotations == nullptr ? "NULL" : "both given");
  check_numbers(positions, 3 * count, 3, names.positions, which);
  if (rotations != nullptr) return check_numbers(rotations, 9 * count, 9, names.rotations, which);
  check_numbers(quaternions, 4 * count, 4, names.quaternions, which);
  for (std::size_t i = 0; i < count; ++i) {
    const double* q = quaternions + 4 * i;
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    require(std::abs(square - 1) < 1e-3, "poses[{}]: {}[{}] has a length of {}, expected 1", which, names.quaternions,
            i, std::sqrt(square));
  }
}

void check_tendons(const Parts& parts, const mimo_stage_poses& poses, std::size_t which) {
  check_count(poses.tendon_count, parts.tendons().widths.size(), "tendon_count", which);
  if (poses.tendon_count == 0) return;
  check_there(poses.tendon_first, poses.tendon_count, "tendon_first", "tendon_count", which);
  check_there(poses.tendon_points, poses.tendon_count, "tendon_points", "tendon_count", which);
  require(poses.path_count <= kMostPoints, "poses[{}]: path_count is {}, expected at most {}", which, poses.path_count,
          kMostPoints);
  check_there(poses.path_points, poses.path_count, "path_points", "path_count", which);
  for (std::size_t i = 0; i < poses.tendon_count; ++i) {
    const int points = poses.tendon_points[i], first = poses.tendon_first[i];
    require(points >= 0 && static_cast<std::size_t>(points) <= poses.path_count,
            "poses[{}]: tendon_points[{}] is {}, expected 0 to {}, path_count", which, i, points, poses.path_count);
    require(points == 0 ||
                (first >= 0 && static_cast<std::size_t>(first) + static_cast<std::size_t>(points) <= poses.path_count),
            "poses[{}]: tendon_first[{}] is {}, but it has {} of {} points", which, i, first, points, poses.path_count);
    if (points > 0) {
      check_numbers(poses.path_points + 3 * static_cast<std::ptrdiff_t>(first), 3 * static_cast<std::size_t>(points), 3,
                    "path_points", which);
    }
  }
}

void check_extras(const Parts& parts, const mimo_stage_poses& poses, std::size_t which) {
  const std::size_t count = poses.extra_count;
  require(count <= kMostPoints, "poses[{}]: extra_count is {}, expected at most {}", which, count, kMostPoints);
  check_there(poses.extra_forms, count, "extra_forms", "extra_count", which);
  check_there(poses.extra_sizes, count, "extra_sizes", "extra_count", which);
  check_there(poses.extra_positions, count, "extra_positions", "extra_count", which);
  check_there(poses.extra_rotations, count, "extra_rotations", "extra_count", which);
  check_there(poses.extra_colors, count, "extra_colors", "extra_count", which);
  check_numbers(poses.extra_sizes, 3 * count, 3, "extra_sizes", which, 0);
  check_numbers(poses.extra_positions, 3 * count, 3, "extra_positions", which);
  check_numbers(poses.extra_rotations, 9 * count, 9, "extra_rotations", which);
  check_numbers(poses.extra_colors, 4 * count, 4, "extra_colors", which, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const int form = poses.extra_forms[i];
    const bool simple = form >= MIMO_FORM_PLANE && form <= MIMO_FORM_BOX && form != MIMO_FORM_FIELD;
    require(simple, "poses[{}]: extra_forms[{}] is {}, expected 0 to 6, but 1", which, i, form);
    const int material = poses.extra_materials == nullptr ? -1 : poses.extra_materials[i];
    require(material >= -1 && material < parts.materials(), "poses[{}]: extra_materials[{}] is {}, expected -1 to {}",
            which, i, material, parts.materials() - 1);
  }
}

// w x y z, of length 1, to a matrix, row by row.
void rotate(const double* q, double* m) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double matrix[9] = {
      w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
      2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
      2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  std::copy_n(matrix, 9, m);
}

void rotate_all(const double* quaternions, std::size_t count, std::vector<double>& rotations) {
  rotations.resize(9 * count);
  for (std::size_t i = 0; i < count; ++i) rotate(quaternions + 4 * i, rotations.data() + 9 * i);
}

rays::Vec point_of(const double* points, std::ptrdiff_t i) { return Eigen::Map<const rays::Vec>(points + 3 * i); }

}  // namespace

void check_poses(const Parts& parts, const mimo_stage_poses& poses, std::size_t which) {
  require(poses.reserved == 0, "poses[{}]: reserved is {}, expected 0", which, poses.reserved);
  check_places(poses.geom_count, poses.geom_positions, poses.geom_rotations, poses.geom_quaternions,
               parts.geoms().forms.size(), {"geom_count", "geom_positions", "geom_rotations", "geom_quaternions"},
               which);
  check_places(poses.site_count, poses.site_positions, poses.site_rotations, poses.site_quaternions,
               parts.sites().forms.size(), {"site_count", "site_positions", "site_rotations", "site_quaternions"},
               which);
  check_count(poses.light_count, parts.lights().types.size(), "light_count", which);
  check_there(poses.light_positions, poses.light_count, "light_positions", "light_count", which);
  check_there(poses.light_directions, poses.light_count, "light_directions", "light_count", which);
  check_numbers(poses.light_positions, 3 * poses.light_count, 3, "light_positions", which);
  check_numbers(poses.light_directions, 3 * poses.light_count, 3, "light_directions", which);
  check_count(poses.vertex_count, parts.surfaces().vertices, "vertex_count", which);
  check_there(poses.vertices, poses.vertex_count, "vertices", "vertex_count", which);
  check_numbers(poses.vertices, 3 * poses.vertex_count, 3, "vertices", which);
  check_tendons(parts, poses, which);
  check_extras(parts, poses, which);
}

Mover::Mover(const Parts& parts) : parts_(&parts), all_(parts.view()) {
  for (const rays::MovingSurface& surface : *parts.surfaces().moving) draped_.emplace_back(surface.pattern);
}

void Mover::adopt(const Parts& parts) {
  parts_ = &parts;
  all_ = parts.view();
}

void Mover::take(const mimo_stage_poses& poses) {
  poses_ = &poses;
  if (poses.geom_quaternions != nullptr) rotate_all(poses.geom_quaternions, poses.geom_count, geom_rotations_);
  if (poses.site_quaternions != nullptr) rotate_all(poses.site_quaternions, poses.site_count, site_rotations_);
  if (poses.vertex_count == 0) return;
  const std::vector<rays::MovingSurface>& moving = *parts_->surfaces().moving;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    if (moving[i].shell.drawn().count() == 0) continue;
    moving[i].shell.expand(poses.vertices + 3 * static_cast<std::ptrdiff_t>(parts_->surfaces().all[i].first_vertex),
                           vertices_);
    draped_[i].drape(vertices_.places.data(), vertices_.normals.data());
  }
}

void Mover::gather_extras(const mimo_stage_view& view) {
  extras_.clear();
  objects_.clear();
  if (poses_->vertex_count > 0) add_surfaces(view.surface_groups);
  if (poses_->tendon_count > 0) add_tendons(view.tendon_groups);
  add_given();
}

void Mover::add(const rays::Extra& extra, std::array<int, 2> object) {
  extras_.push_back(extra);
  extras_.back().id = all_.geoms.count + all_.sites.count + static_cast<int>(objects_.size());
  objects_.push_back(object);
}

void Mover::add_surfaces(unsigned groups) {
  const Surfaces& surfaces = parts_->surfaces();
  for (std::size_t i = 0; i < surfaces.all.size(); ++i) {
    if (!render::is_shown(surfaces.groups[i], groups)) continue;
    const std::array<int, 2> object = {surfaces.objects[2 * i], surfaces.objects[2 * i + 1]};
    rays::Extra extra;
    extra.material = surfaces.materials[i];
    extra.rgba = surfaces.colors.data() + 4 * i;
    const double* vertices = poses_->vertices + 3 * static_cast<std::ptrdiff_t>(surfaces.all[i].first_vertex);
    for (const auto& ends : surfaces.all[i].rods) {
      if (rays::make_rod(point_of(vertices, ends[0]), point_of(vertices, ends[1]), surfaces.all[i].radius, extra))
        add(extra, object);
    }
    if (draped_[i].mesh.nodes.empty()) continue;
    extra.type = render::kMeshShape;
    extra.mesh = &draped_[i].mesh;
    std::copy_n(draped_[i].place.data(), 3, extra.position);
    add(extra, object);
  }
}

void Mover::add_tendons(unsigned groups) {
  const Tendons& tendons = parts_->tendons();
  const auto object_at = [&](std::ptrdiff_t i) {
    return poses_->path_objects == nullptr ? -1 : poses_->path_objects[i];
  };
  for (std::size_t i = 0; i < tendons.widths.size(); ++i) {
    if (!render::is_shown(tendons.groups[i], groups)) continue;
    rays::Extra extra;
    extra.material = tendons.materials[i];
    extra.rgba = tendons.colors.data() + 4 * i;
    const std::ptrdiff_t first = poses_->tendon_first[i];
    for (std::ptrdiff_t k = first; k + 1 < first + poses_->tendon_points[i]; ++k) {
      const int from = object_at(k), to = object_at(k + 1);
      if (from == -2 || to == -2) continue;  // a pulley
      const double width = from >= 0 && to >= 0 ? 0.5 * tendons.widths[i] : tendons.widths[i];
      if (!rays::make_rod(point_of(poses_->path_points, k), point_of(poses_->path_points, k + 1), width, extra))
        continue;
      add(extra, {static_cast<int>(i), tendons.object_type});
    }
  }
}

void Mover::add_given() {
  for (std::size_t i = 0; i < poses_->extra_count; ++i) {
    rays::Extra extra;
    extra.type = poses_->extra_forms[i];
    std::copy_n(poses_->extra_sizes + 3 * i, 3, extra.size);
    std::copy_n(poses_->extra_positions + 3 * i, 3, extra.position);
    std::copy_n(poses_->extra_rotations + 9 * i, 9, extra.rotation);
    extra.material = poses_->extra_materials == nullptr ? -1 : poses_->extra_materials[i];
    extra.rgba = poses_->extra_colors + 4 * i;
    if (poses_->extra_objects == nullptr) {
      add(extra, {-1, -1});
    } else {
      add(extra, {poses_->extra_objects[2 * i], poses_->extra_objects[2 * i + 1]});
    }
  }
}

render::Stage Mover::shown(const mimo_stage_view& view) const {
  render::Stage stage = all_;
  stage.geoms.shown = view.geom_groups;
  stage.sites.shown = view.site_groups;
  if (poses_->geom_count == 0) stage.geoms.count = 0;
  if (poses_->site_count == 0) stage.sites.count = 0;
  if (poses_->light_count == 0) stage.lights.count = 0;
  return stage;
}

render::Poses Mover::places() const {
  const bool geoms_turned = poses_->geom_quaternions != nullptr, sites_turned = poses_->site_quaternions != nullptr;
  render::Poses places;
  places.geoms = {poses_->geom_positions, geoms_turned ? geom_rotations_.data() : poses_->geom_rotations};
  places.sites = {poses_->site_positions, sites_turned ? site_rotations_.data() : poses_->site_rotations};
  places.light_positions = poses_->light_positions;
  places.light_directions = poses_->light_directions;
  return places;
}

std::array<int, 2> Mover::object(int id) const {
  if (id < 0) return {-1, -1};
  if (id < all_.geoms.count) return {id, parts_->geoms().object_type};
  id -= all_.geoms.count;
  if (id < all_.sites.count) return {id, parts_->sites().object_type};
  return objects_[static_cast<std::size_t>(id - all_.sites.count)];
}

}  // namespace mimo::stage
