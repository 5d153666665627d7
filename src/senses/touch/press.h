// A contact as one of its two bodies feels it.
#pragma once

#include <optional>

#include "engine/contacts.h"
#include "engine/physics.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

enum class Side { kFirst, kSecond };  // of MuJoCo's pair of geoms

struct Press {
  int body, geom;
  int other;            // the body that touches
  int other_geom;       // -1 for a flex
  int other_thing;      // as things.h counts
  Vec3 point;           // on the body's own surface; world, m
  Vec3 normal;          // from this body to the other; world
  Vec3 force;           // on this body; world, N
  double normal_force;  // N
  double friction;      // coefficient of sliding; 0 where the contact has none
  double friction_use;  // share of the friction cone, 0 (no friction) to 1 (about to slip, or slipping)
};

// Force of a contact in its own frame, on the body of the second geom; none if nothing presses.
using ContactForce = std::array<double, 6>;
std::optional<ContactForce> pressing(const mjModel& model, const mjData& data, int contact);

Press press_on(const mjModel& model, const mjData& data, const engine::Meeting& met, const ContactForce& force,
               Side side);

// How the touching surface slides over the body's at the point: velocity without the part along the normal; world, m/s.
Vec3 slip_velocity(const mjModel& model, const mjData& data, const Press& press);

}  // namespace mimo::senses::touch
