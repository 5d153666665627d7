// Senses of one's own through mimo.hpp: each function of the class is called, and what it throws is told.
#include <cstdio>
#include <stdexcept>

#include "mimo/mimo.hpp"
#include "support/capi.h"

namespace {

enum class In { kNowhere, kConstructor, kReset, kAdvance, kWrite };

In throws = In::kNowhere;
bool throws_a_number = false;
int living = 0;

void throw_in(In place) {
  if (throws != place) return;
  if (throws_a_number) throw 7;
  throw std::runtime_error("no nose");
}

struct Memory {
  double resets, ticks;
};

// How often it was called, and what it was told; "nose/balance" is what the organ of balance feels.
class Nose : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() { return {mimo::sense_parameter("gain", "1", 2, 0, 4)}; }

  explicit Nose(mimo::SenseOpening& opening)
      : balance_(opening.world.layout().find(opening.own("vestibular/angular_velocity"))) {
    throw_in(In::kConstructor);
    mimo::SenseField told("told", {2, 2}, "1", "nose");
    told.dtype = MIMO_F64;
    told.labels = {"resets", "ticks", "gain", "head"};
    told.low = -10;
    told.high = 1000;
    opening.add(told);
    opening.add(mimo::SenseField("balance", {3}));
    opening.memory_bytes = sizeof(Memory);
    opening.sensors = true;
    head_ = opening.world.find(MIMO_BODY, opening.own("head"));
    ++living;
  }
  ~Nose() override { --living; }

  void reset(const mimo::SenseMoment& now) const override {
    throw_in(In::kReset);
    now.memory<Memory>().resets += 1;
  }
  void advance(const mimo::SenseMoment& now) const override {
    throw_in(In::kAdvance);
    now.memory<Memory>().ticks += 1;
    CHECK(now.memory<Memory>().ticks == static_cast<double>(now.told.tick));
  }
  void write(const mimo::SenseMoment& now) const override {
    throw_in(In::kWrite);
    double* const told = now.field<double>(0);
    told[0] = now.memory<Memory>().resets;
    told[1] = now.memory<Memory>().ticks;
    told[2] = now.told.parameters[0];
    told[3] = now.world.get_values(MIMO_BODY_POSITION, {head_})[2];
    for (int axis = 0; axis < 3; ++axis) now.field(1)[axis] = now.feel(balance_)[axis];
  }

 private:
  std::size_t balance_;
  std::int32_t head_;
};

mimo::Scene scene_with_nose() {
  mimo_scene_config config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  mimo_agent_config agent = mimo::agent_config();
  agent.vision = agent.touch = 0;
  scene.add_agent(agent);
  scene.add_sense(mimo::sense<Nose>("nose", 3));
  return scene;
}

void check_calls() {
  mimo::Scene scene = scene_with_nose();
  const std::vector<mimo_parameter> parameters = scene.sense_parameters();
  CHECK(parameters.size() == 1 && parameters[0].standard == 2 && parameters[0].high == 4);
  CHECK_TEXT("nose/gain", parameters[0].name);
  scene.set_parameter("nose/gain", 3);
  CHECK(scene.parameter("nose/gain") == 3);
  {
    mimo::Env world(scene);
    CHECK(living == 1);
    mimo::Block block = world.make_block();
    const mimo_field field = world.layout().field("nose/told");
    CHECK(field.dtype == MIMO_F64 && field.ndim == 2 && field.shape[1] == 2 && field.low == -10 && field.high == 1000);
    CHECK_TEXT("nose", field.frame);
    const mimo::View<const double> told = block.view<double>(field);
    const mimo::View<const float> balance = block.view<float>(world.layout().field("nose/balance"));
    const mimo::View<const float> turning = block.view<float>(world.layout().field("vestibular/angular_velocity"));
    world.reset(1, block);
    CHECK(told[0] == 1 && told[1] == 0 && told[2] == 3);
    for (int i = 0; i < 3; ++i) world.step({}, block);
    CHECK(told[0] == 1 && told[1] == 3.0 * world.frame_skip());
    CHECK(told[3] == world.get_values(MIMO_BODY_POSITION, {world.find(MIMO_BODY, "head")})[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(balance[axis] == turning[axis]);
    const mimo::Env clone = world.clone();
    CHECK(living == 2);
  }
  CHECK(living == 0);
}

// Each failure names the function, and leaves the world as it says.
void check_throws(In place, const char* function, bool number) {
  const std::string start = std::string("the sense \"nose\"'s function ") + function + " returned -14 (MIMO_E_TASK): ";
  const std::string message = start + (number ? "threw what is no std::exception" : "threw an exception: no nose");
  const mimo::Scene scene = scene_with_nose();
  throws_a_number = number;
  throws = place == In::kConstructor ? place : In::kNowhere;
  mimo_env* raw = nullptr;
  if (place == In::kConstructor) {
    CHECK_FAILS(MIMO_E_TASK, message.c_str(), mimo_env_create(scene.get(), nullptr, &raw));
    CHECK(living == 0);
    throws = In::kNowhere;
    return;
  }
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const mimo::View<const double> told = block.view<double>(world.layout().field("nose/told"));
  world.reset(1, block);
  throws = place;
  if (place == In::kReset) {
    CHECK_FAILS(MIMO_E_TASK, message.c_str(), mimo_env_reset(world.get(), nullptr, block.data(), block.bytes()));
  } else {
    CHECK_FAILS(MIMO_E_TASK, message.c_str(),
                mimo_env_step(world.get(), nullptr, 0, block.data(), block.bytes(), nullptr));
  }
  CHECK(told[0] == 0 && told[2] == 0);
  throws = In::kNowhere;
  world.reset(1, block);
  world.step({}, block);
  CHECK(told[0] == 1 && told[1] == world.frame_skip());
}

}  // namespace

int main() {
  check_calls();
  for (const bool number : {false, true}) {
    check_throws(In::kConstructor, "open", number);
    check_throws(In::kReset, "reset", number);
    check_throws(In::kAdvance, "advance", number);
    check_throws(In::kWrite, "write", number);
  }
  return failures();
}
