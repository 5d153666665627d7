#include "engine/overrides.h"

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

}  // namespace

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

void Overrides::save(const mjModel& model, ByteWriter& to) {
  for (int i = 0; i < model.neq; ++i) {
    to.put(model.eq_active[i]);
    to.put(model.eq_data[i * mjNEQDATA]);
  }
  for (int i = 0; i < model.nu; ++i) to.put(model.actuator_gear[6 * i]);
  for (int i = 0; i < model.ngeom; ++i) to.put(std::int32_t{model.geom_matid[i]});
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
