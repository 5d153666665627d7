// Tasks and their parameters.
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "tasks/task.h"

namespace mimo::capi {
namespace {

// Of what is no parameter of a sense of the user's own.
void require_task_parameter(const std::string& name, const blueprint::Agents& agents) {
  if (tasks::is_parameter(name)) return;
  std::vector<std::string> of_senses;
  for (const env::OwnSense::Parameter* parameter : agents.sense_parameters()) of_senses.push_back(parameter->name);
  tasks::fail_unknown_parameter(name, std::move(of_senses));
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

const char* mimo_task_name(size_t index) noexcept {
  const auto all = tasks::definitions();
  return index < all.size() ? all[index]->name : nullptr;
}

mimo_status mimo_parameter_count(size_t* count) noexcept {
  return guard([&] { out(count, "count") = tasks::parameters().size(); });
}

mimo_status mimo_parameter_describe(size_t index, mimo_parameter* parameter) noexcept {
  return guard([&] {
    const std::vector<const tasks::Parameter*> all = tasks::parameters();
    require(index < all.size(), "index is {}, but there are {} parameters", index, all.size());
    const tasks::Parameter& found = *all[index];
    mimo_parameter ours{};
    ours.name = found.name;
    ours.description = found.description;
    ours.standard = found.standard;
    ours.low = found.low;
    ours.high = found.high;
    write_described(parameter, ours, "parameter");
  });
}

mimo_status mimo_scene_set_parameter(mimo_scene* scene, const char* name, double value) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(name != nullptr, "name is NULL");
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      if (!edit.agents.set_sense_parameter(name, value)) {
        require_task_parameter(name, edit.agents);
        edit.parameters.set(name, value);
      }
      note(edit, {{"call", "set_parameter"}, {"name", name}, {"value", value}});
    });
  });
}

mimo_status mimo_scene_get_parameter(const mimo_scene* scene, const char* name, double* value) noexcept {
  return guard(scene, [&] {
    const blueprint::SceneEdit& current = open(scene).blueprint.current();
    require(name != nullptr, "name is NULL");
    const double* const of_sense = current.agents.sense_parameter(name);
    if (of_sense == nullptr) require_task_parameter(name, current.agents);
    out(value, "value") = of_sense != nullptr ? *of_sense : current.parameters[name];
  });
}

}  // extern "C"
