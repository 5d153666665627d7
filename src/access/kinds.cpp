#include "access/kinds.h"

#include <algorithm>

#include "base/choice.h"
#include "base/fail.h"

namespace mimo::access {
namespace {

bool in_model(Kind kind) { return kind <= Kind::kLight; }

engine::Kind of_model(Kind kind) { return static_cast<engine::Kind>(kind); }

std::vector<std::string> names_of(const env::World& world, Kind kind) {
  std::vector<std::string> names;
  for (int id = 0; id < count(world, kind); ++id) {
    const std::string text = name(world, kind, id);
    if (!text.empty()) names.push_back(text);
  }
  return names;
}

}  // namespace

const char* word(Kind kind) {
  switch (kind) {
    case Kind::kContact: return "contact";
    case Kind::kStepContact: return "step contact";
    case Kind::kAgent: return "agent";
    case Kind::kFace: return "face";
    case Kind::kWorld: return "world";
    case Kind::kWarning: return "warning";
    default: return engine::word(of_model(kind));
  }
}

std::string constant(const std::string& words) {
  std::string name = "MIMO_" + words;
  std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter == ' ' ? '_' : letter;
  });
  return name;
}

std::string constant(Kind kind) { return constant(word(kind)); }

int count(const env::World& world, Kind kind) {
  switch (kind) {
    case Kind::kContact: return world.data().ncon;
    case Kind::kStepContact: return static_cast<int>(world.step_contacts().all().size());
    case Kind::kAgent: return static_cast<int>(world.agents().size());
    case Kind::kFace: return static_cast<int>(world.faces().size());
    case Kind::kWorld: return 1;
    case Kind::kWarning: return engine::kWarnings;
    default: return engine::count(world.model(), of_model(kind));
  }
}

int find_or_fail(const env::World& world, Kind kind, const std::string& wanted) {
  if (in_model(kind)) return engine::find_or_fail(world.model(), of_model(kind), wanted);
  for (int id = 0; id < count(world, kind); ++id) {
    if (!wanted.empty() && wanted == name(world, kind, id)) return id;
  }
  fail(Status::kNotFound, "no {} named \"{}\"; {}", word(kind), wanted, choice_of(wanted, names_of(world, kind)));
}

int find_or_fail(const mjModel& model, const env::World* world, Kind kind, const std::string& name) {
  if (in_model(kind)) return engine::find_or_fail(model, of_model(kind), name);
  if (world == nullptr) fail(Status::kUnsupported, "attached senses know of no {}, which only worlds have", word(kind));
  if (kind == Kind::kAgent && name.empty() && world->agents().size() == 1 && world->agents()[0].name.empty()) return 0;
  return find_or_fail(*world, kind, name);
}

const char* name(const env::World& world, Kind kind, int id) {
  switch (kind) {
    case Kind::kAgent: return world.agents()[static_cast<std::size_t>(id)].name.c_str();
    case Kind::kFace: return world.faces()[static_cast<std::size_t>(id)].name.c_str();
    case Kind::kWarning: return engine::word(static_cast<engine::Warning>(id));
    case Kind::kContact:
    case Kind::kStepContact:
    case Kind::kWorld: return "";
    default: return engine::name(world.model(), of_model(kind), id);
  }
}

int body_of(const env::World& world, Kind kind, int id) {
  const mjModel& model = world.model();
  switch (kind) {
    case Kind::kBody: return model.body_parentid[id];
    case Kind::kJoint: return model.jnt_bodyid[id];
    case Kind::kGeom: return model.geom_bodyid[id];
    case Kind::kSite: return model.site_bodyid[id];
    case Kind::kCamera: return model.cam_bodyid[id];
    case Kind::kLight: return model.light_bodyid[id];
    default:
      fail(Status::kInvalidArgument, "kind is {} ({}), expected body, joint, geom, site, camera or light",
           static_cast<int>(kind), word(kind));
  }
}

}  // namespace mimo::access
