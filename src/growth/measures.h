// What a body measures.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// From the soles to the top of the head, standing straight: where all joints are at 0. In m.
double stature(const Skeleton& skeleton);

struct Measures {
  // What the WHO's infants of that age measure: cm, kg, cm.
  double length;
  double weight;
  double head_circumference;
  // Over those of the 18-month body: length, weight over length, and head.
  double l;
  double w;
  double h;
  double closure;  // factor on all girths that gives the body its mass; 1 for the original's model
  // Of the body.
  double stature;  // m
  double mass;     // kg
};

// Of what `grown` makes, and throws what it throws.
Measures measures(const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
