// How long nerves take at an age: the speed of their fibres, and what the way through the brain adds.
#pragma once

namespace mimo::growth {

struct Conduction {
  double speed = 0;       // of large fibres, sensory and motor, m/s; 0: the way takes no time
  double sensory = 0;     // from the brain stem to the cortex, s
  double motor = 0;       // from the cortex to the brain stem, s
  double vision = 0;      // from the eye to the first signal of the cortex, s
  double vestibular = 0;  // from the inner ear to the brain stem, s
  double hearing = 0;     // from the ear to the cortex, s

  bool any() const {
    return speed != 0 || sensory != 0 || motor != 0 || vision != 0 || vestibular != 0 || hearing != 0;
  }
  // What the way of a nerve of this length takes, s.
  double along(double metres) const { return speed > 0 ? metres / speed : 0; }
};

// At an age in months, 0 to 24.
Conduction conduction_at(double age);

}  // namespace mimo::growth
