// mimo.hpp: reading worlds in types of C++. The numbers come from the scenes below, models/mitten.xml and physics.
#include <cmath>
#include <cstring>
#include <mimo/mimo.hpp>

#include "support/capi.h"

namespace {

constexpr double kRadius = 0.1, kMass = 2, kGravity = 9.81;

// A ball at rest on a floor, and an agent made of it: skin, no motors.
mimo::Env make_ball() {
  auto config = mimo::scene_config();
  config.xml =
      "<mujoco><option timestep='0.002'/><worldbody><light pos='0 0 3'/><geom name='floor' type='plane' size='5 5 1'/>"
      "<geom name='wall' type='box' pos='-4 0 1' size='0.1 4 1'/><body name='ball' pos='0 0 0.1'><freejoint "
      "name='ball'/>"
      "<geom name='ball' size='0.1' mass='2' rgba='1 0 0 1'/></body></worldbody></mujoco>";
  mimo::Scene scene(config);
  auto agent = mimo::agent_config();
  agent.body = "scene";
  agent.root = agent.vestibular_at = "ball";
  agent.vision = agent.proprioception = 0;
  scene.add_agent(agent);
  scene.set_touch(0.02);
  auto simulation = mimo::env_config();
  simulation.renderer = "ray";
  simulation.timing = 1;
  return mimo::Env(scene, simulation);
}

bool holds(const std::vector<std::string>& names, const char* name) {
  for (const std::string& candidate : names) {
    if (candidate == name) return true;
  }
  return false;
}

void check_names() {
  CHECK(holds(mimo::scene_names(), "standup") && holds(mimo::room_names(), "playroom"));
  CHECK(holds(mimo::task_names(), "reach") && mimo::task_names()[0] == "none");
  CHECK(mimo::face_names().size() == 7 && holds(mimo::face_names(), "surprise"));
  auto config = mimo::scene_config();
  config.name = "catch";
  const mimo_agent_config agent = mimo::Scene(config).default_agent();
  CHECK_TEXT("fingers", agent.body);
  CHECK(agent.actuation == MIMO_ACTUATION_MUSCLE);
}

// "1.0.0-rc1" is 1, 0, 0 and "-rc1"; the versions of headers and library are those of one build.
void check_versions() {
  CHECK(mimo::version() == std::to_string(MIMO_VERSION_MAJOR) + "." + std::to_string(MIMO_VERSION_MINOR) + "." +
                               std::to_string(MIMO_VERSION_PATCH) + MIMO_VERSION_LABEL);
  CHECK(mimo::abi_version() == MIMO_ABI_VERSION);
  CHECK(mimo::mujoco_version() == "2.2.2" || mimo::mujoco_version() == "4.0.1");
  CHECK_TEXT("MIMO_E_NOT_FOUND", mimo::status_name(MIMO_E_NOT_FOUND));
}

// One step an episode: the first one truncates it.
void check_parameters() {
  const char* const name = "reach/episode_steps";
  double standard = 0;
  for (const mimo_parameter& parameter : mimo::parameters()) {
    if (std::strcmp(parameter.name, name) == 0) standard = parameter.standard;
  }
  CHECK(standard > 1);
  auto config = mimo::scene_config();
  config.name = "reach";
  mimo::Scene scene(config);
  CHECK(scene.parameter(name) == standard);
  scene.set_parameter(name, 1);
  CHECK(scene.parameter(name) == 1);
  scene.add_agents();
  mimo::Env env(scene);
  mimo::Block block = env.make_block();
  env.reset(1, block);
  CHECK(env.step({}, block)[0].truncated);
  try {
    scene.set_parameter("reach/luck", 1);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_NOT_FOUND);
  }
}

