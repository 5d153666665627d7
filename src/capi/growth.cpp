#include "capi/growth.h"

#include <cmath>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/structs.h"
#include "growth/percentile.h"

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
