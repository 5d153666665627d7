// Sizes, places and masses of a body's parts at an age.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"
#include "growth/who.h"

namespace mimo::growth {

// By which factors lengths and girths of an infant differ from those of the 18-month body.

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

// Density stays: a mass goes with its volume. Throws Status::kUnsupported for a body or a geom of the trunk that is
// none of ours.
Skeleton resized(const Skeleton& base, const Lengths& lengths, const Girths& girths);

// How an infant's mass is spread over its parts.

// Changes masses of a body that has one density per part at all ages, and leaves their sum. Torques and muscles' peak
// forces change along, so that a joint stays as strong over the weight that it carries. Throws
// Status::kInvalidArgument where nothing would be left for the trunk.
void spread_mass(Skeleton& body, double age);

// How thick an infant has to be to weigh what it should.

struct Fit {
  double closure;  // factor on all girths
  Skeleton skeleton;
};

// The base at the size of this growth, by the WHO's model. Throws Status::kInvalidArgument where no closure from 0.85
// to 1.15 gives the mass: no infant is like that.
Fit fit(const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
