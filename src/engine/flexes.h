// MuJoCo 4's flexes: things of many bodies that bend, such as cloth and ropes. Older models have none.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <vector>

namespace mimo::engine {

int flex_count(const mjModel& model);

// Flexes that move with nothing else than these bodies.
std::vector<int> flexes_on(const mjModel& model, const std::vector<int>& bodies);

// The flexes that are a contact's sides: -1 for geoms.
std::array<int, 2> flexes_of(const mjContact& contact);

// The body of a contact's side that is a flex: the body of the vertex next to the contact, or of the node where nodes
// move the vertices; -1 where the contact names no such thing.
int body_of_flex(const mjModel& model, const mjData& data, const mjContact& contact, std::size_t side);

// Throws Status::kUnsupported for a model with flexes whose contacts press with forces that no contact tells.
void require_told_forces(const mjModel& model);

}  // namespace mimo::engine
