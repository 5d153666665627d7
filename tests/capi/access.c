/* Named access: find, read, write, contacts. */
#include "support/capi.h"

static mimo_env* env;

static void check_finding_by_name(void) {
  static const struct {
    int32_t kind;
    size_t count;
    const char* name;
  } known[] = {{MIMO_BODY, 26, "left_hand"},
               {MIMO_JOINT, 50, "robot:left_knee"},
               {MIMO_GEOM, 39, "floor"},
               {MIMO_SITE, 23, "vestibular"},
               {MIMO_CAMERA, 2, "eye_left"},
               {MIMO_ACTUATOR, 44, "act:left_knee"},
               {MIMO_SENSOR, 23, "vestibular_acc"},
               {MIMO_FACE, 7, "anger"},
               {MIMO_WARNING, 9, "not converged"}};
  size_t i, count;
  const char* name;
  int32_t id = -7, body = -7;
  for (i = 0; i < sizeof known / sizeof known[0]; ++i) {
    count = 0;
    name = NULL;
    CHECK_OK(mimo_env_count(env, known[i].kind, &count));
    CHECK(count == known[i].count);
    CHECK_OK(mimo_env_find(env, known[i].kind, known[i].name, &id));
    CHECK_OK(mimo_env_name(env, known[i].kind, id, &name));
    CHECK_TEXT(known[i].name, name);
    id = -7;
    CHECK_FAILS(MIMO_E_NOT_FOUND, "named \"nobody\"; there are: ", mimo_env_find(env, known[i].kind, "nobody", &id));
    CHECK_FAILS(MIMO_E_NOT_FOUND, "named \"\"", mimo_env_find(env, known[i].kind, "", &id));
    CHECK(id == -7);
    name = NULL;
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "id is -1", mimo_env_name(env, known[i].kind, -1, &name));
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "expected a ", mimo_env_name(env, known[i].kind, (int32_t)count, &name));
    CHECK(name == NULL);
  }
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "kind is 0", mimo_env_count(env, 0, &count));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "kind is 15", mimo_env_find(env, 15, "x", &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "count is NULL", mimo_env_count(env, MIMO_BODY, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is NULL", mimo_env_find(env, MIMO_BODY, NULL, &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "id is NULL", mimo_env_find(env, MIMO_BODY, "world", NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is NULL", mimo_env_name(env, MIMO_BODY, 0, NULL));

  CHECK_OK(mimo_env_body_of(env, MIMO_JOINT, find(env, MIMO_JOINT, "robot:left_knee"), &body));
  CHECK(body == find(env, MIMO_BODY, "left_lower_leg"));
  CHECK_OK(mimo_env_body_of(env, MIMO_GEOM, find(env, MIMO_GEOM, "floor"), &body));
  CHECK(body == 0);
  CHECK_OK(mimo_env_body_of(env, MIMO_SITE, find(env, MIMO_SITE, "vestibular"), &body));
  CHECK(body == find(env, MIMO_BODY, "head"));
  CHECK_OK(mimo_env_body_of(env, MIMO_CAMERA, find(env, MIMO_CAMERA, "eye_left"), &body));
  CHECK(body == find(env, MIMO_BODY, "left_eye"));
  CHECK_OK(mimo_env_body_of(env, MIMO_BODY, find(env, MIMO_BODY, "head"), &body));
  CHECK(body == find(env, MIMO_BODY, "upper_body"));
  body = -7;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "kind is 6 (actuator)", mimo_env_body_of(env, MIMO_ACTUATOR, 0, &body));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "id is 26, expected a body id from 0 to 25",
              mimo_env_body_of(env, MIMO_BODY, 26, &body));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "body is NULL", mimo_env_body_of(env, MIMO_BODY, 0, NULL));
  CHECK(body == -7);
}

