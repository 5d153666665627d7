// mimo.hpp: handles, blocks, states and batches do what the C functions below them do.
#include <cstring>
#include <mimo/mimo.hpp>

#include "support/capi.h"

namespace {

mimo::Scene make_scene() {
  mimo_scene_config room = mimo::scene_config();
  room.name = "reach";
  mimo::Scene scene(room);
  mimo_agent_config agent = mimo::agent_config();
  check(mimo_scene_default_agent(scene.get(), &agent, sizeof agent) == MIMO_OK, "default agent", __LINE__);
  scene.add_agent(agent);
  return scene;
}

void check_errors() {
  try {
    mimo::make("nowhere");
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_NOT_FOUND);
    CHECK(std::strstr(error.what(), "nowhere") != nullptr);
  }
}

void check_states() {
  mimo::Env env = mimo::make("reach");
  mimo::Block first = env.make_block(), second = env.make_block();
  const std::vector<float> actions(env.action_size(), 0.5F);
  env.reset(3, first);
  const std::vector<std::uint8_t> state = env.save();
  mimo::Env twin = env.clone();
  env.step(actions, first);
  twin.step(actions, second);
  CHECK(std::memcmp(first.data(), second.data(), first.bytes()) == 0);
  env.load(state);
  env.step(actions, second);
  CHECK(std::memcmp(first.data(), second.data(), first.bytes()) == 0);

  const std::int32_t elbow = env.find(MIMO_JOINT, "robot:left_elbow");
  std::uint8_t locked = 9;
  env.lock(elbow, -0.5);
  CHECK_OK(mimo_env_lock_state(env.get(), elbow, &locked, nullptr));
  CHECK(locked == 1);
  env.unlock(elbow);
  CHECK_OK(mimo_env_lock_state(env.get(), elbow, &locked, nullptr));
  CHECK(locked == 0);
  double gravity[3] = {};
  env.set_gravity(0, 0, -1.6);
  CHECK_OK(mimo_env_gravity(env.get(), gravity, 3));
  CHECK(gravity[2] == -1.6);
}

void check_batch() {
  mimo::Batch batch(make_scene(), 3);
  mimo::Env single = mimo::make("reach");
  mimo::Block blocks = batch.make_blocks(), block = single.make_block(), again = batch.make_blocks();
  CHECK(batch.size() == 3 && blocks.bytes() == 3 * block.bytes());
  const std::size_t count = single.action_size();
  const std::vector<float> actions(3 * count, 0.3F);
  batch.reset({5, 6, 7}, blocks);
  const std::vector<std::uint8_t> states = batch.save();
  batch.step(actions, blocks);
  for (std::size_t i = 0; i < 3; ++i) {
    single.reset(5 + i, block);
    single.step(std::vector<float>(count, 0.3F), block);
    CHECK(std::memcmp(blocks.data() + i * block.bytes(), block.data(), block.bytes()) == 0);
  }
  batch.load(states);
  batch.step(actions, again);
  CHECK(std::memcmp(blocks.data(), again.data(), blocks.bytes()) == 0);
  batch.set_face("fear");
  const char* face = nullptr;
  CHECK_OK(mimo_env_face(batch.world(2), 0, &face));
  CHECK_TEXT("fear", face);
}

}  // namespace

int main() {
  check_errors();
  check_states();
  check_batch();
  return failures();
}
