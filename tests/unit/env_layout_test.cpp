// The observation block: where fields lie, that every byte is written, and what switches take away.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <string>

#include "env/description.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using Block = std::vector<std::uint8_t>;

constexpr std::size_t kJoints = 47, kMotors = 44, kTorqueSites = 21;

std::map<std::string, std::vector<std::size_t>> shapes(const env::World& world) {
  std::map<std::string, std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    const observation::Field& field = world.layout()[i];
    EXPECT_EQ(result.count(field.name), 0u) << field.name << " is there twice";
    result[field.name] = field.shape;
  }
  return result;
}

env::AgentOptions all_senses() {
  env::AgentOptions options = blind();
  options.proprioception.wanted |= MIMO_PROPRIOCEPTION_JOINT_TORQUE;
  return options;
}

// Sizes of the original's mitten body: 47 joints, 44 motors, 21 torque sensors of three axes.
TEST(EnvLayout, FieldsOfTheMittenBody) {
  const std::map<std::string, std::vector<std::size_t>> expected = {
      {"proprioception/position", {kJoints}},       {"proprioception/velocity", {kJoints}},
      {"proprioception/torque", {kTorqueSites, 3}}, {"proprioception/limit", {kJoints}},
      {"proprioception/control", {kMotors}},        {"proprioception/motor_torque", {kMotors}},
      {"proprioception/joint_torque", {kJoints}},   {"vestibular/acceleration", {3}},
      {"vestibular/angular_velocity", {3}},         {"touch/force", {5685, 3}}};  // docs/differences.md
  EXPECT_EQ(shapes(*benchmark_world(all_senses())), expected);
}

TEST(EnvLayout, FieldsDoNotOverlap) {
  const auto world = benchmark_world(all_senses());
  const observation::Layout& layout = world->layout();
  std::size_t end = 0;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    EXPECT_EQ(layout[i].offset % 64, 0u) << layout[i].name;
    EXPECT_GE(layout[i].offset, end) << layout[i].name;
    EXPECT_LT(layout[i].offset - end, 64u) << "room is wasted before " << layout[i].name;
    EXPECT_EQ(layout[i].bytes(), layout[i].count() * 4) << "float32";
    end = layout[i].offset + layout[i].bytes();
  }
  EXPECT_EQ(layout.bytes() % 64, 0u);
  EXPECT_GE(layout.bytes(), end);
  EXPECT_LT(layout.bytes() - end, 64u);
}

TEST(EnvLayout, LabelsNameEveryElement) {
  const auto world = benchmark_world(all_senses());
  for (std::size_t i = 0; i < world->layout().size(); ++i) {
    const observation::Field& field = world->layout()[i];
    if (field.name.rfind("touch/", 0) == 0) continue;  // their receptors describe these
    std::set<std::string> labels;
    for (std::size_t k = 0; k < field.count(); ++k) labels.insert(field.label(k));
    EXPECT_EQ(labels.size(), field.count()) << field.name;
    EXPECT_EQ(labels.count(""), 0u) << field.name;
    EXPECT_STREQ(field.label(field.count()), "");
  }
}

// Two blocks that held other bytes before are equal afterwards: every byte was written, gaps as zeros.
template <typename Fill>
void expect_every_byte_written(const env::World& world, Fill&& fill) {
  Block one(world.layout().bytes() + 64, 0xab), two(world.layout().bytes() + 64, 0xcd);
  fill(one.data());
  fill(two.data());
  const std::size_t bytes = world.layout().bytes();
  EXPECT_EQ(std::memcmp(one.data(), two.data(), bytes), 0);
  EXPECT_EQ(Block(one.begin() + static_cast<std::ptrdiff_t>(bytes), one.end()), Block(64, 0xab))
      << "written beyond the block";
  std::size_t end = 0;
  for (std::size_t i = 0; i <= world.layout().size(); ++i) {
    const std::size_t next = i < world.layout().size() ? world.layout()[i].offset : bytes;
    for (std::size_t k = end; k < next; ++k) EXPECT_EQ(one[k], 0) << "gap at byte " << k;
    if (i < world.layout().size()) end = next + world.layout()[i].bytes();
  }
}