/* The first element of each kind, and how many values the header says that it has. */
static void check_quantities(void) {
  static const struct {
    mimo_quantity number;
    size_t width;
  } known[] = {
      {MIMO_BODY_POSITION, 3},      {MIMO_BODY_ORIENTATION, 4},
      {MIMO_BODY_VELOCITY, 6},      {MIMO_BODY_FORCE, 6},
      {MIMO_BODY_MASS, 1},          {MIMO_BODY_CENTER_OF_MASS, 3},
      {MIMO_BODY_POSE, 7},          {MIMO_BODY_NERVE_LENGTH, 1},
      {MIMO_JOINT_POSITION, 7},     {MIMO_JOINT_VELOCITY, 6},
      {MIMO_JOINT_FORCE, 6},        {MIMO_JOINT_ACCELERATION, 6},
      {MIMO_JOINT_RANGE, 2},        {MIMO_JOINT_DAMPING, 1},
      {MIMO_JOINT_LOCK, 2},         {MIMO_GEOM_POSITION, 3},
      {MIMO_GEOM_ORIENTATION, 4},   {MIMO_GEOM_SIZE, 3},
      {MIMO_GEOM_POSE, 7},          {MIMO_GEOM_FRICTION, 3},
      {MIMO_GEOM_COLOR, 4},         {MIMO_SITE_POSITION, 3},
      {MIMO_SITE_ORIENTATION, 4},   {MIMO_SITE_POSE, 7},
      {MIMO_SITE_VELOCITY, 6},      {MIMO_CAMERA_POSITION, 3},
      {MIMO_CAMERA_ORIENTATION, 4}, {MIMO_CAMERA_POSE, 7},
      {MIMO_ACTUATOR_CONTROL, 1},   {MIMO_ACTUATOR_FORCE, 1},
      {MIMO_ACTUATOR_GEAR, 1},      {MIMO_SENSOR_VALUE, 3},
      {MIMO_LIGHT_POSITION, 3},     {MIMO_LIGHT_DIRECTION, 3},
      {MIMO_LIGHT_COLOR, 3},        {MIMO_AGENT_FACE, 1},
      {MIMO_AGENT_AGE, 1},          {MIMO_AGENT_PHYSIOLOGICAL_AGE, 1},
      {MIMO_WORLD_GRAVITY, 3},      {MIMO_WARNING_STEPS, 1},
  };
  double values[9];
  float floats[9];
  const int32_t first = 0;
  size_t count, k;
  for (k = 0; k < sizeof known / sizeof *known; ++k) {
    const mimo_quantity quantity = known[k].number;
    const size_t width = known[k].width;
    size_t asked = 0, i;
    CHECK_OK(mimo_env_width(env, quantity, &first, 1, &asked));
    CHECK(asked == width);
    for (i = 0; i < 9; ++i) values[i] = 77;
    CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count is", mimo_env_get(env, quantity, &first, 1, values, width - 1));
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "value_count is", mimo_env_get(env, quantity, &first, 1, values, width + 1));
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "values is NULL", mimo_env_get(env, quantity, &first, 1, NULL, width));
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ids is NULL", mimo_env_get(env, quantity, NULL, 1, values, width));
    for (i = 0; i < 9; ++i) CHECK(values[i] == 77);
    CHECK_OK(mimo_env_get(env, quantity, &first, 1, values, width));
    for (i = width; i < 9; ++i) CHECK(values[i] == 77);
    CHECK_OK(mimo_env_get_float(env, quantity, &first, 1, floats, width));
    for (i = 0; i < width; ++i) CHECK(floats[i] == (float)values[i] || (isnan(floats[i]) && isnan(values[i])));
    CHECK_OK(mimo_env_get(env, quantity, &first, 0, NULL, 0)); /* none of them */
  }
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0xff, which needs an interface newer",
              mimo_env_get(env, 0xff, &first, 1, values, 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0x1ff, which needs an interface newer",
              mimo_env_get(env, 0x1ff, &first, 1, values, 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0x0", mimo_env_set(env, 0, &first, 1, values, 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0xffffffff", mimo_env_get(env, -1, &first, 1, values, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "MIMO_NOW",
              mimo_env_set(env, MIMO_BODY_POSITION | MIMO_NOW, &first, 1, values, 3));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "no MIMO_NOW",
              mimo_env_get(env, MIMO_SENSOR_VALUE | MIMO_NOW, &first, 1, values, 3));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "step_contacts", mimo_env_count(env, MIMO_STEP_CONTACT, &count));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "value_count is NULL", mimo_env_width(env, MIMO_BODY_POSE, &first, 1, NULL));
}

