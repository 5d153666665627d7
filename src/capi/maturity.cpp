// Eyes and nerves as old as the infant.
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "growth/eyesight.h"
#include "growth/growth.h"

namespace mimo::capi {
namespace {

constexpr double kMostDelay = 2;  // seconds

mimo_maturity perfect() {
  mimo_maturity maturity{};
  maturity.struct_size = sizeof maturity;
  maturity.peak_contrast = 2;
  maturity.chroma = 1;
  return maturity;
}

mimo_maturity maturity_of(double age) {
  require(age >= 0 && age <= growth::kOldest, "age is {}, expected 0 to {} months", age, growth::kOldest);
  mimo_maturity maturity = perfect();
  const growth::Eyesight eyes = growth::eyesight_at(age);
  maturity.acuity = eyes.acuity;
  maturity.peak_contrast = eyes.peak_contrast;
  maturity.chroma = eyes.chroma;
  const growth::Conduction nerves = growth::conduction_at(age);
  maturity.conduction_speed = nerves.speed;
  maturity.sensory_delay = nerves.sensory;
  maturity.motor_delay = nerves.motor;
  maturity.vision_delay = nerves.vision;
  maturity.vestibular_delay = nerves.vestibular;
  maturity.hearing_delay = nerves.hearing;
  return maturity;
}

double within(double value, double low, double high, const char* name, const char* unit) {
  require(value >= low && value <= high, "{} is {}, expected {} to {}{}", name, value, low, high, unit);  // or NaN
  return value;
}

// 0 is off.
double off_or_within(double value, double low, double high, const char* name, const char* unit) {
  require(value == 0 || (value >= low && value <= high), "{} is {}, expected {} to {}{}, or 0 for none", name, value,
          low, high, unit);
  return value;
}

observation::Eyesight eyes_from(const mimo_maturity& config) {
  check_flag(config.contrast_threshold, "contrast_threshold");
  observation::Eyesight eyes;
  eyes.acuity = off_or_within(config.acuity, 0.05, 1000, "acuity", " cycles per degree");
  eyes.peak_contrast = within(config.peak_contrast, 1.01, 1000, "peak_contrast", "");
  eyes.chroma = within(config.chroma, 0, 1, "chroma", "");
  eyes.flicker = off_or_within(config.flicker, 0.01, 1000, "flicker", " Hz");
  eyes.threshold = config.contrast_threshold != 0;
  return eyes;
}

growth::Conduction nerves_from(const mimo_maturity& config) {
  const auto delay = [](double seconds, const char* name) { return within(seconds, 0, kMostDelay, name, " seconds"); };
  growth::Conduction nerves;
  nerves.speed = off_or_within(config.conduction_speed, 0.1, 200, "conduction_speed", " m/s");
  nerves.sensory = delay(config.sensory_delay, "sensory_delay");
  nerves.motor = delay(config.motor_delay, "motor_delay");
  nerves.vision = delay(config.vision_delay, "vision_delay");
  nerves.vestibular = delay(config.vestibular_delay, "vestibular_delay");
  nerves.hearing = delay(config.hearing_delay, "hearing_delay");
  return nerves;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_maturity_init(mimo_maturity* maturity, size_t size) noexcept {
  return guard([&] { write_struct(maturity, size, perfect(), "maturity"); });
}

mimo_status mimo_maturity_at(double age, mimo_maturity* maturity, size_t size) noexcept {
  return guard([&] { write_struct(maturity, size, maturity_of(age), "maturity"); });
}

mimo_status mimo_scene_set_maturity(mimo_scene* scene, size_t agent, const mimo_maturity* maturity) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    std::optional<env::Maturity> ours;
    Json described = nullptr;
    if (maturity != nullptr) {
      const mimo_maturity config = read_struct(maturity, perfect(), "maturity");
      ours = env::Maturity{eyes_from(config), nerves_from(config)};
      described = json_of(config);
    }
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.agents.set_maturity(agent, ours);
      note(edit, {{"call", "set_maturity"}, {"agent", agent}, {"maturity", described}});
    });
  });
}

mimo_status mimo_scene_set_sensory_delay(mimo_scene* scene, size_t agent, const char* body, double seconds) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    within(seconds, 0, kMostDelay, "seconds", "");
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      note(edit, {{"call", "set_sensory_delay"}, {"agent", agent}, {"body", body}, {"seconds", seconds}});
      if (body == nullptr) return edit.agents.set_sensory_delay(agent, seconds);
      edit.agents.set_sensory_delay(agent, body, seconds, edit.scene);
    });
  });
}

}  // extern "C"
