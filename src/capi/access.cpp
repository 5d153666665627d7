// Named access.
#include "env/access.h"

#include <algorithm>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {
namespace {

using engine::Kind;

void check_id(const mjModel& model, Kind kind, std::int32_t id) {
  const int limit = engine::count(model, kind);
  require(id >= 0 && id < limit, "id is {}, expected a {} id from 0 to {}", id, engine::word(kind), limit - 1);
}

void write_contact(const env::Contact& contact, int index, std::int32_t* ids, double* values) {
  static_assert(sizeof contact.ids == sizeof(std::int32_t[MIMO_CONTACT_IDS]));
  static_assert(sizeof contact.values == sizeof(double[MIMO_CONTACT_VALUES]));
  if (ids != nullptr) std::copy(contact.ids.begin(), contact.ids.end(), ids + MIMO_CONTACT_IDS * index);
  if (values != nullptr) std::copy(contact.values.begin(), contact.values.end(), values + MIMO_CONTACT_VALUES * index);
}

void check_width(const mjModel& model, env::Quantity quantity, Span<const std::int32_t> ids, std::size_t count) {
  const std::size_t expected = env::width(model, quantity, ids);
  if (count < expected) fail(Status::kBufferTooSmall, "value_count is {}, but {} are needed", count, expected);
  require(count == expected, "value_count is {}, expected {}", count, expected);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_count(const mimo_env* env, int32_t kind, size_t* count) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    out(count, "count") = static_cast<size_t>(engine::count(model, env::kind_from(kind)));
  });
}

mimo_status mimo_env_find(const mimo_env* env, int32_t kind, const char* name, int32_t* id) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    require(name != nullptr, "name is NULL");
    out(id, "id") = engine::find_or_fail(model, env::kind_from(kind), name);
  });
}

mimo_status mimo_env_name(const mimo_env* env, int32_t kind, int32_t id, const char** name) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    const Kind of = env::kind_from(kind);
    check_id(model, of, id);
    out(name, "name") = engine::name(model, of, id);
  });
}

mimo_status mimo_env_body_of(const mimo_env* env, int32_t kind, int32_t id, int32_t* body) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    const Kind of = env::kind_from(kind);
    check_id(model, of, id);
    out(body, "body") = env::body_of(model, of, id);
  });
}

mimo_status mimo_env_width(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count,
                           size_t* value_count) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    out(value_count, "value_count") = env::width(model, env::quantity_from(quantity), array(ids, id_count, "ids"));
  });
}

mimo_status mimo_env_get(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count, double* values,
                         size_t value_count) noexcept {
  return guard(env, [&] {
    const engine::Physics& physics = open(env).world.physics();
    const env::Quantity what = env::quantity_from(quantity);
    const auto which = array(ids, id_count, "ids");
    const auto where = array(values, value_count, "values");
    check_width(physics.model(), what, which, value_count);
    env::get(physics, what, which, where);
  });
}

mimo_status mimo_env_set(mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count, const double* values,
                         size_t value_count) noexcept {
  return guard(env, [&] {
    engine::Physics& physics = open(env).world.physics();
    const env::Quantity what = env::quantity_from(quantity);
    const auto which = array(ids, id_count, "ids");
    const auto from = array(values, value_count, "values");
    env::require_writable(what);
    check_width(physics.model(), what, which, value_count);
    env::set(physics, what, which, from);
  });
}

mimo_status mimo_env_update(mimo_env* env) noexcept {
  return guard(env, [&] { open(env).world.physics().update_poses(); });
}

mimo_status mimo_env_contacts(const mimo_env* env, int32_t* ids, double* values, size_t capacity,
                              size_t* count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world;
    const mjData& data = world.data();
    const auto found = static_cast<size_t>(data.ncon);
    size_t& all = out(count, "count");
    const bool wanted = ids != nullptr || values != nullptr;
    check_length<double[MIMO_CONTACT_VALUES]>(capacity, "capacity");
    all = found;
    if (wanted && capacity < found) {
      fail(Status::kBufferTooSmall, "capacity is {}, but there are {} contacts", capacity, found);
    }
    for (int i = 0; wanted && i < data.ncon; ++i) {
      write_contact(env::contact(world.model(), data, i), i, ids, values);
    }
  });
}

}  // extern "C"
