// What a joint carries.
#pragma once

#include <map>
#include <string>

#include "growth/skeleton.h"

namespace mimo::growth {

// Of all that hangs on a joint, where all joints are at 0.
struct Load {
  double moment;  // mass times lever, kg m: its distance from the joint, or where it turns about its centre of mass, as
                  // an eye, its radius of gyration
  double inertia;  // about the joint's axis, kg m^2
};

// Of all joints, by their names.
std::map<std::string, Load> loads(const Skeleton& skeleton);

}  // namespace mimo::growth
