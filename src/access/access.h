// Named access: reading and writing quantities of many elements at once.
#pragma once

#include "access/quantities.h"

namespace mimo::access {

// `values` has exactly the width. `now`: what follows from positions and velocities is that of the current ones, and
// what a physics step computes cannot be had; else all belongs to the last physics step, reset or update.
void get(const env::World& world, const Quantity& quantity, const Ids& ids, bool now, Span<double> values);
void get(const env::World& world, const Quantity& quantity, const Ids& ids, bool now, Span<float> values);
// From data as they are.
void read(const Source& source, const Quantity& quantity, const Ids& ids, Span<double> values);
// Throws Status::kInvalidArgument for a quantity that physics steps compute.
void require_known_now(const Quantity& quantity);

// Throws Status::kInvalidArgument for a quantity that can only be read.
void require_writable(const Quantity& quantity);
// Throws for what set() would refuse.
void check_settable(const env::World& world, const Quantity& quantity, const Ids& ids, Span<const double> values);
// Checks everything before it writes anything; recomputes poses when something moved.
void set(env::World& world, const Quantity& quantity, const Ids& ids, Span<const double> values);

}  // namespace mimo::access
