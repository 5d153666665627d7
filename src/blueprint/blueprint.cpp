#include "blueprint/blueprint.h"

#include "base/fail.h"
#include "base/format.h"
#include "env/succession.h"
#include "env/world.h"
#include "render/renderer.h"

namespace mimo::blueprint {

// Nothing of an edit may fail once it takes the draft's place.
static_assert(std::is_nothrow_move_assignable_v<Draft>);

namespace {

// A task needs somebody. So does a built-in scene, as a rule; other worlds may be of physics alone.
void check_agents(const Draft& draft, const env::Kit& kit, const LogSink& log) {
  if (!kit.agents.empty()) return;
  constexpr const char* kRemedy = "mimo_scene_add_agents adds its infants";
  const std::string task = env::task_of(kit.options, *kit.model);
  require(task == "none", "task \"{}\" is for agents, and the scene has none; {}", task, kRemedy);
  const std::string& scene = draft.scene.built_in();
  if (scene.empty()) return;
  log(LogLevel::kInfo, format("scene \"{}\" has no agents, so nobody senses or acts in it; {}", scene, kRemedy));
}

}  // namespace

env::Kit compile(const Draft& draft, const env::EnvOptions& options, const LogSink& scene_log, const LogSink& log) {
  engine::ModelPtr model = scene::compile(draft.scene.compose(), scene_log);
  draft.scene.check_places(model, scene_log);
  env::Kit kit = around(draft, std::move(model), options, log);
  check_agents(draft, kit, log ? log : scene_log);
  return kit;
}

env::Kit around(const Draft& draft, engine::ModelPtr model, const env::EnvOptions& options, const LogSink& log) {
  env::Kit kit{std::move(model), draft.agents.all(), options, {}};
  kit.options.parameters = draft.parameters;
  kit.options.cameras = draft.cameras.all();
  kit.options.fields = draft.fields.all();
  kit.options.room_temperature = draft.room_temperature;
  kit.options.things = draft.things;
  kit.options.play = draft.play;
  kit.options.custom_task = draft.task;
  kit.services.shelf = render::make_shelf();
  kit.services.skins = std::make_shared<env::Skins>();
  kit.services.log = log;
  return kit;
}

Blueprint ready_world(const std::string& scene) {
  scene::Source source;
  source.name = scene;
  Blueprint blueprint(source);
  blueprint.edit([](Draft& draft) { draft.add_agents(usual_agent(draft.scene)); });
  return blueprint;
}

std::unique_ptr<env::World> clone(const env::Kit& kit, const env::World& original, const env::Identity& identity) {
  std::vector<std::uint8_t> state(original.state_bytes());
  original.save(Span<std::uint8_t>(state));
  auto twin = env::make_world(kit, kit.services, identity);
  twin->load(Span<const std::uint8_t>(state));
  return twin;
}

}  // namespace mimo::blueprint
