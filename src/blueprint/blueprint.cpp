#include "blueprint/blueprint.h"

#include "base/fail.h"
#include "base/format.h"
#include "env/world.h"
#include "render/renderer.h"

namespace mimo::blueprint {

// Nothing of an edit may fail once it takes the place of the last one.
static_assert(std::is_nothrow_move_assignable_v<SceneEdit>);

namespace {

// A task needs somebody. So does a built-in scene, as a rule; other worlds may be of physics alone.
void check_agents(const SceneEdit& edit, const env::CompiledWorld& compiled, const LogSink& log) {
  if (!compiled.agents.empty()) return;
  constexpr const char* kRemedy = "mimo_scene_add_agents adds its infants";
  const std::string task = env::task_of(compiled.options, *compiled.model);
  require(task == "none", "task \"{}\" is for agents, and the scene has none; {}", task, kRemedy);
  const std::string& scene = edit.scene.built_in();
  if (scene.empty()) return;
  log(LogLevel::kInfo, format("scene \"{}\" has no agents, so nobody senses or acts in it; {}", scene, kRemedy));
}

}  // namespace

env::CompiledWorld compile(const SceneEdit& edit, const env::EnvOptions& options, const LogSink& scene_log,
                           const LogSink& log) {
  engine::ModelPtr model = document::compile(edit.scene.compose(), scene_log);
  edit.scene.check_places(model, scene_log);
  env::CompiledWorld compiled = around(edit, std::move(model), options, log);
  check_agents(edit, compiled, log ? log : scene_log);
  return compiled;
}

env::CompiledWorld around(const SceneEdit& edit, engine::ModelPtr model, const env::EnvOptions& options,
                          const LogSink& log) {
  env::CompiledWorld compiled{std::move(model), edit.agents.all(), options, {}};
  compiled.options.parameters = edit.parameters;
  compiled.options.cameras = edit.cameras.all();
  compiled.options.further_sense = edit.fields.sense();
  compiled.options.room_temperature = edit.room_temperature;
  compiled.options.things = edit.things;
  compiled.options.play = edit.play;
  compiled.options.custom_task = edit.task;
  compiled.services.shelf = render::make_shelf();
  compiled.services.skins = std::make_shared<env::Skins>();
  compiled.services.log = log;
  return compiled;
}

}  // namespace mimo::blueprint
