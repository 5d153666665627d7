#include "engine/overrides.h"

#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/data.h"
#include "engine/guard.h"
#include "engine/model.h"

namespace mimo::engine {
namespace {

// Large arrays that MuJoCo reads at most.
constexpr bool is_shared(std::string_view name) {
  const auto starts = [name](std::string_view part) { return name.substr(0, part.size()) == part; };
  return starts("tex_") || starts("mesh_") || starts("skin_") || starts("hfield_");
}

// Calls visit(array, count) for masses and what follows from them.
template <typename Visit>
void visit_derived(const mjModel& model, Visit&& visit) {
  visit(&mjModel::body_mass, model.nbody);
  visit(&mjModel::body_inertia, 3 * model.nbody);
  visit(&mjModel::body_subtreemass, model.nbody);
  visit(&mjModel::body_invweight0, 2 * model.nbody);
  visit(&mjModel::dof_invweight0, model.nv);
  visit(&mjModel::dof_M0, model.nv);
  visit(&mjModel::tendon_invweight0, model.ntendon);
  visit(&mjModel::actuator_acc0, model.nu);
}

// The equality is about the difference to the joint's reference angle.
double reference(const mjModel& model, int lock) { return model.qpos0[model.jnt_qposadr[model.eq_obj1id[lock]]]; }

// Numbers of an array of the model in which worlds may differ: the first one of each of `count` rows.
template <typename T>
struct Column {
  const char* what;
  T* mjModel::*array;
  int count;
  int stride = 1;
  double least = -std::numeric_limits<double>::infinity();
};

template <typename T>
Column<T> column(const char* what, T* mjModel::*array, int count, int stride = 1) {
  return {what, array, count, stride};
}

template <typename T>
Column<T> not_negative(const char* what, T* mjModel::*array, int count) {
  return {what, array, count, 1, 0};
}

// All of them, except materials. What follows from masses is among them: finding it out anew takes long, and its
// last digits depend on how the masses came to be.
template <typename Visit>
void visit_columns(const mjModel& model, Visit&& visit) {
  visit(column("a lock", &mjModel::eq_data, model.neq, mjNEQDATA));
  visit(column("a gear", &mjModel::actuator_gear, model.nu, 6));
  visit(not_negative("a size", &mjModel::geom_size, 3 * model.ngeom));
  visit(not_negative("the radius around a geom", &mjModel::geom_rbound, model.ngeom));
  compat::visit_bounds(model, [&](const char* what, auto array, int count) { visit(column(what, array, count)); });
  visit(not_negative("a friction", &mjModel::geom_friction, 3 * model.ngeom));
  visit(column("a colour", &mjModel::geom_rgba, 4 * model.ngeom));
  visit(not_negative("a mass", &mjModel::body_mass, model.nbody));
  visit(not_negative("a mass of a body with all that hangs on it", &mjModel::body_subtreemass, model.nbody));
  visit(not_negative("an inertia", &mjModel::body_inertia, 3 * model.nbody));
  visit(column("a body's weight in constraints", &mjModel::body_invweight0, 2 * model.nbody));
  visit(column("a joint's weight in constraints", &mjModel::dof_invweight0, model.nv));
  visit(column("a joint's inertia", &mjModel::dof_M0, model.nv));
  visit(column("a tendon's weight in constraints", &mjModel::tendon_invweight0, model.ntendon));
  visit(column("an actuator's strength", &mjModel::actuator_acc0, model.nu));
  visit(column("a damping", &mjModel::dof_damping, model.nv));
  visit(column("a body's position", &mjModel::body_pos, 3 * model.nbody));
  visit(column("a body's orientation", &mjModel::body_quat, 4 * model.nbody));
  visit(column("a light's position", &mjModel::light_pos, 3 * model.nlight));
  visit(column("a light's direction", &mjModel::light_dir, 3 * model.nlight));
  visit(column("a light's colour", &mjModel::light_diffuse, 3 * model.nlight));
}

// The radius of the sphere around a shape of this size; MuJoCo's compiler has the same formulas.
double bound(int type, const double* size) {
  switch (type) {
    case mjGEOM_CAPSULE: return size[0] + size[1];
    case mjGEOM_CYLINDER: return std::sqrt(size[0] * size[0] + size[1] * size[1]);
    case mjGEOM_ELLIPSOID: return std::max({size[0], size[1], size[2]});
    case mjGEOM_BOX: return std::sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
    default: return size[0];
  }
}

std::array<double, 3> half_sides(int type, const double* size) {
  switch (type) {
    case mjGEOM_CAPSULE: return {size[0], size[0], size[0] + size[1]};
    case mjGEOM_CYLINDER: return {size[0], size[0], size[1]};
    case mjGEOM_SPHERE: return {size[0], size[0], size[0]};
    default: return {size[0], size[1], size[2]};
  }
}

}  // namespace

Constants::Constants(const mjModel& model) : model_(model) {
  const auto copy = [this](auto*& array, std::size_t count) {
    const std::size_t bytes = count * sizeof *array;
    if (bytes == 0) return;
    arrays_.push_back(std::make_unique<std::uint8_t[]>(bytes));
    std::memcpy(arrays_.back().get(), array, bytes);
    array = reinterpret_cast<std::remove_reference_t<decltype(array)>>(arrays_.back().get());
  };
  MJMODEL_POINTERS_PREAMBLE((&model))
#define X(type, name, rows, columns) \
  if constexpr (!is_shared(#name))   \
    copy(model_.name, static_cast<std::size_t>(model.rows) * static_cast<std::size_t>(columns));
  MJMODEL_POINTERS
#undef X
}

void Constants::scale_mass(int body, double mass) {
  if (mass == model_.body_mass[body]) return;
  double* inertia = model_.body_inertia + 3 * body;
  std::transform(inertia, inertia + 3, inertia, [&](double old) { return old * (mass / model_.body_mass[body]); });
  model_.body_mass[body] = mass;
}

void Constants::derive() {
  const DataPtr data = make_data(model_);
  const Complaint complaint = guarded([&] { mj_setConst(&model_, data.get()); });
  bool sound = !complaint.failed;
  visit_derived(model_, [&](auto array, int count) {
    sound = sound && std::all_of(model_.*array, model_.*array + count, [](double x) { return std::isfinite(x); });
  });
  require(sound, "values: MuJoCo cannot calculate with these masses");
}

void Constants::copy_to(mjModel& model) const {
  visit_derived(model_, [&](auto array, int count) { std::copy_n(model_.*array, count, model.*array); });
}

bool is_ball(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body], geom = model.body_geomadr[body];
  const bool alone = model.body_parentid[body] == 0 && model.body_jntnum[body] == 1 && model.body_geomnum[body] == 1;
  const bool leaf = model.body_subtreemass[body] == model.body_mass[body];
  return alone && leaf && model.jnt_type[joint] == mjJNT_FREE && model.geom_type[geom] == mjGEOM_SPHERE;
}

int size_count(int geom_type) {
  switch (geom_type) {
    case mjGEOM_SPHERE: return 1;
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER: return 2;
    case mjGEOM_ELLIPSOID:
    case mjGEOM_BOX: return 3;
    default: return 0;
  }
}

template <typename T>
T* Overrides::own(mjModel& model, T* mjModel::*array, int length) {
  if (model.*array != shared_.*array || length == 0) return model.*array;
  const std::size_t bytes = sizeof(T) * static_cast<std::size_t>(length);
  arrays_.push_back(std::make_unique<std::uint8_t[]>(bytes));
  std::memcpy(arrays_.back().get(), shared_.*array, bytes);
  model.*array = reinterpret_cast<T*>(arrays_.back().get());
  return model.*array;
}

void Overrides::own_locks(mjModel& model) {
  own(model, compat::kLockFlags, model.neq);
  own(model, &mjModel::eq_data, model.neq * mjNEQDATA);
}

void Overrides::own_masses(mjModel& model) {
  own(model, &mjModel::body_mass, model.nbody);
  own(model, &mjModel::body_subtreemass, model.nbody);
  own(model, &mjModel::body_inertia, 3 * model.nbody);
  own(model, &mjModel::body_invweight0, 2 * model.nbody);
  own(model, &mjModel::dof_invweight0, model.nv);
  own(model, &mjModel::dof_M0, model.nv);
  own(model, &mjModel::tendon_invweight0, model.ntendon);
  own(model, &mjModel::actuator_acc0, model.nu);
}

void Overrides::hold(mjModel& model, int lock, double angle) {
  own_locks(model);
  model.eq_data[lock * mjNEQDATA] = angle - reference(model, lock);
  (model.*compat::kLockFlags)[lock] = 1;
}

void Overrides::release(mjModel& model, int lock, double angle) {
  hold(model, lock, angle);
  (model.*compat::kLockFlags)[lock] = 0;
}

void Overrides::release(mjModel& model, int lock) {
  own_locks(model);
  (model.*compat::kLockFlags)[lock] = 0;
}

double& Overrides::gear(mjModel& model, int actuator) {
  return own(model, &mjModel::actuator_gear, 6 * model.nu)[6 * actuator];
}

void Overrides::paint(mjModel& model, int geom, int material) {
  own(model, &mjModel::geom_matid, model.ngeom)[geom] = material;
}

// What MuJoCo's compiler would compute, except the statistic of mean inertia, which scales the solver's tolerance
// only.
void Overrides::shape_ball(mjModel& model, int body, double radius, double mass) {
  own_masses(model);
  const int geom = model.body_geomadr[body], dof = model.body_dofadr[body];
  const double inertia = 0.4 * mass * radius * radius;
  own(model, &mjModel::geom_size, 3 * model.ngeom)[3 * geom] = radius;
  own_bounds(model, geom);
  compat::set_ball_length(model, body, radius, [&](auto array, int length) { return own(model, array, length); });
  model.body_subtreemass[0] += mass - model.body_mass[body];
  model.body_subtreemass[body] = model.body_mass[body] = mass;
  std::fill_n(model.body_inertia + 3 * body, 3, inertia);
  model.body_invweight0[2 * body] = 1 / mass;
  model.body_invweight0[2 * body + 1] = 1 / inertia;
  for (int i = 0; i < 6; ++i) {
    model.dof_M0[dof + i] = i < 3 ? mass : inertia;
    model.dof_invweight0[dof + i] = 1 / model.dof_M0[dof + i];
  }
}

void Overrides::set_masses(mjModel& model, Span<const std::int32_t> bodies, Span<const double> masses) {
  own_masses(model);
  Constants constants(model);
  for (std::size_t i = 0; i < bodies.size(); ++i) constants.scale_mass(bodies[i], masses[i]);
  constants.derive();
  constants.copy_to(model);
}

void Overrides::resize(mjModel& model, int geom, const double* size) {
  const int type = model.geom_type[geom];
  if (size_count(type) == 0) return;
  double* own_size = own(model, &mjModel::geom_size, 3 * model.ngeom) + 3 * geom;
  std::copy_n(size, size_count(type), own_size);
  own_bounds(model, geom);
}

// Radius and boxes around a geom of another size.
void Overrides::own_bounds(mjModel& model, int geom) {
  const int type = model.geom_type[geom];
  const double* size = model.geom_size + 3 * geom;
  const double radius = bound(type, size), growth = radius - model.geom_rbound[geom];
  own(model, &mjModel::geom_rbound, model.ngeom)[geom] = radius;
  compat::set_box(model, geom, half_sides(type, size).data(), growth,
                  [&](auto array, int length) { return own(model, array, length); });
}

double* Overrides::friction(mjModel& model, int geom) {
  return own(model, &mjModel::geom_friction, 3 * model.ngeom) + 3 * geom;
}

float* Overrides::color(mjModel& model, int geom) {
  return own(model, &mjModel::geom_rgba, 4 * model.ngeom) + 4 * geom;
}

double* Overrides::light_position(mjModel& model, int light) {
  return own(model, &mjModel::light_pos, 3 * model.nlight) + 3 * light;
}

double* Overrides::light_direction(mjModel& model, int light) {
  return own(model, &mjModel::light_dir, 3 * model.nlight) + 3 * light;
}

float* Overrides::light_color(mjModel& model, int light) {
  return own(model, &mjModel::light_diffuse, 3 * model.nlight) + 3 * light;
}

double* Overrides::position(mjModel& model, int body) {
  return own(model, &mjModel::body_pos, 3 * model.nbody) + 3 * body;
}

double* Overrides::orientation(mjModel& model, int body) {
  return own(model, &mjModel::body_quat, 4 * model.nbody) + 4 * body;
}

void Overrides::damp(mjModel& model, int joint, double damping) {
  double* first = own(model, &mjModel::dof_damping, model.nv) + model.jnt_dofadr[joint];
  std::fill_n(first, velocity_count(model.jnt_type[joint]), damping);
}

void Overrides::slacken(mjModel& model, int joint, int dof, double damping) {
  own(model, &mjModel::jnt_stiffness, model.njnt)[joint] = 0;
  own(model, &mjModel::dof_damping, model.nv)[dof] = damping;
}

void Overrides::unlimit(mjModel& model, int actuator) {
  own(model, &mjModel::actuator_ctrllimited, model.nu)[actuator] = 0;
  own(model, &mjModel::actuator_forcelimited, model.nu)[actuator] = 0;
}

void Overrides::save(const mjModel& model, ByteWriter& to) {
  for (int i = 0; i < model.neq; ++i) to.put(mjtByte{(model.*compat::kLockFlags)[i]});
  for (int i = 0; i < model.ngeom; ++i) to.put(std::int32_t{model.geom_matid[i]});
  visit_columns(model, [&](const auto& column) {
    for (int i = 0; i < column.count; ++i) to.put((model.*column.array)[i * column.stride]);
  });
  to.put(Span<const double>(model.opt.gravity, 3));
}

void Overrides::check(const mjModel& model, ByteReader& from) {
  for (int i = 0; i < model.neq; ++i) from.take_flag();
  for (int i = 0; i < model.ngeom; ++i) {
    const auto material = from.take<std::int32_t>();
    require(material >= -1 && material < model.nmat, "the state holds {} for a material, expected -1 to {}", material,
            model.nmat - 1);
  }
  visit_columns(model, [&](const auto& column) {
    using Number = std::remove_pointer_t<std::decay_t<decltype(model.*column.array)>>;
    for (int i = 0; i < column.count; ++i) {
      const double value = from.take<Number>();
      require(std::isfinite(value) && value >= column.least, "the state holds {} for {}, expected a finite number{}",
              value, column.what, column.least == 0 ? ", not negative" : "");
    }
  });
  for (int i = 0; i < 3; ++i) from.take_finite("gravity");
}

// Takes arrays of its own only where the state differs from what the world has now.
void Overrides::load(mjModel& model, ByteReader& from) {
  const auto take = [&](auto array, int count, int stride) {
    using Number = std::remove_pointer_t<std::decay_t<decltype(model.*array)>>;
    for (int i = 0; i < count; ++i) {
      const auto value = from.take<Number>();
      if (value != (model.*array)[i * stride]) own(model, array, count * stride)[i * stride] = value;
    }
  };
  take(compat::kLockFlags, model.neq, 1);
  take(&mjModel::geom_matid, model.ngeom, 1);
  visit_columns(model, [&](const auto& column) { take(column.array, column.count, column.stride); });
  from.take(Span<double>(model.opt.gravity, 3));
}

int find_lock(const mjModel& model, int joint) {
  for (int i = 0; i < model.neq; ++i) {
    if (model.eq_type[i] == mjEQ_JOINT && model.eq_obj1id[i] == joint && model.eq_obj2id[i] < 0) return i;
  }
  return -1;
}

bool is_held(const mjModel& model, int lock) { return (model.*compat::kLockFlags)[lock] != 0; }

double lock_angle(const mjModel& model, int lock) { return model.eq_data[lock * mjNEQDATA] + reference(model, lock); }

}  // namespace mimo::engine
