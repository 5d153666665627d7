// Blueprints and what they come to.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/fail.h"
#include "blueprint/blueprint.h"
#include "support/worlds.h"

namespace mimo::test {

using blueprint::AgentPlan;
using blueprint::Blueprint;
using blueprint::SceneEdit;

inline AgentPlan infant(const std::string& name) {
  AgentPlan plan;
  plan.options = blind();
  plan.options.name = name;
  return plan;
}

// A pose that is the plan's own, so that no room has to have a place.
inline AgentPlan infant_at(const std::string& name, double x) {
  AgentPlan plan = infant(name);
  plan.place.emplace();
  plan.place->pose.position = {x, 0, 1};
  return plan;
}

// The message of an edit that is refused, "" for one that is not.
template <typename Change>
std::string refusal(Blueprint& blueprint, Change&& change) {
  try {
    blueprint.edit(change);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// The same of adding an agent.
inline std::string joining(Blueprint& blueprint, const AgentPlan& plan) {
  return refusal(blueprint, [&](SceneEdit& edit) { edit.add_agent(plan); });
}

// All that can be told of a blueprint without compiling it.
inline std::string told(const Blueprint& blueprint) {
  const SceneEdit& edit = blueprint.current();
  std::string all = edit.scene.xml();
  for (const env::AgentOptions& agent : edit.agents.all()) {
    all += "agent " + agent.name + " root " + agent.root + " limits " + std::to_string(agent.limits.size());
    for (const std::string& joint : agent.joints) all += " reads " + joint;
    for (const auto& [body, spacing] : agent.touch.spacing) all += " skin " + body + " " + std::to_string(spacing);
    if (agent.touch.everywhere) all += " everywhere " + std::to_string(*agent.touch.everywhere);
  }
  for (const env::CameraOptions& camera : edit.cameras.all()) all += "camera " + camera.camera;
  all += "steps " + std::to_string(edit.parameters["reach/episode_steps"]);
  return all + (edit.task ? "own task" : "");
}

}  // namespace mimo::test