// Setting the angles that looking takes makes the eyes meet there, and nothing has moved before.
void check_looks() {
  mimo::Env env = mimo::make("free");
  const mimo_gaze before = env.gaze();
  const double x = before.left_position[0] + 0.4, y = 0.05, z = before.left_position[2];
  const mimo::Look look = env.look_angles(x, y, z, MIMO_LOOK_HEAD);
  CHECK(look.joints.size() == 8 && look.angles.size() == 8);  // three an eye, two of the head
  CHECK_NEAR(0, look.misses[0], 1e-6);
  CHECK_NEAR(0, look.misses[1], 1e-6);
  CHECK(std::memcmp(before.left_direction, env.gaze().left_direction, sizeof before.left_direction) == 0);
  env.set_values(MIMO_JOINT_POSITION, look.joints, look.angles);
  CHECK_NEAR(x, env.gaze().point[0], 1e-6);
  CHECK_NEAR(y, env.gaze().point[1], 1e-6);
  CHECK_NEAR(z, env.gaze().point[2], 1e-6);
  CHECK(env.look_angles(x, y, z).joints.size() == 6);
  CHECK(env.look_at(-1, 0, z)[0] > 1);  // behind it: more than a right angle less 45 degrees
}

void check_reach() {
  const mimo::Env env = mimo::make("reach");
  CHECK(env.task() == "reach" && env.frame_skip() == 2 && env.timestep() == 0.005);
  const auto agents = env.agents();
  CHECK(agents.size() == 1 && agents[0].action_offset == 0 && agents[0].action_count == 8);
  const auto actions = env.layout().actions();
  CHECK(actions.size() == 8);
  CHECK_TEXT("act:right_elbow", actions[3].name);
  CHECK(actions[3].low == -1 && static_cast<float>(actions[3].high) == 0.83F && actions[3].agent == 0);
  const auto terms = env.layout().terms();
  CHECK(terms.size() == 2);
  CHECK_TEXT("distance", terms[0].name);
  CHECK(env.layout().label("proprioception/position", 0) == "robot:hip_lean1");

  const std::int32_t elbow = env.find(MIMO_JOINT, "robot:left_elbow");
  CHECK(env.name(MIMO_JOINT, elbow) == "robot:left_elbow");
  const std::int32_t forearm = env.body_of(MIMO_JOINT, elbow);
  CHECK(env.name(MIMO_BODY, forearm) == "left_lower_arm");
  CHECK(env.name(MIMO_BODY, env.body_of(MIMO_BODY, forearm)) == "left_upper_arm");
  CHECK(env.count(MIMO_CAMERA) == 2);
  CHECK(env.ids(MIMO_CAMERA) == (std::vector<std::int32_t>{0, 1}));
  CHECK(env.width(MIMO_BODY_ORIENTATION, {forearm, 0}) == 8);
  CHECK(env.width(MIMO_BODY_ORIENTATION, {}) == 0 && env.get_values(MIMO_BODY_ORIENTATION, {}).empty());
}

// A ball of 2 kg on a floor: it presses with its weight, straight down.
void check_contacts() {
  mimo::Env env = make_ball();
  CHECK(env.layout().actions().empty());
  const std::int32_t ball = env.find(MIMO_BODY, "ball");
  env.physics_step(1000);
  CHECK_NEAR(2.0, env.time(), 1e-9);
  CHECK(env.contact_count() == 1);
  const auto contacts = env.contacts();
  CHECK(contacts.size() == 1);
  const mimo::Contact& contact = contacts[0];
  CHECK(contact.geoms[0] == env.find(MIMO_GEOM, "floor") && contact.geoms[1] == env.find(MIMO_GEOM, "ball"));
  CHECK(contact.bodies[0] == 0 && contact.bodies[1] == ball);
  CHECK_NEAR(1, contact.normal[2], 1e-9);
  CHECK_NEAR(0, contact.tangents[0][2], 1e-9);
  CHECK_NEAR(0, contact.tangents[1][2], 1e-9);
  CHECK_NEAR(0, contact.position[2], 1e-3);
  CHECK(contact.distance < 0 && contact.distance > -1e-3);
  CHECK_NEAR(kMass * kGravity, contact.force[0], 1e-3);
  CHECK_NEAR(0, contact.force[1], 1e-3);
  CHECK_NEAR(0, contact.torque[1], 1e-3);

  // Up with 10 m/s, 0.02 m a step.
  env.set_values(MIMO_BODY_POSITION, {ball}, {0, 0, 1});
  env.set_values(MIMO_JOINT_VELOCITY, {env.find(MIMO_JOINT, "ball")}, {0, 0, 10, 0, 0, 0});
  env.physics_step();
  CHECK_NEAR(1, env.get_values(MIMO_GEOM_POSITION, {contact.geoms[1]})[2], 1e-3);  // as the step began
  env.update();
  CHECK_NEAR(1.02, env.get_values(MIMO_GEOM_POSITION, {contact.geoms[1]})[2], 1e-3);
  CHECK(env.contact_count() == 0 && env.contacts().empty());
}