/* Each in the other's place is refused by name, whichever function it is given to. */
static void check_wrong_calls(void) {
  const mimo_layout* layout = NULL;
  const int32_t first = 0;
  size_t count = 77;
  int32_t id = -7;
  double value = 7;
  float place = 7;
  const char* name = NULL;
  static const char no_kind[] = "kind is MIMO_BODY_POSITION, which is a quantity, expected a kind, such as MIMO_BODY";
  static const char no_quantity[] =
      "quantity is MIMO_STEP_CONTACT, which is a kind, expected a quantity, such as MIMO_BODY_POSITION";
  CHECK_OK(mimo_env_layout(env, &layout));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_count(env, MIMO_BODY_POSITION, &count));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_find(env, MIMO_BODY_POSITION, "head", &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_find(env, MIMO_BODY_POSITION | MIMO_NOW, "head", &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_name(env, MIMO_BODY_POSITION, 0, &name));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_body_of(env, MIMO_BODY_POSITION, 0, &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_kind, mimo_env_poses(env, MIMO_BODY_POSITION, MIMO_AXES_MIMO, &place, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "MIMO_RECEPTOR_BODY, which is a quantity of receptors, expected a kind",
              mimo_env_find(env, MIMO_RECEPTOR_BODY, "head", &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_quantity, mimo_env_width(env, MIMO_STEP_CONTACT, NULL, 0, &count));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_quantity, mimo_env_get(env, MIMO_STEP_CONTACT, &first, 1, &value, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_quantity,
              mimo_env_get_float(env, MIMO_STEP_CONTACT | MIMO_NOW, &first, 1, &place, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, no_quantity, mimo_env_set(env, MIMO_STEP_CONTACT, &first, 1, &value, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "MIMO_RECEPTOR_FRAME, which is a quantity of receptors, expected a quantity,",
              mimo_env_width(env, MIMO_RECEPTOR_FRAME, NULL, 0, &count));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT,
              "quantity is MIMO_BODY_POSE, which is a quantity, expected a quantity of receptors, such as "
              "MIMO_RECEPTOR_POSITION",
              mimo_layout_receptor_width(layout, 0, MIMO_BODY_POSE, &count));
  CHECK(count == 77 && id == -7 && value == 7 && place == 7 && name == NULL);
}

/* A quantity's kind can be read off its number. */
static void check_that_numbers_tell_the_kind(void) {
  CHECK(MIMO_BODY_POSITION >> 8 == MIMO_BODY && MIMO_BODY_NERVE_LENGTH >> 8 == MIMO_BODY);
  CHECK(MIMO_JOINT_POSITION >> 8 == MIMO_JOINT && MIMO_GEOM_COLOR >> 8 == MIMO_GEOM);
  CHECK(MIMO_SITE_POSE >> 8 == MIMO_SITE && MIMO_CAMERA_POSE >> 8 == MIMO_CAMERA);
  CHECK(MIMO_ACTUATOR_GEAR >> 8 == MIMO_ACTUATOR && MIMO_SENSOR_VALUE >> 8 == MIMO_SENSOR);
  CHECK(MIMO_LIGHT_COLOR >> 8 == MIMO_LIGHT && MIMO_CONTACT_FORCE >> 8 == MIMO_CONTACT);
  CHECK(MIMO_STEP_CONTACT_START >> 8 == MIMO_STEP_CONTACT && MIMO_AGENT_GOAL >> 8 == MIMO_AGENT);
  CHECK(MIMO_WORLD_GRAVITY >> 8 == MIMO_WORLD && MIMO_WARNING_STEPS >> 8 == MIMO_WARNING);
}

/* NULL means all, of whatever there are. */
static void check_that_null_means_all(void) {
  double all[26], one;
  size_t count = 0, i;
  CHECK_OK(mimo_env_width(env, MIMO_BODY_MASS, NULL, 0, &count));
  CHECK(count == 26);
  CHECK_OK(mimo_env_get(env, MIMO_BODY_MASS, NULL, 0, all, 26));
  for (i = 0; i < 26; ++i) {
    const int32_t id = (int32_t)i;
    CHECK_OK(mimo_env_get(env, MIMO_BODY_MASS, &id, 1, &one, 1));
    CHECK(one == all[i]);
  }
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "25, but 26 are needed", mimo_env_get(env, MIMO_BODY_MASS, NULL, 0, all, 25));
  CHECK_OK(mimo_env_set(env, MIMO_BODY_MASS, NULL, 0, all, 26)); /* what is there may be written back */
}

static void check_writing(void) {
  const int32_t ball = find(env, MIMO_BODY, "test_object2"), hand = find(env, MIMO_BODY, "left_hand");
  const int32_t bodies[2] = {ball, hand};
  double there[3] = {0.5, -0.25, 2}, back[3], two[6] = {1, 1, 1, 1, 1, 1}, nan[3] = {1, (double)NAN, 1};
  CHECK_OK(mimo_env_set(env, MIMO_BODY_POSITION, &ball, 1, there, 3));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"left_hand\") cannot be moved",
              mimo_env_set(env, MIMO_BODY_POSITION, bodies, 2, two, 6));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "values[1] is nan", mimo_env_set(env, MIMO_BODY_POSITION, &ball, 1, nan, 3));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "value_count is 2, expected 3",
              mimo_env_set(env, MIMO_BODY_POSITION, &ball, 1, two, 2));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "can only be read", mimo_env_set(env, MIMO_BODY_VELOCITY, &ball, 1, two, 6));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &ball, 1, back, 3));
  CHECK(memcmp(there, back, sizeof back) == 0);
  CHECK_OK(mimo_env_update(env));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &ball, 1, back, 3));
  CHECK(memcmp(there, back, sizeof back) == 0);
}

