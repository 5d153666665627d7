/* The renderer gl draws what the renderer osmesa draws: Mesa's EGL and Mesa's OSMesa, each in a process of its own,
 * because MuJoCo uses the first OpenGL that it finds for ever. A second one in the same process is refused. */
#include <sys/wait.h>
#include <unistd.h>

#include "support/capi.h"

/* What Mesa itself forgets. */
const char* __lsan_default_suppressions(void);
const char* __lsan_default_suppressions(void) { return "leak:libEGL\nleak:libGLdispatch\nleak:_dri.so\n"; }

enum { SIDE = 128, PIXELS = SIDE * SIDE, SKIPPED = 77 };

typedef struct {
  uint8_t rgb[3 * PIXELS];
  float depth[PIXELS];
  int32_t segment[PIXELS];
} image;

/* What draws, and what became of it. */
static mimo_status draw(const char* renderer, image* into) {
  mimo_env_config config;
  mimo_picture_config picture;
  mimo_scene* scene = blind_scene("benchmark");
  mimo_env* env = NULL;
  mimo_status status;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.renderer = renderer;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK_OK(mimo_picture_config_init(&picture, sizeof picture));
  picture.width = picture.height = SIDE;
  status = mimo_env_render(env, &picture,
                           PICTURE(.rgb = into->rgb, .rgb_bytes = sizeof into->rgb, .depth = into->depth,
                                   .depth_count = PIXELS, .segmentation = into->segment, .segmentation_count = PIXELS));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return status;
}

/* In a child, which has no OpenGL yet. False where the renderer is absent; whatever else goes wrong is a failure. */
static int draw_elsewhere(const char* renderer, image* into) {
  int ends[2], status = 0;
  size_t read_so_far = 0;
  ssize_t got;
  pid_t child;
  CHECK(pipe(ends) == 0);
  child = fork();
  if (child == 0) {
    size_t written = 0;
    const mimo_status drawn = draw(renderer, into);
    if (drawn != MIMO_OK) fprintf(stderr, "%s: %s\n", renderer, mimo_last_error());
    if (drawn == MIMO_E_UNSUPPORTED) _exit(failures() ? 1 : SKIPPED);
    if (drawn != MIMO_OK || failures()) _exit(1);
    while (written < sizeof *into) {
      const ssize_t sent = write(ends[1], (const char*)into + written, sizeof *into - written);
      if (sent <= 0) _exit(2);
      written += (size_t)sent;
    }
    _exit(0);
  }
  close(ends[1]);
  while ((got = read(ends[0], (char*)into + read_so_far, sizeof *into - read_so_far)) > 0) read_so_far += (size_t)got;
  close(ends[0]);
  CHECK(waitpid(child, &status, 0) == child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == SKIPPED) return 0;
  CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  CHECK(read_so_far == sizeof *into);
  return 1;
}

/* Both are Mesa's, and round alike but for the edges of triangles. */
static void compare(const image* one, const image* other) {
  size_t i, geoms = 0, places = 0;
  double difference = 0;
  for (i = 0; i < PIXELS; ++i) {
    geoms += one->segment[i] == other->segment[i];
    places += fabs((double)(one->depth[i] - other->depth[i])) <= 1e-3 + 1e-3 * (double)one->depth[i];
  }
  for (i = 0; i < 3 * PIXELS; ++i) difference += abs(one->rgb[i] - other->rgb[i]);
  printf("equal geoms %.5f, equal depths %.5f, mean difference of colours %.4f of 255\n", (double)geoms / PIXELS,
         (double)places / PIXELS, difference / (3 * PIXELS));
  CHECK((double)geoms >= 0.999 * PIXELS);
  CHECK((double)places >= 0.999 * PIXELS);
  CHECK(difference <= 0.25 * 3 * PIXELS);
}

/* A picture in which nothing shows would be equal as well. */
static void check_it_shows_something(const image* picture) {
  size_t i, things = 0;
  for (i = 0; i < PIXELS; ++i) things += picture->segment[i] > 0;
  CHECK(things > PIXELS / 100);
}

int main(void) {
  static image gl, osmesa;
  mimo_status status;
  const int has_osmesa = draw_elsewhere("osmesa", &osmesa);
  status = draw("gl", &gl);
  if (status == MIMO_E_UNSUPPORTED) {
    CHECK(strstr(mimo_last_error(), "renderer gl") != NULL);
    fprintf(stderr, "no EGL here: %s\n", mimo_last_error());
    return failures() ? failures() : SKIPPED;
  }
  CHECK_OK(status);
  check_it_shows_something(&gl);
  if (!has_osmesa) {
    fprintf(stderr, "no OSMesa here to compare with\n");
    return failures();
  }
  compare(&gl, &osmesa);
  CHECK(draw("osmesa", &osmesa) == MIMO_E_UNSUPPORTED);
  CHECK(strstr(mimo_last_error(), "this process draws with EGL") != NULL);
  CHECK_OK(draw("gl", &gl));
  return failures();
}
