#include "growth/masses.h"

#include <map>
#include <string>

#include "base/fail.h"
#include "growth/curve.h"
#include "growth/load.h"
#include "growth/parts.h"
#include "growth/segments.h"

namespace mimo::growth {
namespace {

// A part's mass over its volume's at the density of 18 months, by months.

// A head of a quarter of the mass at birth (textbooks; a ball has neither neck nor jaw), which fades into the 18-month
// body's sixth.
double head(double age) {
  constexpr Curve kFactor({0, 1, 2, 3, 6, 9, 12, 15, 18, 24}, {1.226, 1.235, 1.24, 1.24, 1.2, 1.13, 1.07, 1.025, 1, 1});
  return kFactor(age);
}

// Thighs and feet of Sun and Jensen (1994) up to half a year. Later they are held back: no part gets lighter, and the
// 18-month body has lighter ones than their infants of 15 months. Thighs of a year lie between theirs and those of
// Schneider and Zernicke (1992), who disagree by 30 %. Shanks agree with them by volume.
double thigh(double age) {
  constexpr Curve kFactor({0, 3, 6, 9, 12, 15, 18, 24}, {1, 1, 1.03, 1.08, 1.11, 1.06, 1, 1});
  return kFactor(age);
}

double foot(double age) {
  constexpr Curve kFactor({0, 1, 3, 6, 9, 12, 15, 18, 24}, {1.9, 1.72, 1.555, 1.45, 1.32, 1.19, 1.08, 1, 1});
  return kFactor(age);
}

// How a trunk's mass is spread was not found measured. Estimated, so that the whole body's centre of mass falls with
// age, as a share of the stature: the chest's factor, and the hip's over the belly's. The belly closes the sum.
double chest(double age) {
  constexpr Curve kFactor({0, 1, 2, 3, 6, 9, 12, 15, 18, 21, 24},
                          {0.935, 0.968, 1.057, 1.083, 1.085, 1.108, 1.095, 1.048, 1, 0.959, 0.923});
  return kFactor(age);
}

double hip_over_belly(double age) {
  constexpr Curve kRatio({0, 0.5, 1, 1.5, 2, 3, 4.5, 6, 7.5, 9, 10.5, 12, 13.5, 15, 16.5, 18, 21, 24},
                         {1.216, 1.218, 1.158, 1.079, 1.062, 1.08, 0.949, 0.837, 0.858, 0.845, 0.771, 0.723, 0.718,
                          0.744, 0.894, 1, 1.192, 1.372});
  return kRatio(age);
}

bool is_lower_trunk(const Bone& bone) { return bone.name == "hip" || bone.name == "lower_body"; }

class Spread {
 public:
  Spread(const Skeleton& body, double age)
      : head_(head(age)), chest_(chest(age)), thigh_(thigh(age)), foot_(foot(age)), hip_(hip_over_belly(age)) {
    double left = 0, weighed = 0;  // of the lower trunk: what it will weigh, and what that is over its factor
    for (const Bone& bone : body.bones) {
      for (const Geom& geom : bone.geoms) {
        left += is_lower_trunk(bone) ? geom.mass : (1 - factor(bone)) * geom.mass;
        weighed += is_lower_trunk(bone) ? factor(bone) * geom.mass : 0;
      }
    }
    require(left > 0, "no infant has a head of {:.2f} kg and weighs {:.2f} kg: z_head and z_weight do not go together",
            head_ * geom(body, "head").mass, total_mass(body));
    belly_ = left / weighed;
  }

  double factor(const Bone& bone) const {
    if (is_lower_trunk(bone)) return belly_ * (bone.name == "hip" ? hip_ : 1);
    switch (segment_of(bone.name)) {
      case Segment::kHead: return bone.name == "head" ? head_ : 1;
      case Segment::kTrunk: return chest_;
      case Segment::kThigh: return thigh_;
      case Segment::kFoot: return foot_;
      default: return 1;
    }
  }

 private:
  double head_, chest_, thigh_, foot_, hip_;
  double belly_ = 1;
};

}  // namespace

void spread_mass(Skeleton& body, double age) {
  const std::map<std::string, Load> was = loads(body);
  const Spread spread(body, age);
  for (Bone& bone : body.bones) {
    const double factor = spread.factor(bone);
    for (Geom& geom : bone.geoms) geom.mass *= factor;
  }
  const std::map<std::string, Load> is = loads(body);
  for (Motor& motor : body.motors) {
    const double heavier = is.at(motor.joint).moment / was.at(motor.joint).moment;
    motor.gear *= heavier;
    motor.muscle[1] *= heavier;
    motor.muscle[2] *= heavier;
  }
}

}  // namespace mimo::growth
