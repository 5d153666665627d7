// How old, big and strong an infant is asked to be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "growth/skeleton.h"
#include "mimo/experimental/maturity.h"

namespace mimo::growth {

enum class Sex : std::int32_t { kMean = MIMO_SEX_MEAN, kFemale = MIMO_SEX_FEMALE, kMale = MIMO_SEX_MALE };

// Who: driven by the growth standards of the WHO, around the 18-month body. Original: the rules of MIMo v2, for those
// who compare.
enum class Model : std::int32_t { kWho = MIMO_GROWTH_WHO, kOriginal = MIMO_GROWTH_ORIGINAL };

constexpr double kBaseAge = 18;  // months, of the built-in bodies
constexpr double kMostZ = 3;

struct Growth {
  double age = 18;                // months, of size and mass
  double physiological_age = 18;  // months, of strength, range of motion and tone
  Sex sex = Sex::kMean;
  Model model = Model::kWho;
  // Standard deviations from the median of its age and sex.
  double z_length = 0;
  double z_weight = 0;
  double z_head = 0;
  bool absolute = false;  // length and weight are the WHO's; else they are in its proportion to the 18-month body
  double strength_exponent = 1.7;  // strength of a muscle's cross-section over the length of infants of its age
  double neck_strength = 1;        // factor
  double birth_tone = 1.5;         // stiffness of a newborn's joints, as a factor
  double contracture = 1;          // share of the newborn's lack of extension
  bool keep_spacing = false;       // touch sensors are as far apart as at 18 months; else there are as many
  // What of it is as old: its body, its eyes, its nerves.
  bool body = true;
  bool eyes = false;
  bool delays = false;
  // Of eyes that are as old: contrasts that they cannot see, and changes that are too fast for them.
  bool threshold = false;
  bool flicker = false;
};

// Visits all members with their names. Does not compile where one is missing here.
template <typename Growth, typename Visit>
constexpr void for_each_member(Growth& growth, Visit&& visit) {
  auto& [age, physiological_age, sex, model, z_length, z_weight, z_head, absolute, strength_exponent, neck_strength,
         birth_tone, contracture, keep_spacing, body, eyes, delays, threshold, flicker] = growth;
  visit("age", age);
  visit("physiological_age", physiological_age);
  visit("sex", sex);
  visit("model", model);
  visit("z_length", z_length);
  visit("z_weight", z_weight);
  visit("z_head", z_head);
  visit("absolute", absolute);
  visit("strength_exponent", strength_exponent);
  visit("neck_strength", neck_strength);
  visit("birth_tone", birth_tone);
  visit("contracture", contracture);
  visit("keep_spacing", keep_spacing);
  visit("body", body);
  visit("eyes", eyes);
  visit("delays", delays);
  visit("threshold", threshold);
  visit("flicker", flicker);
}

constexpr std::size_t count_members() {
  std::size_t count = 0;
  const Growth any;
  for_each_member(any, [&](const char* /*name*/, const auto& /*member*/) { ++count; });
  return count;
}
constexpr std::size_t kMembers = count_members();

// All members as numbers, in the order of their visit.
inline std::array<double, kMembers> numbers_of(const Growth& growth) {
  std::array<double, kMembers> numbers{};
  double* to = numbers.data();
  for_each_member(growth, [&](const char* /*name*/, const auto& member) { *to++ = static_cast<double>(member); });
  return numbers;
}

inline bool operator==(const Growth& a, const Growth& b) { return numbers_of(a) == numbers_of(b); }
inline bool operator!=(const Growth& a, const Growth& b) { return !(a == b); }

// Throws Status::kInvalidArgument for a number that is out of its range, naming it as mimo_growth does.
void check(const Growth& growth);

// Makes the body of 18 months one of another age.

// By the WHO's model the body at 18 months, mean of the sexes, median in everything, is the base itself, to the last
// bit. Nothing but numbers differs: bones, geoms, joints, marks and motors stay in their order. Throws
// Status::kInvalidArgument for a combination that no infant can have, and Status::kUnsupported for a body that is none
// of ours.
Skeleton grown(const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