double dot(const mimo::Vector& a, const mimo::Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Receptors lie on the ball and look away from its middle; the second tangent is the normal x the first.
void check_receptors() {
  const mimo::Env env = make_ball();
  const auto receptors = env.layout().receptors("touch/force");
  const mimo_field touch = env.layout().field("touch/force");
  CHECK(!receptors.empty() && receptors.size() == touch.shape[0] && receptors.size() == touch.receptors);
  for (const mimo::Receptor& receptor : receptors) {
    CHECK(receptor.body == env.find(MIMO_BODY, "ball") && receptor.geom == env.find(MIMO_GEOM, "ball"));
    const mimo::Vector &n = receptor.normal, &t = receptor.tangents[0];
    CHECK_NEAR(kRadius, std::sqrt(dot(receptor.position, receptor.position)), 1e-9);
    CHECK_NEAR(kRadius, dot(receptor.position, n), 1e-9);
    CHECK_NEAR(1, dot(t, t), 1e-9);
    const mimo::Vector across = {{n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]}};
    CHECK_NEAR(1, dot(across, receptor.tangents[1]), 1e-9);
  }
}

// Half a metre before the middle of a red ball, as high as it is.
mimo_picture_config before_ball() {
  auto config = mimo::picture_config();
  config.width = 64;
  config.height = 48;
  config.look_at[0] = config.look_at[1] = 0;
  config.look_at[2] = kRadius;
  config.distance = 0.5;
  config.azimuth = config.elevation = 0;
  config.fovy = 45;
  return config;
}

void check_pictures() {
  constexpr std::uint32_t kAll = MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION;
  mimo::Env env = make_ball();
  const auto config = before_ball();
  mimo::Pictures seen = env.render(config, kAll);
  CHECK(seen.color.width == 64 && seen.color.height == 48 && seen.color.pixels.size() == std::size_t{64} * 48);
  const std::size_t middle = 24 * 64 + 32;
  const mimo::Rgb red = seen.color.pixels[middle];
  CHECK(red.r > 2 * red.g && red.g == red.b);
  CHECK_NEAR(0.5 - kRadius, seen.depth.pixels[middle], 1e-3);
  CHECK(seen.segmentation.pixels[middle] == env.find(MIMO_GEOM, "ball"));
  CHECK(seen.segmentation.pixels[47 * 64] == env.find(MIMO_GEOM, "floor"));  // the lowest row: the top comes first
  CHECK(seen.segmentation.pixels[0] == -1);

  const auto pixels = env.project(config, {{{0, 0, kRadius}}, {{0, 0.05, kRadius}}});
  CHECK_NEAR(32, pixels[0][0], 1e-6);
  CHECK_NEAR(24, pixels[0][1], 1e-6);
  CHECK_NEAR(0.5, pixels[0][2], 1e-6);
  CHECK_NEAR(32 - 0.05 / 0.5 * 24 / std::tan(22.5 * 3.14159265358979 / 180), pixels[1][0], 1e-6);  // +y is to the left
  CHECK(env.project(config, {}).empty());

  const float* const depth = seen.depth.pixels.data();
  env.render(config, MIMO_VISION_DEPTH, seen);
  CHECK(seen.depth.pixels.data() == depth && seen.depth.width == 64);
  CHECK(seen.color.pixels.empty() && seen.color.width == 0 && seen.segmentation.pixels.empty());
  CHECK(std::memcmp(env.render(config).color.pixels.data(), env.render(config, kAll).color.pixels.data(),
                    std::size_t{3} * 64 * 48) == 0);

  auto huge = config;
  huge.width = huge.height = 4000000000U;
  try {
    env.render(huge, kAll, seen);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(std::strstr(error.what(), "width is 4000000000") != nullptr);
  }
  CHECK(seen.depth.width == 64 && seen.depth.pixels.size() == std::size_t{64} * 48);  // as it was
}

