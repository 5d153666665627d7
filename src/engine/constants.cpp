#include "engine/constants.h"

#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/fail.h"
#include "engine/data.h"
#include "engine/guard.h"

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
  require(sound, "values: masses that MuJoCo cannot calculate with");
}

void Constants::copy_to(mjModel& model) const {
  visit_derived(model_, [&](auto array, int count) { std::copy_n(model_.*array, count, model.*array); });
}

}  // namespace mimo::engine
