// What belongs to one agent in a compiled model, mostly an infant; looked up by name once.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/span.h"
#include "engine/model.h"
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

typedef struct mjModel_ mjModel;

namespace mimo::body {

// The muscles of a joint that a motor turns: how hard they pull, and over which angles.

struct Body;
struct Joint;

// The range of a motor's force, before its gear; what has none pulls as hard as its controls may tell it, 0 and 0 where
// they may be anything.
std::pair<double, double> forces_of(const mjModel& model, int motor);

// The angles between which the muscles of one of its joints go from their shortest to their longest: the joint's range.
// A joint that goes less far, or further, at the body's age than at 18 months keeps the width of 18 months, around its
// middle: what holds a young joint back does not move the muscles' ends, which are their levers, and muscles fit the
// angles at which they work. Throws Status::kModel for numbers in the document that do not fit the body.
std::pair<double, double> muscle_range(const mjModel& model, const Body& body, const Joint& joint);

// The pose that a document stores, in which its model starts.

// Writes it into qpos: the numbers "mimo:root" for the root of an infant (body mimo_location), tuples "mimo:pose" for
// hinges and slides. Each may have the prefix of an infant or object, "anna/mimo:pose". What is not stored stays as it
// is. Throws Status::kModel for a root without a free joint and for other joints.
void read_stored_pose(const mjModel& model, Span<double> qpos);

// How far it is from each part of an infant to its brain stem, along the limbs.

// Metres by body of the model, 0 for those that are no part of it and where the agent has no head: from the middle of
// the part through the joints on its way to the base of the neck, and on to the middle of the head, times a factor for
// each of arm, leg, spine and head. It depends on no pose.
std::vector<double> nerve_lengths(const mjModel& model, const Body& body);
// The same for one body, of whatever infant it is a part.
double nerve_length(const mjModel& model, int body);

}  // namespace mimo::body