/* A box of 0.3 kg at rest on the floor: the forces on body 2, turned into the world, carry its weight. */
static void check_contacts(void) {
  mimo_scene_config room;
  mimo_object_config object;
  mimo_scene* scene = NULL;
  mimo_env* world = NULL;
  double geoms[8], bodies[8], positions[12], frames[36], distances[4], forces[12], force[3] = {0, 0, 0};
  int32_t floor, box, box_body;
  const int32_t fifth = 4;
  size_t count = 77, i, k;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_object_config_init(&object, sizeof object));
  object.name = "box";
  object.shape = MIMO_SHAPE_BOX;
  object.size[0] = object.size[1] = object.size[2] = 0.05;
  object.mass = 0.3;
  object.position[2] = 0.06;
  CHECK_OK(mimo_scene_add_object(scene, &object));
  CHECK_OK(mimo_env_create(scene, NULL, &world));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_env_count(world, MIMO_CONTACT, &count));
  CHECK(count == 0);
  CHECK_OK(mimo_env_physics_step(world, 1000));
  floor = find(world, MIMO_GEOM, "floor");
  box = find(world, MIMO_GEOM, "box");
  box_body = find(world, MIMO_BODY, "box");
  CHECK_OK(mimo_env_count(world, MIMO_CONTACT, &count));
  CHECK(count == 4); /* one at each corner */
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_GEOMS, NULL, 0, geoms, 8));
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_BODIES, NULL, 0, bodies, 8));
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_POSITION, NULL, 0, positions, 12));
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_FRAME, NULL, 0, frames, 36));
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_DISTANCE, NULL, 0, distances, 4));
  CHECK_OK(mimo_env_get(world, MIMO_CONTACT_FORCE, NULL, 0, forces, 12));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ids[0] is 4, expected a contact id from 0 to 3",
              mimo_env_get(world, MIMO_CONTACT_FORCE, &fifth, 1, forces, 3));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no contact named", mimo_env_find(world, MIMO_CONTACT, "box", &box_body));
  for (i = 0; i < 4; ++i) {
    const double *at = positions + 3 * i, *frame = frames + 9 * i;
    CHECK(geoms[2 * i] == floor && geoms[2 * i + 1] == box && bodies[2 * i] == 0 && bodies[2 * i + 1] == box_body);
    CHECK_NEAR(0.05, fabs(at[0]), 1e-3);
    CHECK_NEAR(0.05, fabs(at[1]), 1e-3);
    CHECK_NEAR(0, at[2], 1e-3);
    CHECK_NEAR(1, frame[2], 1e-6); /* the normal points from the floor to the box */
    CHECK(distances[i] < 0 && distances[i] > -1e-3);
    for (k = 0; k < 9; ++k) force[k % 3] += forces[3 * i + k / 3] * frame[k];
  }
  CHECK_NEAR(0, force[0], 1e-5);
  CHECK_NEAR(0, force[1], 1e-5);
  CHECK_NEAR(0.3 * 9.81, force[2], 1e-5);
  mimo_env_destroy(world);
}

int main(void) {
  env = blind_env("benchmark", NULL);
  check_finding_by_name();
  check_quantities();
  check_wrong_calls();
  check_that_numbers_tell_the_kind();
  check_that_null_means_all();
  check_writing();
  check_contacts();
  mimo_env_destroy(env);
  return failures();
}
