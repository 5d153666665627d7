/* Pictures without a simulation: a snowman on a chequered floor, drawn from plain arrays that any engine could fill.
 * Writes camera_only.ppm, and prints how far the middle of the picture is and what is seen there.
 *
 *   cc camera_only.c $(pkg-config --cflags --libs mimo) && ./a.out
 *
 * With MuJoCo's headers and -DWITH_MUJOCO -lmujoco it also draws a model: ./a.out robot.xml writes
 * camera_only_model.ppm.
 */
#include <mimo/experimental.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 320, HEIGHT = 240 };

static uint8_t rgb[HEIGHT * WIDTH * 3];
static float depth[HEIGHT * WIDTH];
static int32_t objects[HEIGHT * WIDTH * 2];

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static void write_picture(const char* path) {
  FILE* file = fopen(path, "wb");
  if (file == NULL) exit(1);
  fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
  fwrite(rgb, 1, sizeof rgb, file);
  fclose(file);
}

/* From one camera into the buffers above. */
static void draw(mimo_stage* stage, const mimo_stage_poses* poses, const double* position, const double* rotation) {
  const mimo_stage_view* views;
  mimo_stage_view view;
  check(mimo_stage_view_init(&view, sizeof view));
  view.width = WIDTH;
  view.height = HEIGHT;
  view.position = position;
  view.rotation = rotation;
  view.rgb = rgb;
  view.rgb_bytes = sizeof rgb;
  view.depth = depth;
  view.depth_count = HEIGHT * WIDTH;
  view.segmentation = objects;
  view.segmentation_count = HEIGHT * WIDTH * 2;
  views = &view;
  check(mimo_stage_draw(stage, &poses, 1, &views, 1));
}

/* ---- A scene that no engine knows ---- */

static mimo_stage* make_snowman(void) {
  const int32_t forms[] = {MIMO_FORM_PLANE, MIMO_FORM_SPHERE, MIMO_FORM_SPHERE, MIMO_FORM_SPHERE, MIMO_FORM_CAPSULE};
  const double sizes[] = {0, 0, 0, 0.5, 0, 0, 0.35, 0, 0, 0.22, 0, 0, 0.04, 0.1, 0};
  const float colors[] = {.5f, .5f, .5f, 1, .9f, .9f, 1, 1, .9f, .9f, 1, 1, .9f, .9f, 1, 1, 1, .5f, .1f, 1};
  const int32_t materials[] = {0, -1, -1, -1, -1};
  const uint8_t squares[] = {60, 90, 60, 200, 220, 200, 200, 220, 200, 60, 90, 60}; /* 2 x 2 pixels */
  const int32_t flat = MIMO_TEXTURE_FLAT, two = 2, first = 0, sun = MIMO_LAMP_SUN;
  const float white[] = {1, 1, 1, 1}, repeat[] = {1, 1};
  const uint8_t per_metre = 1;
  mimo_stage_shapes geoms = {.struct_size = sizeof geoms, .object_type = 5};
  mimo_stage_textures textures = {.struct_size = sizeof textures};
  mimo_stage_materials floor = {.struct_size = sizeof floor};
  mimo_stage_lights lights = {.struct_size = sizeof lights};
  mimo_stage_config config = {.struct_size = sizeof config};
  mimo_stage* stage;
  geoms.count = 5;
  geoms.forms = forms;
  geoms.sizes = sizes;
  geoms.colors = colors;
  geoms.materials = materials;
  textures.count = 1;
  textures.types = &flat;
  textures.widths = textures.heights = &two;
  textures.pixels = squares;
  textures.pixel_bytes = sizeof squares;
  floor.count = 1;
  floor.colors = white;
  floor.textures = &first;
  floor.repeats = repeat;
  floor.uniform = &per_metre;
  lights.count = 1;
  lights.types = &sun;
  config.geoms = &geoms;
  config.textures = &textures;
  config.materials = &floor;
  config.lights = &lights;
  check(mimo_stage_create(&config, &stage));
  return stage;
}

