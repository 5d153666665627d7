/* A world that is given any actions, values and orders: each call is done or refused, and a reset always helps. */
#include "fuzz/input.h"

#define ACTIONS 128
#define IDS 4
#define VALUES 28
#define BLOCK 65536
#define MOST_CALLS 40

static mimo_env* env;
static uint8_t* block;
static size_t block_bytes, actions;

static void make_world(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  CALL(mimo_scene_config_init(&room, sizeof room));
  room.name = "selfbody";
  PROMISE(mimo_scene_create(&room, &scene) == MIMO_OK);
  CALL(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.touch_scale = 0.3;
  PROMISE(mimo_scene_add_agent(scene, &agent, NULL) == MIMO_OK);
  PROMISE(mimo_env_create(scene, NULL, &env) == MIMO_OK);
  mimo_scene_destroy(scene);
  block_bytes = sizes_of(env).block_bytes;
  actions = sizes_of(env).actions;
  PROMISE(block_bytes <= BLOCK && actions <= ACTIONS);
  block = malloc(BLOCK);
  PROMISE(block != NULL);
}

static void step(input* in) {
  float action[ACTIONS];
  double reward = -1234;
  uint8_t terminated = 77, truncated = 77;
  int32_t outcome = 77;
  double terms[2] = {0, 0};
  mimo_env_results results = {sizeof results, 0, &reward, &terminated, &truncated, &outcome, 1, terms, 2};
  take(in, action, actions * sizeof *action);
  if (CALL(mimo_env_step(env, action, actions, block, block_bytes, &results)) == MIMO_OK) {
    PROMISE(terminated <= 1 && truncated <= 1 && outcome >= MIMO_OUTCOME_FAILURE && outcome <= MIMO_OUTCOME_SUCCESS);
  }
}

static void take_ids(input* in, int32_t* ids) {
  int i;
  for (i = 0; i < IDS; ++i) ids[i] = (int32_t)take_below(in, 300) - 3;
}

static void set(input* in) {
  int32_t ids[IDS];
  double values[VALUES];
  size_t width = 0;
  const int32_t quantity = (int32_t)take_below(in, 26) - 1;
  const size_t count = take_below(in, IDS + 1);
  take_ids(in, ids);
  if (CALL(mimo_env_width(env, quantity, ids, count, &width)) != MIMO_OK || width > VALUES) return;
  take(in, values, width * sizeof *values);
  CALL(mimo_env_set(env, quantity, ids, count, values, width));
  CALL(mimo_env_get(env, quantity, ids, count, values, width));
}

static void look(input* in) {
  uint8_t rgb[8 * 8 * 3];
  double point[3], pixel[3];
  ROOMY(mimo_picture_config, given);
  CALL(mimo_picture_config_init(&given.config, sizeof given.config));
  take(in, &given.config, sizeof given.config);
  given.config.camera = NULL;
  if (given.config.width <= 4096) given.config.width = given.config.width % 8 + 1;
  if (given.config.height <= 4096) given.config.height = given.config.height % 8 + 1;
  CALL(mimo_env_render(env, &given.config, PICTURE(.rgb = rgb, .rgb_bytes = sizeof rgb)));
  take(in, point, sizeof point);
  CALL(mimo_env_project(env, &given.config, point, 1, pixel));
}

static void change(input* in) {
  const int32_t joint = (int32_t)take_below(in, 120) - 2;
  const double x = take_double(in), held[2] = {1, x}, free_again[2] = {0, x}, gravity[3] = {x, 0, -9.81};
  switch (take_byte(in) % 3) {
    case 0: CALL(mimo_env_set(env, MIMO_JOINT_LOCK, &joint, 1, held, 2)); break;
    case 1: CALL(mimo_env_set(env, MIMO_JOINT_LOCK, &joint, 1, free_again, 2)); break;
    default: CALL(mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, gravity, 3)); break;
  }
}

static void ask(input* in) {
  double numbers[4];
  size_t contacts;
  const char* text;
  mimo_term term = {.struct_size = sizeof term};
  CALL(mimo_env_random(env, numbers, 4));
  CALL(mimo_layout_term(layout_of(env), take_byte(in), &term));
  CALL(mimo_env_count(env, MIMO_CONTACT, &contacts));
  CALL(mimo_env_name(env, take_byte(in), take_byte(in), &text));
  CALL(mimo_layout_label(layout_of(env), take_byte(in), take_byte(in), &text));
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  input in = {data, size};
  const double earth[3] = {0, 0, -9.81};
  int calls;
  if (env == NULL) make_world();
  PROMISE(mimo_env_reset(env, SEED(1), block, block_bytes) == MIMO_OK);
  for (calls = 0; in.left > 0 && calls < MOST_CALLS; ++calls) {
    switch (take_byte(&in) % 7) {
      case 0: step(&in); break;
      case 1: set(&in); break;
      case 2: look(&in); break;
      case 3: change(&in); break;
      case 4: ask(&in); break;
      case 5: CALL(mimo_env_physics_step(env, take_byte(&in) % 5)); break;
      default: CALL(mimo_env_observe(env, block, block_bytes)); break;
    }
  }
  /* What outlives resets goes back, so that a run does not depend on the one before. */
  CALL(mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, earth, 3));
  PROMISE(mimo_env_reset(env, SEED(1), block, block_bytes) == MIMO_OK);
  return 0;
}
