#include "engine/overrides.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/fail.h"

namespace mimo::engine {
namespace {

// Gives the model an array of its own in place of the shared one.
template <typename T>
void own(std::vector<T>& mine, T*& array, int count) {
  if (!mine.empty() || count == 0) return;
  mine.assign(array, array + static_cast<std::size_t>(count));
  array = mine.data();
}

// The equality is about the difference to the joint's reference angle.
double reference(const mjModel& model, int lock) { return model.qpos0[model.jnt_qposadr[model.eq_obj1id[lock]]]; }

template <typename Visit>
void for_each_ball(const mjModel& model, Visit&& visit) {
  for (int body = 1; body < model.nbody; ++body) {
    if (is_ball(model, body)) visit(body);
  }
}

}  // namespace

bool is_ball(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body], geom = model.body_geomadr[body];
  const bool alone = model.body_parentid[body] == 0 && model.body_jntnum[body] == 1 && model.body_geomnum[body] == 1;
  const bool leaf = model.body_subtreemass[body] == model.body_mass[body];
  return alone && leaf && model.jnt_type[joint] == mjJNT_FREE && model.geom_type[geom] == mjGEOM_SPHERE;
}

void Overrides::own_locks(mjModel& model) {
  own(active_, model.eq_active, model.neq);
  own(data_, model.eq_data, model.neq * mjNEQDATA);
}

void Overrides::own_gears(mjModel& model) { own(gear_, model.actuator_gear, model.nu * 6); }

void Overrides::hold(mjModel& model, int lock, double angle) {
  own_locks(model);
  model.eq_data[lock * mjNEQDATA] = angle - reference(model, lock);
  model.eq_active[lock] = 1;
}

void Overrides::release(mjModel& model, int lock) {
  own_locks(model);
  model.eq_active[lock] = 0;
}

double& Overrides::gear(mjModel& model, int actuator) {
  own_gears(model);
  return model.actuator_gear[6 * actuator];
}

void Overrides::own_materials(mjModel& model) { own(material_, model.geom_matid, model.ngeom); }

void Overrides::paint(mjModel& model, int geom, int material) {
  own_materials(model);
  model.geom_matid[geom] = material;
}

void Overrides::own_balls(mjModel& model) {
  own(size_, model.geom_size, 3 * model.ngeom);
  own(bound_, model.geom_rbound, model.ngeom);
  own(mass_, model.body_mass, model.nbody);
  own(subtree_mass_, model.body_subtreemass, model.nbody);
  own(inertia_, model.body_inertia, 3 * model.nbody);
  own(body_weight_, model.body_invweight0, 2 * model.nbody);
  own(dof_weight_, model.dof_invweight0, model.nv);
  own(dof_inertia_, model.dof_M0, model.nv);
}

// What MuJoCo's compiler would compute, but for the statistic of mean inertia, which scales the solver's tolerance
// only.
void Overrides::shape_ball(mjModel& model, int body, double radius, double mass) {
  own_balls(model);
  const int geom = model.body_geomadr[body], dof = model.body_dofadr[body];
  const double inertia = 0.4 * mass * radius * radius;
  model.geom_size[3 * geom] = model.geom_rbound[geom] = radius;
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

void Overrides::slacken(mjModel& model, int joint, int dof, double damping) {
  own(stiffness_, model.jnt_stiffness, model.njnt);
  own(damping_, model.dof_damping, model.nv);
  model.jnt_stiffness[joint] = 0;
  model.dof_damping[dof] = damping;
}

void Overrides::unlimit(mjModel& model, int actuator) {
  own(control_limited_, model.actuator_ctrllimited, model.nu);
  own(force_limited_, model.actuator_forcelimited, model.nu);
  model.actuator_ctrllimited[actuator] = 0;
  model.actuator_forcelimited[actuator] = 0;
}

void Overrides::save(const mjModel& model, ByteWriter& to) {
  for (int i = 0; i < model.neq; ++i) {
    to.put(model.eq_active[i]);
    to.put(model.eq_data[i * mjNEQDATA]);
  }
  for (int i = 0; i < model.nu; ++i) to.put(model.actuator_gear[6 * i]);
  for (int i = 0; i < model.ngeom; ++i) to.put(std::int32_t{model.geom_matid[i]});
  for_each_ball(model, [&](int body) {
    to.put(model.geom_size[3 * model.body_geomadr[body]]);
    to.put(model.body_mass[body]);
  });
  to.put(Span<const double>(model.opt.gravity, 3));
}

void Overrides::check(const mjModel& model, ByteReader& from) {
  for (int i = 0; i < model.neq; ++i) {
    from.take_flag();
    from.take_finite("a lock");
  }
  for (int i = 0; i < model.nu; ++i) from.take_finite("a gear");
  for (int i = 0; i < model.ngeom; ++i) {
    const auto material = from.take<std::int32_t>();
    require(material >= -1 && material < model.nmat, "the state holds {} for a material, expected -1 to {}", material,
            model.nmat - 1);
  }
  for_each_ball(model, [&](int) {
    for (const char* what : {"a ball's radius", "a ball's mass"}) {
      const double value = from.take_finite(what);
      require(value > 0, "the state holds {} for {}, expected more than 0", value, what);
    }
  });
  for (int i = 0; i < 3; ++i) from.take_finite("gravity");
}

// Takes arrays of its own only where the state differs from what the world has now.
void Overrides::load(mjModel& model, ByteReader& from) {
  for (int i = 0; i < model.neq; ++i) {
    const auto active = from.take<mjtByte>();
    const auto data = from.take<double>();
    if (active == model.eq_active[i] && data == model.eq_data[i * mjNEQDATA]) continue;
    own_locks(model);
    model.eq_active[i] = active;
    model.eq_data[i * mjNEQDATA] = data;
  }
  for (int i = 0; i < model.nu; ++i) {
    const auto value = from.take<double>();
    if (value != model.actuator_gear[6 * i]) gear(model, i) = value;
  }
  for (int i = 0; i < model.ngeom; ++i) {
    const auto value = from.take<std::int32_t>();
    if (value != model.geom_matid[i]) paint(model, i, value);
  }
  for_each_ball(model, [&](int body) {
    const auto radius = from.take<double>();
    const auto mass = from.take<double>();
    const bool same = radius == model.geom_size[3 * model.body_geomadr[body]] && mass == model.body_mass[body];
    if (!same) shape_ball(model, body, radius, mass);
  });
  from.take(Span<double>(model.opt.gravity, 3));
}

int find_lock(const mjModel& model, int joint) {
  for (int i = 0; i < model.neq; ++i) {
    if (model.eq_type[i] == mjEQ_JOINT && model.eq_obj1id[i] == joint && model.eq_obj2id[i] < 0) return i;
  }
  return -1;
}

double lock_angle(const mjModel& model, int lock) { return model.eq_data[lock * mjNEQDATA] + reference(model, lock); }

}  // namespace mimo::engine
