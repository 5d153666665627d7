// mimo.hpp: handles, blocks, states and batches do what the C functions below them do.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <mimo/mimo.hpp>
#include <new>
#include <string>
#include <typeinfo>
#include <vector>

#include "support/capi.h"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

// Every allocation of C++ in this program, in the header as in the library below it. Were some of these inlined,
// GCC would take them for others than those that belong together.
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(bytes > 0 ? bytes : 1);
}
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  if (void* memory = operator new(bytes, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

mimo::Scene room_named(const char* name) {
  mimo_scene_config room = mimo::scene_config();
  room.name = name;
  return mimo::Scene(room);
}

mimo::Scene make_scene() {
  mimo::Scene scene = room_named("reach");
  scene.add_agent(scene.default_agent());
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

bool lies_outside(const mimo::Block& block, const mimo_field& field) {
  try {
    block.view<float>(field);
    return false;
  } catch (const std::out_of_range& error) {
    return std::strstr(error.what(), field.name) != nullptr;
  }
}

void check_blocks() {
  mimo::Env env = mimo::make("reach");
  const mimo_field field = env.layout().field("proprioception/velocity");
  mimo::Block from = env.make_block();
  const std::size_t bytes = from.bytes();
  env.reset(1, from);
  const mimo::Block kept = from;
  mimo::Block to = std::move(from);
  CHECK(from.bytes() == 0 && from.data() == nullptr);
  CHECK(lies_outside(from, field));
  CHECK(to.bytes() == bytes && std::memcmp(to.data(), kept.data(), bytes) == 0);
  from = std::move(to);
  CHECK(to.bytes() == 0 && lies_outside(to, field));
  CHECK(from.view<float>(field).size() == 47);  // MIMo's joints in reach
  from = kept;
  CHECK(reinterpret_cast<std::uintptr_t>(from.data()) % 64 == 0);

  mimo::Block less(field.offset + field.bytes - 1);
  CHECK(lies_outside(less, field));
  mimo_field broken = field;
  broken.offset = SIZE_MAX - 3;
  CHECK(lies_outside(from, broken));
  try {
    from.view<double>(mimo_field{});
    CHECK(false);
  } catch (const std::invalid_argument&) {
  }
}

// With fields on request, one of which looks at the end of the step.
mimo::Env make_watched() {
  mimo_scene_config config = mimo::scene_config();
  config.name = "reach";
  mimo::Scene scene(config);
  scene.add_agents();
  scene.add_field("hand", MIMO_BODY_POSE | MIMO_NOW, {"right_hand"}, "head");
  scene.add_field("goal", MIMO_AGENT_GOAL, {""});
  return mimo::Env(scene);
}

void check_steps_that_allocate_nothing() {
  mimo::Env env = make_watched(), twin = make_watched();
  mimo::Block block = env.make_block(), other = env.make_block();
  mimo::Results results = env.make_results();
  const std::vector<float> actions(env.layout().info().actions, 0.3F);
  env.reset(4, block);
  twin.reset(4, other);
  env.step(actions, block, results);
  const std::size_t before = allocations;
  for (int i = 0; i < 10; ++i) env.step(actions, block, results);
  CHECK(allocations == before);
  mimo::Result last = {};
  for (int i = 0; i < 11; ++i) last = twin.step(actions, other)[0];
  CHECK(allocations > before);
  CHECK(std::memcmp(block.data(), other.data(), block.bytes()) == 0);
  CHECK(block.view<float>(env.layout().field("hand")).size() == 7);
  CHECK(results.reward[0] == last.reward && (results.terminated[0] != 0) == last.terminated);
  results.truncated.clear();
  try {
    env.step(actions, block, results);
    CHECK(false);
  } catch (const std::invalid_argument&) {
  }
}

void check_states() {
  mimo::Env env = mimo::make("reach");
  mimo::Block first = env.make_block(), second = env.make_block();
  const std::vector<float> actions(env.layout().info().actions, 0.5F);
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
  env.lock(elbow, -0.5);
  CHECK(env.get_values(MIMO_JOINT_LOCK, {elbow}) == (std::vector<double>{1, -0.5}));
  env.unlock(elbow);
  CHECK(env.get_values(MIMO_JOINT_LOCK, {elbow}) == (std::vector<double>{0, -0.5}));
  env.set_gravity(0, 0, -1.6);
  CHECK(env.get_values(MIMO_WORLD_GRAVITY) == (std::vector<double>{0, 0, -1.6}));
}

void check_batch() {
  mimo::Batch batch(make_scene(), 3);
  mimo::Env single = mimo::make("reach");
  mimo::Block blocks = batch.make_blocks(), block = single.make_block(), again = batch.make_blocks();
  CHECK(batch.size() == 3 && blocks.bytes() == 3 * block.bytes());
  const std::size_t count = single.layout().info().actions;
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
  const std::int32_t head = single.find(MIMO_BODY, "head");
  batch.set_values(MIMO_BODY_MASS, {head}, {1, 2, 3});
  CHECK(batch.get_values(MIMO_BODY_MASS, {head}) == (std::vector<double>{1, 2, 3}));
  CHECK(batch.get_floats(MIMO_BODY_MASS, {head}) == (std::vector<float>{1, 2, 3}));
  CHECK(batch.get_values(MIMO_WORLD_GRAVITY).size() == 9);
  CHECK(single.get_floats(MIMO_BODY_MASS).size() == single.count(MIMO_BODY));
  CHECK(single.warning_steps(1) == 0);
  batch.set_face("fear");
  CHECK(batch.env(2).face() == "fear");
}

// WHO's window of sitting without support; the same episode has the same movements.
void check_behaviours() {
  mimo::Scene sit = room_named("sit");
  const mimo_behaviour behaviour = sit.behaviour();
  CHECK(std::string(behaviour.measure) == "tilt upper_body z" && behaviour.norm_early == 3.8);
  try {
    make_scene().behaviour();
    CHECK(false);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == MIMO_E_NOT_FOUND);
  }
  mimo::Scene scene = room_named("rollover");
  scene.add_agents();
  mimo::Batch batch(scene, 2);
  mimo::Block blocks = batch.make_blocks();
  batch.reset({1, 2}, blocks);
  std::vector<float> all(2 * batch.layout().actions().size()), one(batch.layout().actions().size());
  batch.spontaneous(all);
  batch.env(1).spontaneous(one);
  CHECK(std::equal(one.begin(), one.end(), all.begin() + static_cast<std::ptrdiff_t>(one.size())));
  CHECK(std::any_of(one.begin(), one.end(), [](float action) { return action != 0; }));
}

// Parts of a program that were compiled with headers of different minor versions do not share classes.
void check_version_in_names() {
  const std::string version = "v" + std::to_string(MIMO_API_MAJOR) + "_" + std::to_string(MIMO_API_MINOR);
  CHECK(std::string(typeid(mimo::Env).name()).find(version) != std::string::npos);
}

}  // namespace

int main() {
  check_version_in_names();
  check_errors();
  check_blocks();
  check_steps_that_allocate_nothing();
  check_states();
  check_batch();
  check_behaviours();
  return failures();
}