// A world that steps without sensing or telling results goes the same way.
void check_steps_without_observation() {
  mimo::Env env = mimo::make("reach"), twin = mimo::make("reach");
  mimo::Block block = env.make_block(), other = env.make_block(), nothing;
  mimo::Results results = env.make_results(), unwanted, emptied = results;
  CHECK(nothing.data() == nullptr && nothing.bytes() == 0);
  const std::vector<float> actions(env.layout().info().actions, 0.3F);
  env.reset(4, block);
  twin.reset(4, nothing);
  for (int i = 0; i < 5; ++i) {
    env.step(actions, block, results);
    twin.step(actions, nothing, unwanted);
  }
  CHECK(unwanted.reward.empty());
  emptied.reward.clear();  // though it has room
  emptied.terminated.clear();
  emptied.truncated.clear();
  emptied.outcome.clear();
  env.step(actions, block, results);
  twin.step(actions, other, emptied);
  CHECK(std::memcmp(block.data(), other.data(), block.bytes()) == 0);
}

void check_timing() {
  mimo::Env env = make_ball();
  mimo::Block block = env.make_block();
  for (int i = 0; i < 3; ++i) env.step({}, block);
  const mimo_timing timing = env.timing();
  CHECK(timing.steps == 3 && timing.physics > 0 && timing.total >= timing.physics + timing.touch);
  env.reset_timing();
  CHECK(env.timing().steps == 0 && env.timing().total == 0);
}

// The batch's worlds are environments, and stay the batch's.
void check_batch() {
  auto config = mimo::scene_config();
  config.name = "reach";
  mimo::Scene scene(config);
  scene.add_agent(scene.default_agent());
  auto many = mimo::batch_config();
  many.worlds = 2;
  mimo::Batch batch(scene, mimo::env_config(), many);
  mimo::Block blocks = batch.make_blocks();
  const std::size_t actions = batch.env(1).layout().info().actions;
  batch.reset({1, 2}, blocks);
  batch.env(1).physics_step(10);
  CHECK_NEAR(0.05, batch.env(1).time() - batch.env(0).time(), 1e-9);
  batch.env(0).physics_step(10);
  const std::uint8_t second[] = {0, 1};
  mimo_batch_reset_config only = {};
  only.struct_size = sizeof only;
  only.mask = second;
  only.worlds = 2;
  batch.reset(only, {}, blocks);
  CHECK_NEAR(0.05, batch.env(0).time() - batch.env(1).time(), 1e-9);
  batch.step(std::vector<float>(2 * actions), blocks);
  mimo::Env left = [&] {
    mimo::Batch gone(scene, 1);
    return gone.env(0);
  }();
  try {
    left.time();
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_BAD_HANDLE);
  }
}

// Without a config an infant is as its scene has it: made for a task that is done blind, it does not see.
void check_scene_s_own_agent() {
  auto config = mimo::scene_config();
  config.name = "reach";
  mimo::Scene one(config), all(config), seeing(config);
  one.add_agent();
  all.add_agents();
  seeing.add_agent(mimo::agent_config());
  const std::size_t bytes = mimo::Env(all).layout().info().block_bytes;
  CHECK(mimo::Env(one).layout().info().block_bytes == bytes);
  CHECK(mimo::Env(seeing).layout().info().block_bytes > bytes);
}

// Worlds of several ages, and resets that bring others.
void check_ages() {
  const auto aged = [](double months) {
    mimo_growth growth = mimo::growth();
    growth.age = months;
    return growth;
  };
  auto config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  auto infant = scene.default_agent();
  infant.vision = 0;
  scene.add_agent(infant);
  auto many = mimo::batch_config();
  many.worlds = 3;
  mimo::Batch batch(scene, mimo::env_config(), many, {aged(2), aged(20)});
  CHECK((batch.get_values(MIMO_AGENT_AGE) == std::vector<double>{2, 20, 2}));
  mimo::Block blocks = batch.make_blocks();
  batch.reset(mimo::batch_reset_config(), {aged(1), aged(2), aged(3)}, blocks);
  CHECK((batch.get_values(MIMO_AGENT_AGE) == std::vector<double>{1, 2, 3}));
  mimo::Env env(scene);
  mimo::Block block = env.make_block();
  env.reset(mimo::reset_config(), {aged(6)}, block);
  CHECK((env.get_values(MIMO_AGENT_AGE) == std::vector<double>{6}));
  env.reset(block);
  CHECK((env.get_values(MIMO_AGENT_AGE) == std::vector<double>{6}));
}

