/* Senses on a model of your own: this program simulates an MJCF file with MuJoCo by itself; libmimo only looks.
 * Prints what touches the model's parts, and how its body accelerates; that is felt a tenth of a second late, so the
 * senses have something to remember.
 *
 *   cc own_model.c $(pkg-config --cflags --libs mimo) -lmujoco && ./a.out robot.xml torso
 */
#include <mimo/mimo.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

/* What is to be sensed: everything from the body `root` on, with a sensor every 3 cm of its skin. */
static mimo_scene* describe(const char* root) {
  mimo_agent_config agent;
  mimo_limits late;
  mimo_scene* scene;
  size_t number;
  check(mimo_scene_create(NULL, &scene)); /* empty: the model is our own */
  check(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = root;
  agent.vestibular_at = root; /* a site in the head would be better */
  agent.vision = 0;           /* MIMO_VISION_RGB would show what all cameras on it see */
  check(mimo_scene_add_agent(scene, &agent, &number));
  check(mimo_scene_set_touch(scene, number, NULL, 0.03));
  check(mimo_limits_init(&late, sizeof late));
  late.delay = 0.1; /* seconds */
  check(mimo_scene_limit_sense(scene, number, "vestibular", &late));
  return scene;
}

/* Where a field starts in the block. */
static const float* find(const mimo_layout* layout, const void* block, const char* name, size_t* count) {
  mimo_field field;
  size_t index;
  field.struct_size = sizeof field;
  check(mimo_layout_find(layout, name, &index));
  check(mimo_layout_field(layout, index, &field));
  *count = field.bytes / sizeof(float);
  return (const float*)(const void*)((const char*)block + field.offset);
}

int main(int argc, char** argv) {
  char error[500];
  mjModel* model;
  mjData* data;
  mimo_scene* scene;
  mimo_senses_config config;
  mimo_senses* senses;
  const mimo_layout* layout;
  mimo_layout_info sizes;
  void* block;
  const float *force, *acceleration;
  size_t forces, axes, i;
  int step;

  if (argc != 3) {
    fprintf(stderr, "usage: %s FILE.xml BODY\n", argv[0]);
    return 2;
  }
  model = mj_loadXML(argv[1], NULL, error, sizeof error);
  if (model == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  data = mj_makeData(model);

  scene = describe(argv[2]);
  check(mimo_senses_config_init(&config, sizeof config));
  config.mujoco_version = mj_version();
  config.model_size = sizeof(mjModel);
  config.data_size = sizeof(mjData);
  check(mimo_senses_attach(scene, model, &config, &senses));
  mimo_scene_destroy(scene);
  check(mimo_senses_layout(senses, &layout));
  sizes.struct_size = sizeof sizes;
  check(mimo_layout_describe(layout, &sizes));
  block = malloc(sizes.block_bytes);
  if (block == NULL) return 1;
  force = find(layout, block, "touch/force", &forces);
  acceleration = find(layout, block, "vestibular/acceleration", &axes);

  mj_forward(model, data);
  check(mimo_senses_reset(senses, data, NULL)); /* an episode starts: nothing was felt before this */
  for (step = 0; step < 200; ++step) {
    mj_step(model, data);                     /* the simulation is ours */
    check(mimo_senses_advance(senses, data)); /* once a step: what is late takes this in */
    if (step % 20 != 19) continue;
    check(mimo_senses_observe(senses, data, block, sizes.block_bytes)); /* and stays as it is */
    {
      size_t pressed = 0;
      for (i = 0; i < forces; i += 3) pressed += force[i] != 0 || force[i + 1] != 0 || force[i + 2] != 0;
      printf("%.2f s: %zu of %zu sensors are touched, acceleration %6.2f %6.2f %6.2f m/s^2\n", data->time, pressed,
             forces / 3, (double)acceleration[0], (double)acceleration[1], (double)acceleration[2]);
    }
  }

  free(block);
  mimo_senses_destroy(senses);
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