TEST(EnvLayout, EveryCallWritesEveryByte) {
  const auto world = benchmark_world(all_senses());
  const std::uint64_t seed = 3;
  expect_every_byte_written(*world, [&](std::uint8_t* block) { world->reset(&seed, block); });
  expect_every_byte_written(*world, [&](std::uint8_t* block) { world->observe(block); });
  expect_every_byte_written(*world, [&](std::uint8_t* block) {
    world->reset(nullptr, nullptr);
    world->step({}, block, {});
  });
}

struct Switch {
  const char* name;
  void (*off)(env::AgentOptions&);
  std::set<std::string> gone;
};

TEST(EnvLayout, SwitchesRemoveTheirFields) {
  const std::string p = "proprioception/";
  const Switch switches[] = {
      {"position",
       [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_POSITION; },
       {p + "position"}},
      {"velocity",
       [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_VELOCITY; },
       {p + "velocity"}},
      {"torque", [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_TORQUE; }, {p + "torque"}},
      {"limit", [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_LIMIT; }, {p + "limit"}},
      {"actuation",
       [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_ACTUATION; },
       {p + "control", p + "motor_torque"}},
      {"joint torque",
       [](env::AgentOptions& o) { o.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_JOINT_TORQUE; },
       {p + "joint_torque"}},
      {"vestibular",
       [](env::AgentOptions& o) { o.vestibular.wanted = 0; },
       {"vestibular/acceleration", "vestibular/angular_velocity"}},
  };
  for (const Switch& sense : switches) {
    SCOPED_TRACE(sense.name);
    auto expected = shapes(*benchmark_world(all_senses()));
    for (const std::string& field : sense.gone) EXPECT_EQ(expected.erase(field), 1u);
    env::AgentOptions options = all_senses();
    sense.off(options);
    EXPECT_EQ(shapes(*benchmark_world(options)), expected);
  }
}

TEST(EnvLayout, NoSensesAtAll) {
  env::AgentOptions options = blind();
  options.vestibular.wanted = 0;
  options.touch.wanted = 0;
  options.proprioception.wanted = 0;
  const auto world = benchmark_world(options);
  EXPECT_EQ(world->layout().size(), 0u);
  EXPECT_EQ(world->layout().bytes(), 0u);
  world->step({}, nullptr, {});
}

// Each of several agents has its own fields and its own slice of the actions.
TEST(EnvLayout, SeveralAgents) {
  scene::Scene scene(named("free"));
  const document::Pose left{{0, 1, 0.4}, {1, 0, 0, 0}}, right{{0, -1, 0.4}, {1, 0, 0, 0}};
  scene.add_body("mitten", "anna/", &left);
  scene.add_body("mitten", "ben/", &right);
  env::AgentOptions anna = blind(), ben = blind();
  anna.name = "anna";
  ben.name = "ben";
  env::World world(compile(scene), {anna, ben}, without_renderer());
  const auto fields = shapes(world);
  EXPECT_EQ(fields.size(), 18u);
  EXPECT_EQ(fields.count("anna/proprioception/position"), 1u);
  EXPECT_EQ(fields.count("ben/vestibular/acceleration"), 1u);
  EXPECT_EQ(world.action_size(), 2 * kMotors);
  EXPECT_EQ(world.agents()[1].action_offset, kMotors);
  const env::Description description = env::describe(world);
  EXPECT_EQ(description.actions.size(), 2 * kMotors);
  EXPECT_EQ(description.actions[kMotors - 1].agent, 0u);
  EXPECT_EQ(description.actions[kMotors].agent, 1u);
  EXPECT_EQ(description.actions[kMotors].name, "ben/act:hip_bend");
  std::vector<float> actions(2 * kMotors, 0.f);
  actions[kMotors] = 0.25f;
  world.step(actions, nullptr, {});
  EXPECT_EQ(world.data().ctrl[world.agents()[1].body.actuators[0]], 0.25);
  EXPECT_EQ(world.data().ctrl[world.agents()[0].body.actuators[0]], 0);
}

}  // namespace
}  // namespace mimo::test
