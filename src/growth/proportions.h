// By which factors lengths and girths of an infant differ from those of the 18-month body.
#pragma once

#include "growth/drivers.h"
#include "growth/skeleton.h"

namespace mimo::growth {

struct Lengths {
  double stature;
  double head;
  double trunk;
  double upper_arm;
  double forearm;
  double hand;
  double thigh;
  double shank;
  double sole;          // how high the ankle's body is over the ground
  double foot;          // from heel to toes
  double foot_breadth;  // and thickness
  double leg_closure;   // part of thigh, shank and sole: makes the leg as long as the stature says
};

struct Girths {
  double chest;
  double waist;
  double hip;
  double upper_arm;
  double forearm;
  double hand;
  double thigh;
  double calf;
  double ankle;
  double shoulder;  // distance of the shoulders: a bone's, which closure leaves alone
};

// `stretch` is a factor on all lengths but the head's.
Lengths lengths(const Skeleton& base, const Drivers& drivers, double age, double stretch);

// `closure` is a factor on all girths.
Girths girths(const Drivers& drivers, double closure);

// How high the frame of a foot is over the ground, m.
double sole_height(const Skeleton& base);

// Share of the stature that is above the hip joints, as measured: sitting height over length.
double sitting_share(double age);

}  // namespace mimo::growth
