#include "blueprint/blueprint.h"

#include <mujoco/mujoco.h>

#include <stdexcept>

#include "unit/blueprint/fixture.h"

namespace mimo::test {
namespace {

env::CameraOptions seen_by(const std::string& camera) {
  env::CameraOptions options;
  options.camera = camera;
  options.vision.width = options.vision.height = 8;
  return options;
}

blueprint::CameraPlan new_camera(const std::string& name) {
  return {seen_by(name), blueprint::Stand{"", {1, 2, 3}, {0, 0, 0}}};
}

// The whole compiled model, as MuJoCo writes it.
Bytes bytes_of(const mjModel& model) {
  Bytes bytes(static_cast<std::size_t>(mj_sizeModel(&model)));
  mj_saveModel(&model, nullptr, bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

// One with something of everything.
Blueprint furnished() {
  Blueprint blueprint(named("free"));
  blueprint.edit([](SceneEdit& edit) {
    edit.add_agent(infant_at("anna", 0));
    edit.add_camera(new_camera("aside"));
    edit.parameters.set("reach/episode_steps", 7);
  });
  return blueprint;
}

TEST(Blueprint, RefusedEditsChangeNothing) {
  Blueprint blueprint = furnished();
  const std::string before = told(blueprint);
  AgentPlan nobody = infant_at("carl", 2);
  nobody.body = "giant";
  blueprint::CameraPlan again = new_camera("aside");
  again.placed.reset();  // the scene has it
  blueprint::CameraPlan blank = new_camera("blank");
  blank.options.vision.wanted = 0;
  EXPECT_NE(joining(blueprint, infant_at("anna", 2)), "");
  EXPECT_NE(joining(blueprint, infant("ben")), "");
  EXPECT_NE(joining(blueprint, nobody), "");
  EXPECT_EQ(refusal(blueprint, [&](SceneEdit& edit) { edit.add_camera(again); }),
            "name: camera \"aside\" is observed already");
  EXPECT_EQ(refusal(blueprint, [&](SceneEdit& edit) { edit.add_camera(blank); }),
            "outputs is 0, expected at least one of the MIMO_VISION_ bits");
  EXPECT_NE(refusal(blueprint, [&](SceneEdit& edit) { edit.parameters.set("reach/episode_steps", -1); }), "");
  EXPECT_NE(refusal(blueprint, [&](SceneEdit& edit) { edit.scene.weld({"anna/head", "nowhere"}, nullptr); }), "");
  EXPECT_EQ(told(blueprint), before);
}

// The second infant of the scene is refused when the first is there already.
TEST(Blueprint, AllAgentsOfASceneOrNone) {
  Blueprint blueprint(named("playdate"));
  blueprint.edit([](SceneEdit& edit) { edit.add_agent(infant_at("ben", 5)); });
  const std::string before = told(blueprint);
  EXPECT_NE(refusal(blueprint, [](SceneEdit& edit) { edit.add_agents(infant("")); }), "");
  EXPECT_EQ(told(blueprint), before);
}

TEST(Blueprint, AnEditThatFailsInTheMiddleChangesNothing) {
  Blueprint blueprint = furnished();
  const std::string before = told(blueprint);
  const auto model = bytes_of(*blueprint.compile({}, {})->model);
  const auto half = [](SceneEdit& edit) {
    edit.add_agent(infant_at("ben", 2));
    edit.add_camera(new_camera("above"));
    edit.agents.read_joint(0, "robot:left_elbow");
    edit.agents.set_touch(0, 0.05);
    edit.agents.limit_sense(0, "touch", {});
    edit.parameters.set("reach/episode_steps", 9);
    edit.scene.start_joint("anna/robot:left_elbow", -0.5);
    edit.task = [](const env::Identity&, std::size_t) { return nullptr; };
    throw std::runtime_error("in the middle");
  };
  EXPECT_THROW(blueprint.edit(half), std::runtime_error);
  EXPECT_EQ(told(blueprint), before);
  EXPECT_EQ(bytes_of(*blueprint.compile({}, {})->model), model);
}

TEST(Blueprint, CompilesTwiceToTheSame) {
  const Blueprint blueprint = furnished();
  env::EnvOptions options;
  options.renderer = env::RendererChoice::kRay;
  const blueprint::CompiledWorldPtr compiled[2] = {blueprint.compile(options, {}), blueprint.compile(options, {})};
  EXPECT_NE(compiled[0]->model, compiled[1]->model);
  EXPECT_EQ(bytes_of(*compiled[0]->model), bytes_of(*compiled[1]->model));
  Bytes blocks[2], states[2];
  for (int i = 0; i < 2; ++i) {
    env::World world(compiled[i]->model, compiled[i]->agents, compiled[i]->options, compiled[i]->services);
    blocks[i] = step(world, 3);
    states[i] = saved(world);
  }
  EXPECT_EQ(blocks[0], blocks[1]);
  EXPECT_EQ(states[0], states[1]);
}

TEST(Blueprint, GivesWorldsItsSettings) {
  const blueprint::CompiledWorldPtr compiled = furnished().compile({}, {});
  ASSERT_EQ(compiled->agents.size(), 1u);
  EXPECT_EQ(compiled->agents[0].name, "anna");
  ASSERT_EQ(compiled->options.cameras.size(), 1u);
  EXPECT_EQ(compiled->options.cameras[0].camera, "aside");
  EXPECT_EQ(compiled->options.parameters["reach/episode_steps"], 7);
  EXPECT_GE(engine::find(*compiled->model, engine::Kind::kCamera, "aside"), 0);
  EXPECT_GE(engine::find(*compiled->model, engine::Kind::kBody, "anna/mimo_location"), 0);
}

}  // namespace
}  // namespace mimo::test
