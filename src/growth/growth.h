// How old, big and strong an infant is asked to be.
#pragma once

#include <tuple>

namespace mimo::growth {

enum class Sex : int { kMean, kFemale, kMale };

// Who: driven by the growth standards of the WHO, around the 18-month body. Original: the rules of MIMo v2, for those
// who compare.
enum class Model : int { kWho, kOriginal };

constexpr double kOldest = 24;  // months
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

inline bool operator==(const Growth& a, const Growth& b) {
  const auto all = [](const Growth& g) {
    return std::tie(g.age, g.physiological_age, g.sex, g.model, g.z_length, g.z_weight, g.z_head, g.absolute,
                    g.strength_exponent, g.neck_strength, g.birth_tone, g.contracture, g.keep_spacing, g.body, g.eyes,
                    g.delays, g.threshold, g.flicker);
  };
  return all(a) == all(b);
}
inline bool operator!=(const Growth& a, const Growth& b) { return !(a == b); }

// Throws Status::kInvalidArgument for a number that is out of its range, naming it as mimo_growth does.
void check(const Growth& growth);

}  // namespace mimo::growth