// Eyes and nerves that take their time.
void check_maturity() {
  CHECK(mimo::maturity(0).acuity == 0.70 && mimo::maturity(24).acuity == 11.1 && mimo::maturity().acuity == 0);
  auto config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  auto infant = scene.default_agent();
  infant.vision = infant.touch = 0;
  scene.add_agent(infant);
  const auto late = [&](const char* field, std::size_t element) {
    return mimo::Env(scene).layout().delays(field).at(element);
  };
  CHECK(late("proprioception/position", 0) == 0);
  mimo_maturity slow = mimo::maturity(0);
  slow.vestibular_delay = 0.1;
  scene.set_maturity(slow);
  CHECK_NEAR(0.1, late("vestibular/acceleration", 2), 1e-12);
  CHECK(late("proprioception/position", 0) > 0.02);
  scene.clear_maturity();
  CHECK(late("vestibular/acceleration", 2) == 0);
}

// A step in two halves, values of all worlds, and what became of each.
void check_batch_at_once() {
  auto config = mimo::scene_config();
  config.name = "reach";
  mimo::Scene scene(config);
  scene.add_agents();
  mimo::Batch batch(scene, 2), twin(scene, 2);
  mimo::Block blocks = batch.make_blocks(), others = twin.make_blocks();
  std::vector<float> actions(2 * batch.env(0).layout().info().actions, 0.2F);
  batch.reset({1, 2}, blocks);
  twin.reset({1, 2}, others);
  batch.send(actions, blocks);
  try {
    batch.world(0);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_BUSY);
  }
  batch.receive();
  twin.step(actions, others);
  CHECK(std::memcmp(blocks.data(), others.data(), blocks.bytes()) == 0);

  const std::vector<std::int32_t> elbow = {batch.env(0).find(MIMO_JOINT, "robot:right_elbow")};
  batch.set_values(MIMO_JOINT_POSITION, elbow, {-0.1, -0.2});
  CHECK(batch.get_values(MIMO_JOINT_POSITION, elbow) == (std::vector<double>{-0.1, -0.2}));
  batch.set_values(MIMO_JOINT_POSITION, elbow, {-0.3, -0.4}, {0, 1});
  CHECK(batch.get_values(MIMO_JOINT_POSITION, elbow) == (std::vector<double>{-0.1, -0.4}));
  CHECK(batch.get_values(MIMO_JOINT_POSITION, elbow, {0, 1}) == (std::vector<double>{0, -0.4}));

  const std::size_t half = blocks.bytes() / 2;
  batch.observe(others, {1, 0});
  CHECK(std::memcmp(blocks.data(), others.data(), half) != 0);  // the elbow is felt elsewhere
  CHECK(std::memcmp(blocks.data() + half, others.data() + half, half) == 0);
  batch.observe(others);
  CHECK(std::memcmp(blocks.data() + half, others.data() + half, half) != 0);

  actions.back() = std::nanf("");
  try {
    batch.step(actions, blocks);
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_INVALID_ARGUMENT);
  }
  CHECK(batch.world_error(0).status == MIMO_OK && batch.world_error(0).message.empty());
  CHECK(batch.world_error(1).status == MIMO_E_INVALID_ARGUMENT);
  CHECK(batch.world_error(1).message.find("not a number") != std::string::npos);
}

}  // namespace

int main() {
  check_names();
  check_versions();
  check_parameters();
  check_looks();
  check_reach();
  check_contacts();
  check_receptors();
  check_steps_without_observation();
  check_timing();
  check_batch();
  check_scene_s_own_agent();
  check_ages();
  check_maturity();
  check_batch_at_once();
  check_pictures();
  return failures();
}
