// Force curves of the original MIMo's muscle model. Forces are shares of a muscle's peak force; length 1 is where it
// pulls best, velocity -1 is its fastest shortening.
#pragma once

namespace mimo::actuation::curves {

// Lengths at and beyond which activation gives no force.
constexpr double kShortest = 0.5, kLongest = 1.6;
// Factor of the active force of a muscle that is stretched fast.
constexpr double kStretched = 1.2;
// Scale of the passive force.
constexpr double kPassive = 1.3;
// Lengths at the two ends of the joint's range of motion.
constexpr double kAtShortEnd = 0.75, kAtLongEnd = 1.05;

// Active force over length.
double force_length(double length);
// Factor of the active force over velocity; a positive one stretches.
double force_velocity(double velocity);
// Force of a stretched muscle without activation.
double passive_force(double length);

}  // namespace mimo::actuation::curves
