/* Hearing: the field and its times, sounds that bodies play, cries. */
#include <math.h>

#include "support/capi.h"

#define RATE 16000
enum { kStep = 160 }; /* samples of a step of two physics steps, 5 ms each */

static float beep[801]; /* one more than a world of these steps takes */

static mimo_scene* empty_with_ears(uint32_t hearing) {
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = agent.touch = 0;
  agent.hearing = hearing;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

static void the_layout_tells_rate_and_interval(void) {
  mimo_scene* scene = empty_with_ears(MIMO_HEARING_EARS | MIMO_HEARING_BANDS);
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  const mimo_field left = field_of(env, "hearing/ear_left"), bands = field_of(env, "hearing/bands");
  CHECK(left.dtype == MIMO_F32 && left.shape[0] == kStep && left.ndim == 1);
  CHECK(left.sample_rate == RATE && fabs(left.period - 0.01) < 1e-12);
  CHECK(strcmp(left.unit, "Pa") == 0 && strcmp(bands.unit, "dB") == 0);
  CHECK(bands.shape[0] == 2 && bands.shape[1] == 24 && bands.sample_rate == 0);
  CHECK(strcmp(field_of(env, "hearing/time_difference").unit, "s") == 0);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void bodies_play(void) {
  mimo_scene* scene = empty_with_ears(MIMO_HEARING_EARS);
  mimo_env *env = NULL, *deaf = NULL;
  CHECK_OK(mimo_scene_set_sources(scene, 1, 0.05));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  const mimo_field left = field_of(env, "hearing/ear_left");
  mimo_layout_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  unsigned char* block = malloc(info.block_bytes);
  CHECK_OK(mimo_env_reset(env, NULL, block, info.block_bytes));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "nobody", mimo_env_play(env, "nobody", beep, 800, RATE));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "rate is 44100, expected 16000", mimo_env_play(env, "head", beep, 800, 44100));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "count is 801, expected up to 800", mimo_env_play(env, "head", beep, 801, RATE));
  beep[7] = NAN;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "samples[7]", mimo_env_play(env, "head", beep, 800, RATE));
  for (int i = 0; i < 800; ++i) beep[i] = sinf(0.3f * (float)i);
  CHECK_OK(mimo_env_play(env, "head", beep, 800, RATE));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "cannot play: ", mimo_env_play(env, "left_hand", beep, 10, RATE));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, info.block_bytes, NULL));
  const float* heard = (const float*)(block + left.offset);
  float loudest = 0;
  for (int i = 0; i < kStep; ++i) loudest = fmaxf(loudest, fabsf(heard[i]));
  CHECK(loudest > 0.1f);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  scene = empty_with_ears(0);
  CHECK_OK(mimo_env_create(scene, NULL, &deaf));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "no agent has hearing", mimo_env_play(deaf, "head", beep, 10, RATE));
  mimo_env_destroy(deaf);
  mimo_scene_destroy(scene);
  free(block);
}

/* A cry is 82 dB at 1 m, 99 at the own ears (docs/guide/hearing.md), where 0 dB are 20 micropascals. */
static void infants_cry(void) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_agent_config agent;
  mimo_layout_info info = {.struct_size = sizeof info};
  mimo_action first = {.struct_size = sizeof first};
  float cry[200] = {0};
  double squares = 0;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "free"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = agent.touch = 0;
  agent.hearing = MIMO_HEARING_EARS;
  agent.voice = 1;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  CHECK(info.actions <= 200);
  CHECK_OK(mimo_layout_action(layout_of(env), info.actions - 4, &first));
  CHECK(strcmp(first.name, "voice:loudness") == 0 && first.low == 0 && first.high == 1);
  cry[info.actions - 4] = cry[info.actions - 2] = cry[info.actions - 1] = 1;
  const mimo_field left = field_of(env, "hearing/ear_left");
  unsigned char* block = malloc(info.block_bytes);
  for (int step = 0; step < 50; ++step) {
    CHECK_OK(mimo_env_step(env, cry, info.actions, block, info.block_bytes, NULL));
    const float* heard = (const float*)(block + left.offset);
    for (int i = 0; step >= 25 && i < kStep; ++i) squares += (double)heard[i] * (double)heard[i];
  }
  CHECK(fabs(10 * log10(squares / (25 * kStep) / 4e-10) - 99) < 1);
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

int main(void) {
  the_layout_tells_rate_and_interval();
  bodies_play();
  infants_cry();
  return failures();
}
