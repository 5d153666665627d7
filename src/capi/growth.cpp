#include "growth/growth.h"

#include <cmath>

#include "capi/calls.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "growth/maturity.h"
#include "growth/who.h"

namespace mimo::capi {
namespace {

mimo_growth default_growth() {
  const growth::Growth ours;
  mimo_growth growth{};
  growth.struct_size = sizeof growth;
  growth.sex = static_cast<std::int32_t>(ours.sex);
  growth.model = static_cast<std::int32_t>(ours.model);
  growth.age = ours.age;
  growth.physiological_age = ours.physiological_age;
  growth.strength_exponent = ours.strength_exponent;
  growth.neck_strength = ours.neck_strength;
  growth.birth_tone = ours.birth_tone;
  growth.contracture = ours.contracture;
  growth.maturity = MIMO_MATURITY_BODY;
  return growth;
}

void take_percentile(const mimo_growth& config, growth::Growth& growth) {
  if (config.percentile == 0) return;
  require(config.z_length == 0 && config.z_weight == 0 && config.z_head == 0,
          "percentile is {} and z_length, z_weight, z_head are {}, {}, {}; expected one or the other",
          config.percentile, config.z_length, config.z_weight, config.z_head);
  growth.z_length = growth.z_weight = growth.z_head = growth::z_of_percentile(config.percentile);
}

std::uint32_t maturity_bits(const mimo_growth& config) {
  constexpr std::uint32_t kOptions = MIMO_MATURITY_THRESHOLD | MIMO_MATURITY_FLICKER;
  constexpr std::uint32_t kKnown = MIMO_MATURITY_BODY | MIMO_MATURITY_EYES | MIMO_MATURITY_DELAYS;
  check_bits(config.maturity, kKnown | kOptions | MIMO_MATURITY_ALL, "maturity");
  if (config.maturity == 0) return MIMO_MATURITY_BODY;
  const std::uint32_t options = config.maturity & kOptions;
  const std::uint32_t bits = resolve_bits(config.maturity & ~kOptions, MIMO_MATURITY_ALL, kKnown, "maturity");
  require(options == 0 || (bits & MIMO_MATURITY_EYES) != 0,
          "maturity is {:#x}: MIMO_MATURITY_THRESHOLD and MIMO_MATURITY_FLICKER need MIMO_MATURITY_EYES",
          config.maturity);
  return bits | options;
}

}  // namespace

growth::Growth growth_from(const mimo_growth& given, const char* argument) {
  const mimo_growth config = read_struct(&given, argument);
  check_choice(config.sex, MIMO_SEX_MEAN, MIMO_SEX_MALE, "sex");
  check_choice(config.model, MIMO_GROWTH_WHO, MIMO_GROWTH_ORIGINAL, "model");
  check_flag(config.matures_apart, "matures_apart");
  check_flag(config.absolute, "absolute");
  check_flag(config.keep_spacing, "keep_spacing");
  check_reserved(config.reserved, "reserved");
  const std::uint32_t mature = maturity_bits(config);
  growth::Growth growth;
  growth.age = config.age;
  growth.physiological_age = config.matures_apart != 0 ? config.physiological_age : config.age;
  growth.sex = static_cast<growth::Sex>(config.sex);
  growth.model = static_cast<growth::Model>(config.model);
  growth.z_length = config.z_length;
  growth.z_weight = config.z_weight;
  growth.z_head = config.z_head;
  growth.absolute = config.absolute != 0;
  growth.strength_exponent = config.strength_exponent;
  growth.neck_strength = config.neck_strength;
  growth.birth_tone = config.birth_tone;
  growth.contracture = config.contracture;
  growth.keep_spacing = config.keep_spacing != 0;
  growth.body = (mature & MIMO_MATURITY_BODY) != 0;
  growth.eyes = (mature & MIMO_MATURITY_EYES) != 0;
  growth.delays = (mature & MIMO_MATURITY_DELAYS) != 0;
  growth.threshold = (mature & MIMO_MATURITY_THRESHOLD) != 0;
  growth.flicker = (mature & MIMO_MATURITY_FLICKER) != 0;
  take_percentile(config, growth);
  growth::check(growth);
  return growth;
}

blueprint::Ages ages_from(const mimo_growth* const* growth, std::size_t count, const char* argument) {
  blueprint::Ages ages;
  for (const mimo_growth* one : array(growth, count, argument)) {
    ages.emplace_back();
    if (one != nullptr) ages.back() = growth_from(*one, argument);
  }
  return ages;
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_growth_init(mimo_growth* growth, size_t size) noexcept {
  return guard([&] { write_struct(growth, size, default_growth(), "growth"); });
}

}  // extern "C"

namespace mimo::capi {
namespace {

mimo_maturity perfect() {
  mimo_maturity maturity{};
  maturity.struct_size = sizeof maturity;
  maturity.peak_contrast = 2;
  maturity.chroma = 1;
  return maturity;
}

mimo_maturity maturity_of(double age) {
  in_range(age, ranges::growth::age, " months");
  mimo_maturity maturity = perfect();
  const growth::EyeMaturity eyes = growth::eye_maturity_at(age);
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

observation::Eyesight eyes_from(const mimo_maturity& config) {
  check_flag(config.contrast_threshold, "contrast_threshold");
  observation::Eyesight eyes;
  eyes.acuity = in_range_or_zero(config.acuity, ranges::maturity::acuity, " cycles per degree", "none");
  eyes.peak_contrast = in_range(config.peak_contrast, ranges::maturity::peak_contrast);
  eyes.chroma = in_range(config.chroma, ranges::maturity::chroma);
  eyes.flicker = in_range_or_zero(config.flicker, ranges::maturity::flicker, " Hz", "none");
  eyes.threshold = config.contrast_threshold != 0;
  return eyes;
}

growth::Conduction nerves_from(const mimo_maturity& config) {
  growth::Conduction nerves;
  nerves.speed = in_range_or_zero(config.conduction_speed, ranges::maturity::conduction_speed, " m/s", "none");
  nerves.sensory = in_range(config.sensory_delay, ranges::maturity::sensory_delay, " seconds");
  nerves.motor = in_range(config.motor_delay, ranges::maturity::motor_delay, " seconds");
  nerves.vision = in_range(config.vision_delay, ranges::maturity::vision_delay, " seconds");
  nerves.vestibular = in_range(config.vestibular_delay, ranges::maturity::vestibular_delay, " seconds");
  nerves.hearing = in_range(config.hearing_delay, ranges::maturity::hearing_delay, " seconds");
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
    in_range(seconds, ranges::maturity::sensory_delay.of("seconds"));
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      note(edit, {{"call", "set_sensory_delay"}, {"agent", agent}, {"body", body}, {"seconds", seconds}});
      if (body == nullptr) return edit.agents.set_sensory_delay(agent, seconds);
      edit.agents.set_sensory_delay(agent, body, seconds, edit.scene);
    });
  });
}

}  // extern "C"
