// What belongs to one agent in a compiled model, mostly an infant; looked up by name once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/physics.h"

namespace mimo::body {

struct Joint {
  int id = 0;
  int qpos = 0;              // address in qpos
  int dof = 0;               // address in qvel
  double low = 0, high = 0;  // range, rad (m for a slide); infinite where it is not limited
};

// A motor, the joint that it turns, and the lock that can hold that joint (an equality; -1 if there is none).
struct Motor {
  int id = 0;
  Joint joint;
  int lock = -1;
};

// Consecutive values of one MuJoCo sensor.
struct Sensor {
  int id = 0;
  int address = 0;
  int dimension = 0;
};

struct Body {
  bool infant = true;           // else a part of the model that the library knows nothing more about
  std::string prefix;           // of all its names, "" or "anna/"
  int root = 0;                 // body mimo_location
  int head = -1;                // -1: none that we know of
  std::vector<int> bodies;      // the whole subtree, in model order
  std::vector<Joint> joints;    // robot:*, in model order; hinges, and slides of what is no infant
  std::vector<int> actuators;   // act:*, in model order
  std::vector<Sensor> torques;  // proprio:*, three axes each
  std::optional<Sensor> accelerometer;
  std::optional<Sensor> gyroscope;
  int eye_left = -1, eye_right = -1;  // cameras
  // How large it is against the body of 18 months, which tasks are made for: its height, and its arms' length.
  double stature = 1, arm = 1;

  // Whether a body of the model is part of it.
  bool has(int body) const;
};

// The name of one of its bodies without its own prefix: "left_hand".
std::string short_name(const mjModel& model, const Body& body, int id);

// A hinge or a slide.
Joint joint(const mjModel& model, int id);
Sensor sensor(const mjModel& model, int id);

// A body and all bodies below it, in model order.
std::vector<int> subtree(const mjModel& model, int root);

// Those of its bodies that have a skin, in model order: what the scene's document names in "mimo:touch"; where it says
// nothing, all that have a surface.
std::vector<int> bodies_with_skin(const mjModel& model, const Body& body);

// The right hand's fingers: one body of a mitten hand, all bones of a hand with five. Throws Status::kNotFound for an
// infant without a right hand.
std::vector<int> right_fingers(const mjModel& model, const Body& body);

// Throws Status::kNotFound when the model has no such infant.
Body find_body(const mjModel& model, const std::string& prefix);

// Any body of a model with all below it: every hinge and slide, actuator and torque sensor of it. The world stands for
// all that is in it, but is not part of that itself. Throws Status::kNotFound.
Body find_part(const mjModel& model, const std::string& root);

// Its motors in the order of `actuators`.
std::vector<Motor> motors(const mjModel& model, const Body& body);

// Of the quantities of joints, of which there may be hinges, slides, or both.
struct Units {
  const char *position, *velocity, *force;
};
Units units_of(const mjModel& model, const std::vector<Joint>& joints);

// The body whose joint an actuator turns; 0, the world, for one that turns none.
int moved_by(const mjModel& model, int actuator);

double mass(const mjModel& model, const Body& body);

// How far the body's geoms reach down and up at the poses that data holds, m; 0 and 0 without geoms.
struct Extent {
  double low, high;
};
Extent extent(const mjModel& model, const mjData& data, const Body& body);
// Their distance.
double height(const mjModel& model, const mjData& data, const Body& body);

}  // namespace mimo::body
