#include "blueprint/blueprint.h"

#include "render/renderer.h"

namespace mimo::blueprint {

// Nothing of an edit may fail once it takes the draft's place.
static_assert(std::is_nothrow_move_assignable_v<Draft>);

KitPtr Blueprint::compile(const env::EnvOptions& options, const LogSink& log) const {
  engine::ModelPtr model = scene::compile(draft_.scene.compose(), log_);
  draft_.scene.check_places(model, log_);
  return std::make_shared<const env::Kit>(around(std::move(model), options, log));
}

env::Kit Blueprint::around(engine::ModelPtr model, const env::EnvOptions& options, const LogSink& log) const {
  env::Kit kit{std::move(model), draft_.agents.all(), options, {}};
  kit.options.parameters = draft_.parameters;
  kit.options.cameras = draft_.cameras.all();
  kit.options.fields = draft_.fields.all();
  kit.options.custom_task = draft_.task;
  kit.services.shelf = render::make_shelf();
  kit.services.log = log;
  return kit;
}

KitPtr ready_world(const std::string& scene) {
  scene::Source source;
  source.name = scene;
  Blueprint blueprint(source);
  blueprint.edit([](Draft& draft) { draft.add_agents(usual_agent(draft.scene)); });
  return blueprint.compile({}, {});
}

std::unique_ptr<env::World> clone(const env::Kit& kit, const env::World& original, const env::Identity& identity) {
  std::vector<std::uint8_t> state(original.state_bytes());
  original.save(Span<std::uint8_t>(state));
  env::Services services = kit.services;
  services.skins = env::skins_of(original.agents());
  auto twin = std::make_unique<env::World>(kit.model, kit.agents, kit.options, services, identity);
  twin->load(Span<const std::uint8_t>(state));
  return twin;
}

}  // namespace mimo::blueprint
