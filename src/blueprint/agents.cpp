#include "blueprint/agents.h"

#include <algorithm>
#include <string_view>

#include "access/requested_fields.h"
#include "base/fail.h"
#include "base/format.h"
#include "base/header.h"
#include "document/names.h"
#include "scene/anatomy.h"

namespace mimo::blueprint {
namespace {

// An agent that is no infant consists of a body of the scene's, with motors that no group knows.
void join_as_part(AgentPlan& plan) {
  const std::string& root = plan.options.root;
  require(plan.body == "scene", "root is \"{}\" and body is \"{}\"; a root needs body \"scene\"", root, plan.body);
  require(plan.acts == 0 || plan.acts == scene::kNoGroup,
          "acts is {:#x}, but only infants have these parts; with a root, expected 0 or MIMO_ACT_NONE", plan.acts);
  plan.options.actuation.none = plan.acts == scene::kNoGroup;
}

void join_as_infant(const AgentPlan& plan, scene::Scene& scene) {
  const std::string prefix = plan.options.prefix();
  require(plan.body != "scene" || !plan.place,
          "place is {}, but the body is part of the scene; expected 0, its place in the scene",
          static_cast<int>(plan.place->anchor));
  if (plan.body == "scene") return scene.choose_motors(prefix, plan.acts);
  const document::Place place = plan.place.value_or(document::Place{});
  scene.add_body(plan.body, prefix, plan.place ? &place.pose : nullptr, plan.acts, place.anchor);
}

// Whether there is such a body; of what is no infant only the compiled model can tell.
void require_part(const env::AgentOptions& options, const std::string& body, const scene::Scene& scene) {
  const std::vector<std::string> names = scene.body_names(options.prefix());
  const bool known = options.root.empty() && !names.empty();
  if (known && std::find(names.begin(), names.end(), body) == names.end()) {
    fail(Status::kNotFound, "no body \"{}\"; the infant has: {}", body, join(names, ", "));
  }
}

scene::Camera camera_of(const env::CameraOptions& options, const Stand& stand) {
  scene::Camera camera;
  camera.name = options.camera;
  camera.body = stand.body;
  camera.position = stand.position;
  camera.look_at = stand.look_at;
  if (options.vision.fovy > 0) camera.fovy = options.vision.fovy;
  return camera;
}

}  // namespace

env::AgentOptions& Agents::at(std::size_t agent) {
  const std::size_t count = agents_.size();
  require(agent < count, "agent is {}, but there are {} agents", agent, count);
  return agents_[agent];
}

void Agents::require_name(const std::string& name) const {
  document::require_plain(name);
  for (const env::AgentOptions& other : agents_) {
    require(!name.empty(), "name is \"\", but each of several agents needs a name of its own, such as \"anna\"");
    require(!other.name.empty(),
            "name is \"{}\", but the agent before it has none; each of several agents needs a name of its own", name);
    require(other.name != name, "name: there is an agent \"{}\" already; each needs a name of its own", name);
  }
}

std::size_t Agents::add(const AgentPlan& plan, scene::Scene& scene) {
  require_name(plan.options.name);
  require(plan.options.reflexes.wanted == 0 || plan.options.root.empty(),
          "reflexes is {:#x}, but the agent is body \"{}\" and its children, and only infants have reflexes",
          plan.options.reflexes.wanted, plan.options.root);
  AgentPlan own = plan;
  own.options.root.empty() ? join_as_infant(own, scene) : join_as_part(own);
  agents_.push_back(std::move(own.options));
  const std::size_t number = agents_.size() - 1;
  if (own.growth) grow(number, *own.growth, scene);
  return number;
}

std::size_t Agents::add_all(const AgentPlan& plan, scene::Scene& scene) {
  const std::string& given = plan.options.name;
  std::vector<std::string> names = scene.infants();
  require(names.empty() || given.empty(), "name is \"{}\", but the scene names its infants itself", given);
  if (names.empty()) names.push_back(given);
  require(!plan.place || names.size() == 1, "place is {}, but each of {} infants has its own place",
          static_cast<int>(plan.place->anchor), names.size());
  for (const std::string& name : names) {
    AgentPlan own = plan;
    own.options.name = name;
    add(own, scene);
  }
  return names.size();
}

void Agents::read_joint(std::size_t agent, const std::string& joint) {
  std::vector<std::string>& joints = at(agent).joints;
  require(std::find(joints.begin(), joints.end(), joint) == joints.end(), "joint \"{}\" is read already", joint);
  joints.push_back(joint);
}

void Agents::limit_sense(std::size_t agent, const std::string& path, const observation::Limits& limits) {
  at(agent).limits.push_back({path, limits});
}

void Agents::forgive_limits() {
  for (env::AgentOptions& agent : agents_) {
    for (observation::PathLimits& limits : agent.limits) {
      const std::string_view sense = std::string_view(limits.path).substr(0, limits.path.find('/'));
      limits.may_lead_nowhere = std::any_of(std::begin(header::kSenses), std::end(header::kSenses),
                                            [&](const header::Sense& one) { return one.name == sense; });
    }
  }
}

void Agents::limit_motor(std::size_t agent, const std::string& path, const observation::Limits& limits) {
  require(limits.blur == 0, "blur is {}, but motors have no pictures", limits.blur);
  const unsigned group = scene::group_named(path);
  const auto concern = [path, group](const std::string& action) {
    const bool muscle = action.compare(0, path.size() + 1, path + "/") == 0;  // one of a motor's two
    return path.empty() || path == action || muscle || (group != 0 && scene::group_of(action) == group);
  };
  at(agent).motors.push_back({path, concern, limits});
}

void Agents::set_maturity(std::size_t agent, const std::optional<env::Maturity>& maturity) {
  env::AgentOptions& options = at(agent);
  require(!maturity || options.root.empty() || !maturity->nerves.any(),
          "maturity: agent {} is body \"{}\" and its children, and only infants have nerves with a delay", agent,
          options.root);
  options.maturity = maturity;
}

void Agents::set_sensory_delay(std::size_t agent, const std::string& body, double seconds, const scene::Scene& scene) {
  env::AgentOptions& options = at(agent);
  require_part(options, body, scene);
  options.delays.parts[body] = seconds;
}

void Agents::set_sensory_delay(std::size_t agent, double seconds) { at(agent).delays = {seconds, {}}; }

void Agents::be_as_old_as(const std::vector<growth::Growth>& growths) {
  for (std::size_t i = 0; i < agents_.size(); ++i) agents_[i].growth = growths.at(i);
}

void Agents::grow(std::size_t agent, const growth::Growth& growth, scene::Scene& scene) {
  env::AgentOptions& options = at(agent);
  require(options.root.empty(), "growth: agent {} is body \"{}\" and its children, but only infants grow", agent,
          options.root);
  scene.grow(options.prefix(), growth.body ? growth : growth::Growth{});
  options.growth = growth;
}

void Agents::set_touch(std::size_t agent, const std::string& body, double spacing, const scene::Scene& scene) {
  env::AgentOptions& options = at(agent);
  require_part(options, body, scene);
  options.touch.spacing[body] = spacing;
}

void Agents::set_touch(std::size_t agent, double spacing) {
  senses::TouchOptions& touch = at(agent).touch;
  touch.spacing.clear();
  touch.everywhere = spacing;
}

void Agents::add_sense(std::size_t agent, const env::OwnSense& sense) {
  env::AgentOptions& options = at(agent);
  for (const env::OwnSense& other : options.own_senses) {
    require(other.name != sense.name, "name: agent {} has a sense \"{}\" already", agent, sense.name);
  }
  env::OwnSense own = sense;
  for (env::OwnSense::Parameter& parameter : own.parameters) {
    parameter.name = options.prefix() + own.name + "/" + parameter.name;
    for (const tasks::Parameter* other : tasks::parameters()) {
      require(parameter.name != other->name, "a task has a parameter \"{}\" already", other->name);
    }
  }
  options.own_senses.push_back(std::move(own));
}

std::vector<const env::OwnSense::Parameter*> Agents::sense_parameters() const {
  std::vector<const env::OwnSense::Parameter*> all;
  for (const env::AgentOptions& agent : agents_) {
    for (const env::OwnSense& sense : agent.own_senses) {
      for (const env::OwnSense::Parameter& parameter : sense.parameters) all.push_back(&parameter);
    }
  }
  return all;
}

const double* Agents::sense_parameter(const std::string& name) const {
  for (const env::AgentOptions& agent : agents_) {
    for (const env::OwnSense& sense : agent.own_senses) {
      for (std::size_t i = 0; i < sense.parameters.size(); ++i) {
        if (sense.parameters[i].name == name) return &sense.values[i];
      }
    }
  }
  return nullptr;
}

bool Agents::set_sense_parameter(const std::string& name, double value) {
  for (env::AgentOptions& agent : agents_) {
    for (env::OwnSense& sense : agent.own_senses) {
      for (std::size_t i = 0; i < sense.parameters.size(); ++i) {
        const env::OwnSense::Parameter& known = sense.parameters[i];
        if (known.name != name) continue;
        require_between(value, known.low, known.high, name.c_str());
        sense.values[i] = value;
        return true;
      }
    }
  }
  return false;
}

void Cameras::add(const CameraPlan& plan, scene::Scene& scene) {
  require(plan.options.vision.wanted != 0, "outputs is 0, expected at least one of the MIMO_VISION_ bits");
  for (const env::CameraOptions& other : cameras_) {
    require(other.camera != plan.options.camera, "name: camera \"{}\" is observed already", other.camera);
  }
  if (plan.placed) scene.add_camera(camera_of(plan.options, *plan.placed));
  cameras_.push_back(plan.options);
}

void Fields::add(const access::FieldOptions& field) {
  access::check(field);
  for (const access::FieldOptions& other : fields_) {
    require(other.name != field.name, "name: there is a field \"{}\" already", field.name);
  }
  fields_.push_back(field);
}

env::FurtherSense Fields::sense() const {
  if (fields_.empty()) return {};
  return [fields = fields_](const mjModel& model, const env::World* world) {
    return std::make_unique<access::RequestedFields>(model, world, fields);
  };
}

}  // namespace mimo::blueprint
