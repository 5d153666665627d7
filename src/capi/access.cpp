#include "base/format.h"
#include "capi/access_arguments.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

bool is_of_receptors(std::int32_t number) { return number >= MIMO_RECEPTOR_BODY && number <= MIMO_RECEPTOR_FRAME; }

// "MIMO_BODY, which is a kind"; "" for what is neither a kind nor a quantity.
std::string told(std::int32_t number) {
  if (const access::Kind* kind = access::find_kind(number)) return std::string(kind->constant) + ", which is a kind";
  if (is_of_receptors(number)) {
    const auto quantity = static_cast<observation::ReceptorQuantity>(number);
    return std::string(observation::constant(quantity)) + ", which is a quantity of receptors";
  }
  const access::Quantity* quantity = access::find_quantity(number);
  return quantity == nullptr ? "" : std::string(quantity->constant) + ", which is a quantity";
}

// A number that is not what it should be: known as something else, or not at all.
[[noreturn]] void refuse_number(const char* argument, std::int32_t number, const char* expected) {
  const std::string what = told(number & ~MIMO_NOW);
  if (what.empty()) refuse_unknown(argument, format("{:#x}", static_cast<std::uint32_t>(number)));
  fail(Status::kInvalidArgument, "{} is {}, expected {}", argument, what, expected);
}

void check_id(const env::World& world, const access::Kind& kind, std::int32_t id) {
  const int limit = kind.count(world);
  if (id >= 0 && id < limit) return;
  fail(Status::kInvalidArgument, "id is {}, expected a {} id from 0 to {}", id, access::words(kind.constant),
       limit - 1);
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

// Named access.

Request request_from(std::int32_t quantity) {
  const std::int32_t number = quantity & ~MIMO_NOW;
  const access::Quantity* known = access::find_quantity(number);
  if (known == nullptr) refuse_number("quantity", quantity, "a quantity, such as MIMO_BODY_POSITION");
  const Request request = {*known, quantity != number};
  if (request.now) access::require_known_now(request.quantity);
  return request;
}

const access::Quantity& writable_from(std::int32_t quantity) {
  const Request request = request_from(quantity);
  require(!request.now, "quantity has MIMO_NOW, which is for reading only");
  access::require_writable(request.quantity);
  return request.quantity;
}

const access::Kind& kind_from(std::int32_t kind) {
  if (const access::Kind* known = access::find_kind(kind)) return *known;
  if (told(kind & ~MIMO_NOW).empty()) {
    fail(Status::kUnsupported, "kind is {}, which needs an interface newer than {}.{}: this one knows 1 to {}", kind,
         MIMO_API_MAJOR, MIMO_API_MINOR, access::count_kinds());
  }
  refuse_number("kind", kind, "a kind, such as MIMO_BODY");
}

observation::ReceptorQuantity receptor_quantity_from(std::int32_t quantity) {
  if (!is_of_receptors(quantity)) {
    refuse_number("quantity", quantity, "a quantity of receptors, such as MIMO_RECEPTOR_POSITION");
  }
  return static_cast<observation::ReceptorQuantity>(quantity);
}

access::Ids ids_of(const env::World& world, const access::Quantity& quantity, const std::int32_t* ids,
                   std::size_t count) {
  if (ids == nullptr && count == 0) return access::Ids(quantity.kind().count(world));
  return access::Ids(array(ids, count, "ids"));
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_count(const mimo_env* env, int32_t kind, size_t* count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    out(count, "count") = static_cast<size_t>(kind_from(kind).count(world));
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
    const access::Kind& of = kind_from(kind);
    check_id(world, of, id);
    out(name, "name") = of.name(world, id);
  });
}

mimo_status mimo_env_body_of(const mimo_env* env, int32_t kind, int32_t id, int32_t* body) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Kind& of = kind_from(kind);
    check_id(world, of, id);
    out(body, "body") = access::body_of(world, of, id);
  });
}

mimo_status mimo_env_width(const mimo_env* env, int32_t quantity, const int32_t* ids, size_t id_count,
                           size_t* value_count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Quantity& what = request_from(quantity).quantity;
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
    const access::Quantity& what = writable_from(quantity);
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

namespace mimo::capi {
namespace {

mimo_field_config default_field_config() {
  mimo_field_config config{};
  config.struct_size = sizeof config;
  config.quantity = MIMO_BODY_POSITION;
  return config;
}

std::vector<std::string> elements_of(const mimo_field_config& config) {
  std::vector<std::string> names;
  for (const char* name : array(config.elements, config.element_count, "elements")) {
    require(name != nullptr, "elements[{}] is NULL, expected a name", names.size());
    names.emplace_back(name);
  }
  return names;
}

access::FieldOptions options_from(const mimo_field_config& config) {
  access::FieldOptions options;
  const Request wanted = request_from(config.quantity);
  options.quantity = &wanted.quantity;
  options.now = wanted.now;
  options.name = text(config.name);
  require(!options.name.empty(), "name is {}, expected a name for the field", config.name == nullptr ? "NULL" : "\"\"");
  require(options.name.front() != '/' && options.name.back() != '/', "name is \"{}\", expected no / at its ends",
          options.name);
  options.elements = elements_of(config);
  options.relative_to = text(config.relative_to);
  return options;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_field_config_init(mimo_field_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_field_config(), "config"); });
}

mimo_status mimo_scene_add_field(mimo_scene* scene, const mimo_field_config* config) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, but a field needs at least a name");
    const mimo_field_config given = read_struct(config, "config");
    const access::FieldOptions field = options_from(given);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.fields.add(field);
      note(edit, {{"call", "add_field"}, {"config", json_of(given)}, {"elements", field.elements}});
    });
  });
}

}  // extern "C"
