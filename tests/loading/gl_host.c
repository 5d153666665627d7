/* A host that draws with an OpenGL of its own, whose context is current on the thread that calls: a second OSMesa, or
 * GLX. The infant's eyes see what they see in a process without any, by either renderer, and afterwards the host's
 * context is current again and works. loading_gl_host osmesa|glx libmimo.so */
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <unistd.h>

#include "loading/library.h"

enum { kSkipped = 77, kRgba = 0x1908, kUnsignedByte = 0x1401, kColorBuffer = 0x4000 };

/* What the eyes see in some steps, as a hash; 0 where the renderer does not work here. */
static uint64_t look(const char* path, const char* renderer) {
  const library mimo = open_library(path);
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_status status;
  uint64_t hash = 0;
  CHECK(mimo.scene_config_init(&room, sizeof room) == MIMO_OK);
  room.name = "benchmark";
  CHECK(mimo.scene_create(&room, &scene) == MIMO_OK);
  CHECK(mimo.agent_config_init(&agent, sizeof agent) == MIMO_OK);
  agent.vision_width = agent.vision_height = 32;
  CHECK(mimo.scene_add_agent(scene, &agent, NULL) == MIMO_OK);
  CHECK(mimo.env_config_init(&config, sizeof config) == MIMO_OK);
  config.renderer = renderer;
  status = mimo.env_create(scene, &config, &env);
  CHECK(status == MIMO_OK || status == MIMO_E_UNSUPPORTED);
  if (status == MIMO_OK) hash = hash_of_life(&mimo, env, 3);
  mimo.env_destroy(env);
  mimo.scene_destroy(scene);
  return hash;
}

/* The same in a process that has no OpenGL of its own. */
static uint64_t look_elsewhere(const char* path, const char* renderer) {
  uint64_t hash = 0;
  int ends[2], status = -1;
  pid_t child;
  CHECK(pipe(ends) == 0);
  child = fork();
  if (child == 0) {
    hash = look(path, renderer);
    _exit(write(ends[1], &hash, sizeof hash) != sizeof hash || failures());
  }
  CHECK(waitpid(child, &status, 0) == child && status == 0);
  CHECK(read(ends[0], &hash, sizeof hash) == sizeof hash);
  close(ends[0]);
  close(ends[1]);
  return hash;
}

/* The host: whether its context is current, and whether what it paints arrives. */
typedef struct host {
  int (*is_current)(void);
  int (*paints)(float red);
} host;

/* ---- A second OSMesa ---- */

static struct {
  void *context, *(*create)(unsigned, int, int, int, void*), *(*current)(void), *(*find)(const char*);
  unsigned char (*make_current)(void*, void*, unsigned, int, int);
  unsigned char pixels[4 * 4 * 4];
} osmesa;

static int osmesa_is_current(void) { return osmesa.current() == osmesa.context; }

static int osmesa_paints(float red) {
  void (*clear_color)(float, float, float, float);
  void (*clear)(unsigned);
  void (*finish)(void);
  void* found[3];
  found[0] = osmesa.find("glClearColor");
  found[1] = osmesa.find("glClear");
  found[2] = osmesa.find("glFinish");
  memcpy(&clear_color, &found[0], sizeof found[0]);
  memcpy(&clear, &found[1], sizeof found[1]);
  memcpy(&finish, &found[2], sizeof found[2]);
  clear_color(red, 0, 0, 1);
  clear(kColorBuffer);
  finish();
  return abs(osmesa.pixels[4 * 15] - (int)(255 * red + 0.5F)) <= 1;
}

static int open_osmesa(host* own) {
  void* mesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (mesa == NULL) return 0;
  look_up(mesa, "OSMesaCreateContextExt", &osmesa.create);
  look_up(mesa, "OSMesaMakeCurrent", &osmesa.make_current);
  look_up(mesa, "OSMesaGetCurrentContext", &osmesa.current);
  look_up(mesa, "OSMesaGetProcAddress", &osmesa.find);
  osmesa.context = osmesa.create(kRgba, 0, 0, 0, NULL);
  own->is_current = osmesa_is_current;
  own->paints = osmesa_paints;
  return osmesa.context != NULL && osmesa.make_current(osmesa.context, osmesa.pixels, kUnsignedByte, 4, 4);
}

/* ---- GLX, on an X display ---- */

static struct {
  void *context, *(*current)(void);
  void (*clear_color)(float, float, float, float);
  void (*clear)(unsigned);
  void (*read)(int, int, int, int, unsigned, unsigned, void*);
} glx;

static int glx_is_current(void) { return glx.current() == glx.context; }

static int glx_paints(float red) {
  unsigned char pixel[4] = {0, 0, 0, 0};
  glx.clear_color(red, 0, 0, 1);
  glx.clear(kColorBuffer);
  glx.read(0, 0, 1, 1, kRgba, kUnsignedByte, pixel);
  return abs(pixel[0] - (int)(255 * red + 0.5F)) <= 1;
}

static int open_glx(host* own) {
  static const int drawable[] = {0x8010, 4, 0}, size[] = {0x8041, 8, 0x8040, 8, 0}; /* a pbuffer of 8 x 8 */
  void *x11 = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL), *gl = dlopen("libGL.so.1", RTLD_NOW | RTLD_GLOBAL),
       *display;
  void* (*open_display)(const char*), **(*choose)(void*, int, const int*, int*);
  void* (*create)(void*, void*, int, void*, int);
  unsigned long (*create_pbuffer)(void*, void*, const int*), pbuffer;
  int (*make_current)(void*, unsigned long, unsigned long, void*), count = 0;
  void** configs;
  if (x11 == NULL || gl == NULL) return 0;
  look_up(x11, "XOpenDisplay", &open_display);
  look_up(gl, "glXChooseFBConfig", &choose);
  look_up(gl, "glXCreateNewContext", &create);
  look_up(gl, "glXCreatePbuffer", &create_pbuffer);
  look_up(gl, "glXMakeContextCurrent", &make_current);
  look_up(gl, "glXGetCurrentContext", &glx.current);
  look_up(gl, "glClearColor", &glx.clear_color);
  look_up(gl, "glClear", &glx.clear);
  look_up(gl, "glReadPixels", &glx.read);
  own->is_current = glx_is_current;
  own->paints = glx_paints;
  if ((display = open_display(NULL)) == NULL) return 0;
  configs = choose(display, 0, drawable, &count);
  if (configs == NULL || count == 0) return 0;
  pbuffer = create_pbuffer(display, configs[0], size);
  glx.context = create(display, configs[0], 0x8014, NULL, 1); /* GLX_RGBA_TYPE */
  return glx.context != NULL && make_current(display, pbuffer, pbuffer, glx.context);
}

int main(int argc, char** argv) {
  static const char* renderers[] = {"osmesa", "ray"};
  uint64_t expected[2];
  host own;
  int i;
  if (argc != 3) return 2;
  for (i = 0; i < 2; ++i) expected[i] = look_elsewhere(argv[2], renderers[i]);
  if (!(strcmp(argv[1], "glx") == 0 ? open_glx(&own) : open_osmesa(&own))) return kSkipped;
  CHECK(own.is_current() && own.paints(1));
  for (i = 0; i < 2; ++i) {
    if (expected[i] == 0) continue; /* no OSMesa here */
    CHECK(look(argv[2], renderers[i]) == expected[i]);
    CHECK(own.is_current() && own.paints(0.2F) && own.paints(0.6F));
  }
  CHECK(expected[1] != 0);
  return failures();
}
