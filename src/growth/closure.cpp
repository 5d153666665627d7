#include "growth/closure.h"

#include "base/fail.h"
#include "growth/drivers.h"
#include "growth/kinematics.h"
#include "growth/parts.h"
#include "growth/proportions.h"
#include "growth/sizes.h"

namespace mimo::growth {
namespace {

constexpr double kLeast = 0.85, kMost = 1.15;
constexpr double kCm = 0.01;

// Factor that makes the base as long as the WHO's infants of 18 months.
double stretch_to_who(const Skeleton& base) { return length_at_18_months() * kCm / stature(base); }

class Fitter {
 public:
  Fitter(const Skeleton& base, const Growth& growth)
      : base_(base),
        drivers_(drivers(growth)),
        lengths_(lengths(base, drivers_, growth.age, growth.absolute ? stretch_to_who(base) : 1)),
        mass_(growth.absolute ? drivers_.weight : total_mass(base) * drivers_.mass) {}

  Fit fit() const {
    if (mass_of(1) == mass_) return {1, body(1)};
    double low = kLeast, high = kMost;
    require(mass_of(low) <= mass_ && mass_of(high) >= mass_,
            "no infant of {:.1f} cm with a head of {:.1f} cm weighs {:.2f} kg: z_length, z_weight and z_head do not go "
            "together; expected {:.2f} to {:.2f} kg",
            drivers_.length, drivers_.head, drivers_.weight, weight_of(low), weight_of(high));
    constexpr int kHalvings = 55;  // down to the last bit
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (mass_of(middle) < mass_ ? low : high) = middle;
    }
    return checked({high, body(high)});
  }

 private:
  // A capsule that gets thicker than long has no room between its round ends.
  Fit checked(Fit fit) const {
    for (const Bone& bone : fit.skeleton.bones) {
      for (const Geom& geom : bone.geoms) {
        require(geom.shape != Shape::kCapsule || geom.size[1] > 0,
                "no infant of {:.1f} cm weighs {:.2f} kg: z_length and z_weight do not go together, the capsule of its "
                "{} would be thicker than long",
                drivers_.length, drivers_.weight, bone.name);
      }
    }
    return fit;
  }

  Skeleton body(double closure) const { return resized(base_, lengths_, girths(drivers_, closure)); }
  double mass_of(double closure) const { return total_mass(body(closure)); }
  // As the WHO's scales would show it.
  double weight_of(double closure) const { return drivers_.weight * mass_of(closure) / mass_; }

  const Skeleton& base_;
  Drivers drivers_;
  Lengths lengths_;
  double mass_;
};

}  // namespace

Fit fit(const Skeleton& base, const Growth& growth) { return Fitter(base, growth).fit(); }

}  // namespace mimo::growth
