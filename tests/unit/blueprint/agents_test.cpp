// Which agents go together, and with which bodies, roots, places and motors. The messages are part of the interface.
#include "blueprint/agents.h"

#include "scene/anatomy.h"
#include "unit/blueprint/fixture.h"

namespace mimo::test {
namespace {

Blueprint room() { return Blueprint(named("free")); }

Blueprint two_rods() {
  return Blueprint(
      from_text("<mujoco><worldbody><body name='one'><joint name='a' type='hinge'/><geom size='.1'/>"
                "</body><body name='two'><joint name='b' type='hinge'/><geom size='.1'/></body>"
                "</worldbody></mujoco>"));
}

AgentPlan part(const std::string& name, const std::string& root) {
  AgentPlan plan = infant(name);
  plan.options.root = root;
  plan.options.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_TORQUE;
  plan.options.vestibular.wanted = 0;
  plan.options.touch.wanted = 0;
  plan.body = "scene";
  return plan;
}

TEST(BlueprintAgents, AreNumberedInTheirOrder) {
  Blueprint blueprint = room();
  const auto add = [&](const char* name, double x) {
    return blueprint.edit([&](SceneEdit& edit) { return edit.add_agent(infant_at(name, x)); });
  };
  EXPECT_EQ(add("anna", 0), 0u);
  EXPECT_EQ(add("ben", 2), 1u);
  EXPECT_EQ(blueprint.current().agents.all()[1].name, "ben");
}

TEST(BlueprintAgents, HaveDifferentNames) {
  Blueprint blueprint = room();
  EXPECT_EQ(joining(blueprint, infant_at("anna", 0)), "");
  EXPECT_EQ(joining(blueprint, infant_at("anna", 2)),
            "name: there is an agent \"anna\" already; each needs a name of its own");
  EXPECT_EQ(joining(blueprint, infant_at("", 2)),
            "name is \"\", but each of several agents needs a name of its own, such as \"anna\"");
  EXPECT_EQ(joining(blueprint, infant_at("a/b", 2)), "name is \"a/b\", expected letters, digits, '_', '-' and '.'");

  Blueprint other = room();
  EXPECT_EQ(joining(other, infant_at("", 0)), "");
  EXPECT_EQ(joining(other, infant_at("", 2)),
            "name is \"\", but each of several agents needs a name of its own, such as \"anna\"");
  EXPECT_EQ(joining(other, infant_at("ben", 2)),
            "name is \"ben\", but the agent before it has none; each of several agents needs a name of its own");
}

TEST(BlueprintAgents, ARootBelongsToTheScene) {
  Blueprint blueprint = two_rods();
  AgentPlan plan = part("", "one");
  plan.body = "mitten";
  EXPECT_EQ(joining(blueprint, plan), "root is \"one\" and body is \"mitten\"; a root needs body \"scene\"");
  plan = part("", "one");
  plan.acts = scene::kHead;
  EXPECT_EQ(joining(blueprint, plan),
            "acts is 0x2, but only infants have these parts; with a root, expected 0 or MIMO_ACT_NONE");
  EXPECT_TRUE(blueprint.current().agents.all().empty());
}

TEST(BlueprintAgents, APartWithoutMotorsLeavesThemToOthers) {
  Blueprint blueprint = two_rods();
  AgentPlan idle = part("still", "two");
  idle.acts = scene::kNoGroup;
  EXPECT_EQ(joining(blueprint, part("busy", "one")), "");
  EXPECT_EQ(joining(blueprint, idle), "");
  EXPECT_FALSE(blueprint.current().agents.all()[0].actuation.none);
  EXPECT_TRUE(blueprint.current().agents.all()[1].actuation.none);
}

TEST(BlueprintAgents, AreAllThatTheSceneNames) {
  const auto all = [](const AgentPlan& plan) { return [&](SceneEdit& edit) { return edit.add_agents(plan); }; };
  Blueprint date(named("playdate"));
  EXPECT_EQ(refusal(date, all(infant("carl"))), "name is \"carl\", but the scene names its infants itself");
  EXPECT_EQ(refusal(date, all(infant_at("", 0))), "place is 1, but each of 2 infants has its own place");
  EXPECT_EQ(date.edit(all(infant(""))), 2u);
  EXPECT_EQ(date.current().agents.all()[0].name, "anna");
  EXPECT_EQ(date.current().agents.all()[1].name, "ben");

  Blueprint single(named("reach"));
  EXPECT_EQ(single.edit(all(infant("carl"))), 1u);
  EXPECT_EQ(single.current().agents.all()[0].name, "carl");
}

TEST(BlueprintAgents, ReadJointsAndBodies) {
  Blueprint blueprint = room();
  ASSERT_EQ(joining(blueprint, infant("")), "");
  const auto read = [](SceneEdit& edit) { edit.agents.read_joint(0, "robot:left_elbow"); };
  EXPECT_EQ(refusal(blueprint, read), "");
  EXPECT_EQ(refusal(blueprint, read), "joint \"robot:left_elbow\" is read already");
  const auto skin = [](const char* body) {
    return [body](SceneEdit& edit) { edit.agents.set_touch(0, body, 0.02, edit.scene); };
  };
  EXPECT_EQ(refusal(blueprint, skin("left_hand")), "");
  EXPECT_EQ(refusal(blueprint, skin("tail")).rfind("no body \"tail\"; the infant has: mimo_location, ", 0), 0u);
  EXPECT_EQ(blueprint.current().agents.all()[0].touch.spacing.size(), 1u);
  blueprint.edit([](SceneEdit& edit) { edit.agents.set_touch(0, 0.05); });
  EXPECT_TRUE(blueprint.current().agents.all()[0].touch.spacing.empty());
  EXPECT_EQ(blueprint.current().agents.all()[0].touch.everywhere, 0.05);
  for (const std::size_t nobody : {std::size_t{1}, std::size_t{7}}) {
    EXPECT_EQ(refusal(blueprint, [&](SceneEdit& edit) { edit.agents.limit_sense(nobody, "touch", {}); }),
              "agent is " + std::to_string(nobody) + ", but there are 1 agents");
  }
}

}  // namespace
}  // namespace mimo::test
