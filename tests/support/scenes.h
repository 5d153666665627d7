// Scenes and worlds as tests need them.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>

#include "compat/mujoco.h"
#include "engine/model.h"
#include "env/world.h"
#include "scene/scene.h"

namespace mimo::test {

inline scene::Source named(const std::string& name) {
  scene::Source source;
  source.name = name;
  return source;
}

inline scene::Source from_text(const std::string& xml) {
  scene::Source source;
  source.xml = xml;
  return source;
}

inline scene::Source from_file(const std::string& path) {
  scene::Source source;
  source.file = path;
  return source;
}

inline engine::ModelPtr compile(const scene::Scene& scene) { return document::compile(scene.compose(), {}); }

// A built-in room with one infant at the room's own place.
inline engine::ModelPtr room_with_infant(const std::string& room, const std::string& body = "mitten") {
  scene::Scene scene(named(room));
  scene.add_body(body, "", nullptr);
  return compile(scene);
}

// Compiled once for all tests of a program.
inline engine::ModelPtr benchmark_model(const std::string& body = "mitten") {
  static std::map<std::string, engine::ModelPtr> models;
  engine::ModelPtr& model = models[body];
  if (model == nullptr) model = room_with_infant("benchmark", body);
  return model;
}

// What a folder of tables in tests/golden is about: v1 is the original's mitten-handed infant, v2 the five-fingered
// one.
inline engine::ModelPtr golden_model(const std::string& tables) {
  if (tables == "v1_benchmark") return benchmark_model();
  if (tables == "v2_benchmark") return benchmark_model("fingers");
  return room_with_infant(tables, tables == "catch" || tables == "showroom" ? "fingers" : "mitten");
}

// An infant held still 1 m above the origin: its root hangs on a stiff weld, all joints are locked at 0, no floor.
inline engine::ModelPtr held_infant(const std::array<double, 4>& quat) {
  scene::Scene scene(
      from_text("<mujoco><include file='mimo/parts/options.xml'/><worldbody/>"
                "<equality><weld name='hold' body1='mimo_location' solref='.01 1' solimp='.9999 .9999 .001 .5 "
                "1'/></equality></mujoco>"));
  const document::Pose pose{{0, 0, 1}, quat};
  scene.add_body("mitten", "", &pose);
  engine::ModelPtr model = compile(scene);
  // Nobody else has the model yet.
  std::fill_n(const_cast<mjModel*>(model.get())->*compat::kLockFlags, model->neq, static_cast<mjtByte>(1));
  return model;
}

// One infant with all senses but vision.
inline env::AgentOptions blind() {
  env::AgentOptions options;
  options.vision = {};
  options.vision.wanted = 0;
  return options;
}

// For batches of one age.
inline std::vector<env::CompiledWorldPtr> compiled_worlds_of(env::CompiledWorld compiled) {
  return {std::make_shared<const env::CompiledWorld>(std::move(compiled))};
}

inline env::EnvOptions without_renderer() {
  env::EnvOptions options;
  options.renderer = env::RendererChoice::kNone;
  return options;
}

inline std::unique_ptr<env::World> benchmark_world(const env::AgentOptions& agent = blind(),
                                                   const env::EnvOptions& options = without_renderer()) {
  return std::make_unique<env::World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, options);
}

// The key that golden files use for a joint: its name, or "free:<body>" for a free joint without one.
inline std::string joint_key(const mjModel& model, int joint) {
  const std::string name = engine::name(model, engine::Kind::kJoint, joint);
  return name.empty() ? std::string("free:") + engine::name(model, engine::Kind::kBody, model.jnt_bodyid[joint]) : name;
}

inline int position_width(const mjModel& model, int joint) { return model.jnt_type[joint] == mjJNT_FREE ? 7 : 1; }
inline int velocity_width(const mjModel& model, int joint) { return model.jnt_type[joint] == mjJNT_FREE ? 6 : 1; }

}  // namespace mimo::test