static void draw_snowman(void) {
  static const char* const names[] = {"the floor", "the belly", "the chest", "the head", "the nose"};
  static const double places[] = {0, 0, 0, 0, 0, .45, 0, 0, 1.1, 0, 0, 1.55, 0, -.25, 1.55};
  /* Unit quaternions; the nose, along its own z, points to -y. */
  static const double turns[] = {
      1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.70710678118654757, 0.70710678118654757, 0, 0};
  static const double light[] = {0, 0, 5}, shine[] = {0.48, 0.6, -0.64};
  /* 4 m before it, looking along y: x is right, z is up, backward is -y. */
  static const double eye[] = {0, -4, 1}, look[] = {1, 0, 0, 0, 0, -1, 0, 1, 0};
  const int middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
  mimo_stage_poses poses = {.struct_size = sizeof poses};
  mimo_stage* stage = make_snowman();
  poses.geom_count = 5;
  poses.geom_positions = places;
  poses.geom_quaternions = turns;
  poses.light_count = 1;
  poses.light_positions = light;
  poses.light_directions = shine;
  draw(stage, &poses, eye, look);
  write_picture("camera_only.ppm");
  printf("in the middle, %.2f m away: %s\n", depth[middle], names[objects[2 * middle]]);
  mimo_stage_destroy(stage);
}

/* ---- A scene that a model of MuJoCo describes ---- */

#ifdef WITH_MUJOCO
#include <mujoco/mujoco.h>

/* The model's own arrays, as they lie in memory; this program draws its geoms and lights. */
static void draw_model(const char* path) {
  /* From 3 m away, slantwise from above: right, up and backward are columns. */
  static const double eye[] = {2.0, -2.0, 2.2};
  static const double look[] = {.70710678, -.35355339, .61237244, .70710678, .35355339, -.61237244, 0, .8660254, .5};
  char error[500] = "";
  mjModel* model = mj_loadXML(path, NULL, error, sizeof error);
  mimo_stage_shapes geoms = {.struct_size = sizeof geoms, .object_type = mjOBJ_GEOM};
  mimo_stage_materials materials = {.struct_size = sizeof materials};
  mimo_stage_config config = {.struct_size = sizeof config};
  mimo_stage_poses poses = {.struct_size = sizeof poses};
  mimo_stage* stage;
  mjData* data;
  if (model == NULL) {
    fprintf(stderr, "%s\n", error);
    exit(1);
  }
  data = mj_makeData(model);
  mj_forward(model, data);
  geoms.count = (size_t)model->ngeom;
  geoms.forms = model->geom_type;
  geoms.sizes = model->geom_size;
  geoms.colors = model->geom_rgba;
  geoms.materials = model->geom_matid;
  geoms.groups = model->geom_group;
  geoms.data = model->geom_dataid;
  materials.count = (size_t)model->nmat;
  materials.colors = model->mat_rgba;
  materials.emission = model->mat_emission;
  materials.specular = model->mat_specular;
  materials.shininess = model->mat_shininess;
  config.geoms = &geoms;
  config.materials = &materials;
  check(mimo_stage_create(&config, &stage));
  poses.geom_count = geoms.count;
  poses.geom_positions = data->geom_xpos;
  poses.geom_rotations = data->geom_xmat;
  draw(stage, &poses, eye, look);
  write_picture("camera_only_model.ppm");
  printf("the model has %d geoms\n", (int)model->ngeom);
  mimo_stage_destroy(stage);
  mj_deleteData(data);
  mj_deleteModel(model);
}
#endif

int main(int argc, char** argv) {
  draw_snowman();
#ifdef WITH_MUJOCO
  if (argc > 1) draw_model(argv[1]);
#else
  (void)argc, (void)argv;
#endif
  return 0;
}
