#include "access/kinds.h"

#include <algorithm>
#include <iterator>

#include "base/fail.h"
#include "base/header.h"

namespace mimo::access {
namespace {

using env::World;

const char* no_name(const World& /*world*/, int /*id*/) { return ""; }

#define MIMO_NAMED(constant) constant, #constant

template <mimo_kind number>
int count_in_model(const World& world) {
  return engine::count(world.model(), static_cast<engine::Kind>(number));
}

template <mimo_kind number>
const char* name_in_model(const World& world, int id) {
  return engine::name(world.model(), static_cast<engine::Kind>(number), id);
}

// Not by MIMO_NAMED, which would be given the constant's number.
#define MIMO_IN_MODEL(constant) constant, #constant, count_in_model<constant>, name_in_model<constant>

template <auto bodies>
int body_in_model(const mjModel& model, int id) {
  return (model.*bodies)[id];
}

constexpr Kind kKinds[] = {
    {MIMO_IN_MODEL(MIMO_BODY), "", body_in_model<&mjModel::body_parentid>},
    {MIMO_IN_MODEL(MIMO_JOINT), "joint", body_in_model<&mjModel::jnt_bodyid>},
    {MIMO_IN_MODEL(MIMO_GEOM), "", body_in_model<&mjModel::geom_bodyid>},
    {MIMO_IN_MODEL(MIMO_SITE), "", body_in_model<&mjModel::site_bodyid>},
    {MIMO_IN_MODEL(MIMO_CAMERA), "", body_in_model<&mjModel::cam_bodyid>},
    {MIMO_IN_MODEL(MIMO_ACTUATOR), "actuator"},
    {MIMO_IN_MODEL(MIMO_SENSOR)},
    {MIMO_IN_MODEL(MIMO_LIGHT), "", body_in_model<&mjModel::light_bodyid>},
    {MIMO_NAMED(MIMO_CONTACT), [](const World& world) { return world.data().ncon; }, no_name},
    {MIMO_NAMED(MIMO_STEP_CONTACT),
     [](const World& world) { return static_cast<int>(world.step_contacts().all().size()); }, no_name},
    {MIMO_NAMED(MIMO_AGENT), [](const World& world) { return static_cast<int>(world.agents().size()); },
     [](const World& world, int id) { return world.agents()[static_cast<std::size_t>(id)].name.c_str(); }},
    {MIMO_NAMED(MIMO_FACE), [](const World& world) { return static_cast<int>(world.faces().size()); },
     [](const World& world, int id) { return world.faces()[static_cast<std::size_t>(id)].name.c_str(); }},
    {MIMO_NAMED(MIMO_WORLD), [](const World& /*world*/) { return 1; }, no_name, "world"},
    {MIMO_NAMED(MIMO_WARNING), [](const World& /*world*/) { return engine::kWarnings; },
     [](const World& /*world*/, int id) { return engine::word(static_cast<engine::Warning>(id)); }},
};

static_assert(are_rows_of(kKinds, header::kKinds), "a kind's row is missing, doubled or not in its place");
static_assert(header::kKinds[0] == 1 && header::kKinds[std::size(kKinds) - 1] == std::size(kKinds),
              "kinds are found by their number");

std::vector<std::string> names_of(const World& world, const Kind& kind) {
  std::vector<std::string> names;
  const int count = kind.count(world);
  for (int id = 0; id < count; ++id) {
    const std::string text = kind.name(world, id);
    if (!text.empty()) names.push_back(text);
  }
  return names;
}

}  // namespace

const Kind* find_kind(mimo_kind number) {
  return number >= 1 && number <= static_cast<int>(std::size(kKinds)) ? &kKinds[number - 1] : nullptr;
}

int count_kinds() { return static_cast<int>(std::size(kKinds)); }

const Kind& kind_of(mimo_kind number) { return *find_kind(number); }

std::string words(const char* constant) {
  std::string words = constant + std::size("MIMO_") - 1;
  std::transform(words.begin(), words.end(), words.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter == '_' ? ' ' : letter;
  });
  return words;
}

int find_or_fail(const World& world, const Kind& kind, const std::string& wanted) {
  if (kind.in_model()) return engine::find_or_fail(world.model(), static_cast<engine::Kind>(kind.number), wanted);
  const int count = kind.count(world);
  for (int id = 0; id < count; ++id) {
    if (!wanted.empty() && wanted == kind.name(world, id)) return id;
  }
  fail(Status::kNotFound, "no {} named \"{}\"; {}", words(kind.constant), wanted,
       choice_of(wanted, names_of(world, kind)));
}

int find_or_fail(const mjModel& model, const World* world, const Kind& kind, const std::string& name) {
  if (kind.in_model()) return engine::find_or_fail(model, static_cast<engine::Kind>(kind.number), name);
  if (world == nullptr) fail(Status::kUnsupported, "attached senses have no {}: only worlds do", words(kind.constant));
  const bool only = kind.number == MIMO_AGENT && world->agents().size() == 1 && world->agents()[0].name.empty();
  return only && name.empty() ? 0 : find_or_fail(*world, kind, name);
}

int body_of(const World& world, const Kind& kind, int id) {
  if (kind.body == nullptr) {
    fail(Status::kInvalidArgument, "kind is {} ({}), expected body, joint, geom, site, camera or light", kind.number,
         words(kind.constant));
  }
  return kind.body(world.model(), id);
}

}  // namespace mimo::access
