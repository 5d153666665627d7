// How thick an infant has to be to weigh what it should.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

struct Fit {
  double closure;  // factor on all girths
  Skeleton skeleton;
};

// The base at the size of this growth, by the WHO's model. Throws Status::kInvalidArgument where no closure from 0.85
// to 1.15 gives the mass: no infant is like that.
Fit fit(const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
