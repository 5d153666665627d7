// Named access.
#include "capi/access.h"

#include "base/format.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/use.h"

namespace mimo::capi {

namespace {

bool is_kind(std::int32_t number) { return number >= 1 && number <= access::kKinds; }

bool is_of_receptors(std::int32_t number) { return number >= MIMO_RECEPTOR_BODY && number <= MIMO_RECEPTOR_FRAME; }

// "MIMO_BODY, which is a kind"; "" for what is neither a kind nor a quantity.
std::string told(std::int32_t number) {
  if (is_kind(number)) return access::constant(static_cast<access::Kind>(number)) + ", which is a kind";
  if (is_of_receptors(number)) {
    const auto quantity = static_cast<observation::ReceptorQuantity>(number);
    return access::constant(observation::word(quantity)) + ", which is a quantity of receptors";
  }
  const access::Traits* quantity = access::find_quantity(number);
  return quantity == nullptr ? "" : access::constant(*quantity) + ", which is a quantity";
}

// A number that is not what it should be: known as something else, or not at all.
[[noreturn]] void refuse_number(const char* argument, std::int32_t number, const char* expected) {
  const std::string what = told(number & ~MIMO_NOW);
  if (what.empty()) refuse_unknown(argument, format("{:#x}", static_cast<std::uint32_t>(number)));
  fail(Status::kInvalidArgument, "{} is {}, expected {}", argument, what, expected);
}

}  // namespace

Request request_from(std::int32_t quantity) {
  const std::int32_t number = quantity & ~MIMO_NOW;
  if (access::find_quantity(number) == nullptr) {
    refuse_number("quantity", quantity, "a quantity, such as MIMO_BODY_POSITION");
  }
  const Request request = {static_cast<access::Quantity>(number), quantity != number};
  if (request.now) access::require_known_now(request.quantity);
  return request;
}

access::Quantity writable_from(std::int32_t quantity) {
  const Request request = request_from(quantity);
  require(!request.now, "quantity has MIMO_NOW, which is for reading only");
  access::require_writable(request.quantity);
  return request.quantity;
}

access::Kind kind_from(std::int32_t kind) {
  if (!is_kind(kind) && !told(kind & ~MIMO_NOW).empty()) refuse_number("kind", kind, "a kind, such as MIMO_BODY");
  check_choice(kind, 1, access::kKinds, "kind");
  return static_cast<access::Kind>(kind);
}

observation::ReceptorQuantity receptor_quantity_from(std::int32_t quantity) {
  if (!is_of_receptors(quantity)) {
    refuse_number("quantity", quantity, "a quantity of receptors, such as MIMO_RECEPTOR_POSITION");
  }
  return static_cast<observation::ReceptorQuantity>(quantity);
}

access::Ids ids_of(const env::World& world, access::Quantity quantity, const std::int32_t* ids, std::size_t count) {
  if (ids == nullptr && count == 0) return access::Ids(access::count(world, access::traits(quantity).kind()));
  return access::Ids(array(ids, count, "ids"));
}

namespace {

void check_id(const env::World& world, access::Kind kind, std::int32_t id) {
  const int limit = access::count(world, kind);
  require(id >= 0 && id < limit, "id is {}, expected a {} id from 0 to {}", id, access::word(kind), limit - 1);
}

template <typename T>
void get(const mimo_env* env, std::int32_t quantity, const std::int32_t* ids, std::size_t id_count, T* values,
         std::size_t value_count) {
  const env::World& world = open(env).world();
  const Request wanted = request_from(quantity);
  const access::Ids which = ids_of(world, wanted.quantity, ids, id_count);
  const Span<T> where = array(values, value_count, "values");
  check_exact(value_count, access::width(world, wanted.quantity, which), "value_count");
  access::get(world, wanted.quantity, which, wanted.now, where);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_count(const mimo_env* env, int32_t kind, size_t* count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    out(count, "count") = static_cast<size_t>(access::count(world, kind_from(kind)));
  });
}

mimo_status mimo_env_find(const mimo_env* env, int32_t kind, const char* name, int32_t* id) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    require(name != nullptr, "name is NULL");
    out(id, "id") = access::find_or_fail(world, kind_from(kind), name);
  });
}

mimo_status mimo_env_name(const mimo_env* env, int32_t kind, int32_t id, const char** name) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Kind of = kind_from(kind);
    check_id(world, of, id);
    out(name, "name") = access::name(world, of, id);
  });
}

mimo_status mimo_env_body_of(const mimo_env* env, int32_t kind, int32_t id, int32_t* body) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Kind of = kind_from(kind);
    check_id(world, of, id);
    out(body, "body") = access::body_of(world, of, id);
  });
}

mimo_status mimo_env_width(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count,
                           size_t* value_count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Quantity what = request_from(quantity).quantity;
    out(value_count, "value_count") = access::width(world, what, ids_of(world, what, ids, id_count));
  });
}

mimo_status mimo_env_get(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count, double* values,
                         size_t value_count) noexcept {
  return guard(env, [&] { get(env, quantity, ids, id_count, values, value_count); });
}

mimo_status mimo_env_get_float(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count,
                               float* values, size_t value_count) noexcept {
  return guard(env, [&] { get(env, quantity, ids, id_count, values, value_count); });
}

mimo_status mimo_env_set(mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count, const double* values,
                         size_t value_count) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world();
    const access::Quantity what = writable_from(quantity);
    const access::Ids which = ids_of(world, what, ids, id_count);
    const auto from = array(values, value_count, "values");
    check_given(value_count, access::width(world, what, which), "value_count");
    access::set(world, what, which, from);
  });
}

mimo_status mimo_env_update(mimo_env* env) noexcept {
  return guard(env, [&] { open(env).world().update_poses(); });
}

}  // extern "C"
