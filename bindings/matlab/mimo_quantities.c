/* Names of quantities, and of the kinds of things that have them. */
#include "mimo_quantities.h"

#include <string.h>

#define QUANTITY(kind, what, name) \
  { name, MIMO_##kind, MIMO_##kind##_##what, 0 }
#define OF_EACH(kind, what, name, each) \
  { name, MIMO_##kind, MIMO_##kind##_##what, each }
static const quantity quantities[] = {
    QUANTITY(BODY, POSITION, "body_position"),
    QUANTITY(BODY, ORIENTATION, "body_orientation"),
    QUANTITY(BODY, VELOCITY, "body_velocity"),
    QUANTITY(BODY, FORCE, "body_force"),
    QUANTITY(BODY, MASS, "body_mass"),
    QUANTITY(BODY, CENTER_OF_MASS, "body_center_of_mass"),
    QUANTITY(BODY, POSE, "body_pose"),
    QUANTITY(BODY, NERVE_LENGTH, "body_nerve_length"),
    QUANTITY(JOINT, POSITION, "joint_position"),
    QUANTITY(JOINT, VELOCITY, "joint_velocity"),
    QUANTITY(JOINT, FORCE, "joint_force"),
    QUANTITY(JOINT, ACCELERATION, "joint_acceleration"),
    QUANTITY(JOINT, RANGE, "joint_range"),
    QUANTITY(JOINT, DAMPING, "joint_damping"),
    QUANTITY(JOINT, LOCK, "joint_lock"),
    QUANTITY(GEOM, POSITION, "geom_position"),
    QUANTITY(GEOM, ORIENTATION, "geom_orientation"),
    QUANTITY(GEOM, SIZE, "geom_size"),
    QUANTITY(GEOM, POSE, "geom_pose"),
    QUANTITY(GEOM, FRICTION, "geom_friction"),
    QUANTITY(GEOM, COLOR, "geom_color"),
    QUANTITY(SITE, POSITION, "site_position"),
    QUANTITY(SITE, ORIENTATION, "site_orientation"),
    QUANTITY(SITE, POSE, "site_pose"),
    QUANTITY(SITE, VELOCITY, "site_velocity"),
    QUANTITY(CAMERA, POSITION, "camera_position"),
    QUANTITY(CAMERA, ORIENTATION, "camera_orientation"),
    QUANTITY(CAMERA, POSE, "camera_pose"),
    QUANTITY(ACTUATOR, CONTROL, "actuator_control"),
    QUANTITY(ACTUATOR, FORCE, "actuator_force"),
    QUANTITY(ACTUATOR, GEAR, "actuator_gear"),
    QUANTITY(ACTUATOR, FUSIMOTOR_DRIVE, "actuator_fusimotor_drive"),
    QUANTITY(SENSOR, VALUE, "sensor_value"),
    QUANTITY(LIGHT, POSITION, "light_position"),
    QUANTITY(LIGHT, DIRECTION, "light_direction"),
    QUANTITY(LIGHT, COLOR, "light_color"),
    OF_EACH(CONTACT, GEOMS, "contact_geoms", 2),
    OF_EACH(CONTACT, BODIES, "contact_bodies", 2),
    OF_EACH(CONTACT, POSITION, "contact_position", 3),
    OF_EACH(CONTACT, FRAME, "contact_frame", 9),
    OF_EACH(CONTACT, DISTANCE, "contact_distance", 1),
    OF_EACH(CONTACT, FORCE, "contact_force", 3),
    OF_EACH(CONTACT, TORQUE, "contact_torque", 3),
    OF_EACH(STEP_CONTACT, GEOMS, "step_contact_geoms", 2),
    OF_EACH(STEP_CONTACT, BODIES, "step_contact_bodies", 2),
    OF_EACH(STEP_CONTACT, START, "step_contact_start", 1),
    OF_EACH(STEP_CONTACT, END, "step_contact_end", 1),
    OF_EACH(STEP_CONTACT, IMPULSE, "step_contact_impulse", 3),
    OF_EACH(STEP_CONTACT, PEAK_FORCE, "step_contact_peak_force", 3),
    OF_EACH(STEP_CONTACT, PEAK_POSITION, "step_contact_peak_position", 3),
    QUANTITY(AGENT, FACE, "agent_face"),
    QUANTITY(AGENT, GOAL, "agent_goal"),
    QUANTITY(AGENT, ACHIEVED, "agent_achieved"),
    QUANTITY(AGENT, AGE, "agent_age"),
    QUANTITY(AGENT, PHYSIOLOGICAL_AGE, "agent_physiological_age"),
    QUANTITY(WORLD, GRAVITY, "world_gravity"),
    QUANTITY(WARNING, COUNT, "warning_count"),
};

quantity mimo_quantity_of(const mxArray* name) {
  const char* text = mimo_text(name, "quantity");
  const size_t length = strlen(text);
  const int now = length > 4 && strcmp(text + length - 4, "_now") == 0;
  const size_t rest = now ? length - 4 : length;
  quantity found = {"", 0, 0, 0};
  size_t i;
  for (i = 0; i < sizeof quantities / sizeof *quantities; ++i) {
    found = quantities[i];
    if (strlen(found.name) != rest || strncmp(text, found.name, rest) != 0) continue;
    if (now) found.number |= MIMO_NOW;
    return found;
  }
  mexErrMsgIdAndTxt("mimo:NOT_FOUND", "no quantity %s; see help mimo_get", text);
  return found;
}

int32_t mimo_kind_of(const mxArray* name) {
  static const char* kinds[] = {"body",    "joint",        "geom",  "site", "camera", "actuator", "sensor", "light",
                                "contact", "step_contact", "agent", "face", "world",  "warning"}; /* MIMO_BODY is 1 */
  const int32_t most = sizeof kinds / sizeof *kinds;
  const char* asked = mimo_text(name, "kind");
  int32_t i = 0;
  while (i < most && strcmp(kinds[i], asked) != 0) ++i;
  if (i == most) mimo_refuse("kind is \"%s\", expected body, joint, geom, ...; see help mimo_names", asked);
  return i + 1;
}
