// What a body stands on, and what it is stuck in.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <vector>

#include "engine/contacts.h"

namespace mimo::engine {

// Half the extent of a geom along the world's z axis.
double half_height(const mjModel& model, const mjData& data, int geom);

// Geoms of a body that hangs on the world, and of all that hangs on it.
std::vector<int> geoms_of_tree(const mjModel& model, int root);

// Heights at which a vertical line meets geoms that stand still and that can touch one of those given.
std::vector<double> heights_at(const mjModel& model, const mjData& data, const std::vector<int>& geoms, double x,
                               double y);

// How deep the two sides of a contact are in each other there, m, below 0 where they are apart. MuJoCo 2.2 reports half
// of it where a face of a box touches another box, and all of it where edges cross.
double overlap_of(const mjModel& model, const mjData& data, const Meeting& met);

struct Overlap {
  double depth = 0;  // m
  Meeting met{};
  std::size_t own = 0;  // its side
};

// Where a body that hangs on the world, with all that hangs on it, is deepest inside something else; from the contacts
// that the data holds.
Overlap deepest_overlap(const mjModel& model, const mjData& data, int root);

}  // namespace mimo::engine
