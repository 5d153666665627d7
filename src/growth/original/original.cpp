#include "growth/original/original.h"

#include <array>

#include "base/functions.h"
#include "base/numbers.h"
#include "growth/joints.h"
#include "growth/mechanics.h"

namespace mimo::growth::original {
namespace {

enum class Kind { kLength, kCircumference, kDiameter };

struct Fit {
  double a, b, c;  // a ln(age + b) + c: cm, of diameters mm
  Kind kind;
  double at_18;  // cm
};

// In the order of Measure.
constexpr std::array<Fit, 18> kFits = {{
    {1.410778262746433, 0.784476040564327, 9.469892608634597, Kind::kCircumference, 0},
    {2.156721075077345, 0.7477700715477089, 12.56705648713634, Kind::kCircumference, 0},
    {6.649244197461142, 10.6720986083011, -1.116669546093675, Kind::kLength, 20.7},
    {3.137812149969795, 28.23615171291599, -6.896841220624604, Kind::kLength, 5.0},
    {6.915336579236893, 21.51361407512981, -13.15973000979885, Kind::kLength, 11.9},
    {1.04254806345378, 0.1000000000000008, 11.80047042051853, Kind::kCircumference, 14.5},
    {0.5576097173905573, 2.759629199815948, 3.011226156774235, Kind::kLength, 4.6},
    {1.807893920763198, 4.065326075899756, 3.860250062857791, Kind::kLength, 9.3},
    {3.422233376936088, 0.4314657418774473, 37.31165274139079, Kind::kCircumference, 46.8},
    {1.434176004638728, 0.1049941845847629, 12.98985873301058, Kind::kLength, 17.1},
    {18.77345106119117, 36.83828214163621, -52.96276785331138, Kind::kLength, 21.6},
    {0.6155603275345952, 1.638288223820883, 3.614353350006816, Kind::kLength, 5.5},
    {7.152278614284938, 9.10593915972378, 1.40667810434768, Kind::kCircumference, 24.4},
    {1.031915880660834, 1.980374141411991, 6.046550226166198, Kind::kDiameter, 0},
    {2122.390817132411, 5009.376435062313, -18066.61768598016, Kind::kLength, 21.3},
    {6.504570636345758, 15.34149458405424, -6.973972371838398, Kind::kLength, 15.4},
    {2.055735766605816, 5.821313071039758, 4.696608780552676, Kind::kDiameter, 0},
    {1.112254691444478, 0.1, 11.76005553240292, Kind::kCircumference, 14.7},
}};

const Fit& fit(Measure measure) { return kFits[static_cast<std::size_t>(measure)]; }

double halved(double value, Kind kind) {
  switch (kind) {
    case Kind::kLength: return value / 200;
    case Kind::kCircumference: return value / (200 * kPi);
    case Kind::kDiameter: break;
  }
  return value / 2000;
}

}  // namespace

double half(Measure measure, double age) {
  const Fit& it = fit(measure);
  return halved(it.a * fixed::log(age + it.b) + it.c, it.kind);
}

double half_at_18(Measure measure) { return halved(fit(measure).at_18, fit(measure).kind); }

double ratio(Measure measure, double age) { return half(measure, age) / half_at_18(measure); }

double hand_thickness(double age) {
  return (half(Measure::kHandLength, age) + half(Measure::kHandBreadth, age)) /
         (half_at_18(Measure::kHandLength) + half_at_18(Measure::kHandBreadth));
}

}  // namespace mimo::growth::original

namespace mimo::growth {
namespace {

void grow_side(const Parts& parts, const original::Side& side, double age) {
  grow_arm(parts, side, age);
  if (parts.has_bone(side.prefix + "fingers")) {
    grow_mitten_hand(parts, side, age);
  } else {
    grow_fingered_hand(parts, side, age);
  }
  grow_leg(parts, side, age);
}

double volume_ratio(const Skeleton& body, const Skeleton& base, const std::string& name) {
  return volume(geom(body, name)) / volume(geom(base, name));
}

void set_masses(Skeleton& body, const Skeleton& base) {
  for (Bone& bone : body.bones) {
    for (Geom& geom : bone.geoms) geom.mass *= volume_ratio(body, base, geom.name);
  }
}

void set_gears(Skeleton& body, const Skeleton& base) {
  for (Motor& motor : body.motors) motor.gear *= volume_ratio(body, base, muscle_geom(base, motor));
}

}  // namespace

Skeleton grown_as_original(const Skeleton& base, double age) {
  Skeleton body = base;
  const Parts parts(body);
  original::grow_trunk(parts, age);
  original::grow_head(parts, age);
  grow_side(parts, {"left_", 1}, age);
  grow_side(parts, {"right_", -1}, age);
  set_masses(body, base);
  set_gears(body, base);
  return body;
}

}  // namespace mimo::growth
