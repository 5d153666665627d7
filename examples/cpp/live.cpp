// The infant live in a window that this program draws itself, with OpenGL: shapes, looks, lights and poses come from
// the library, as an engine would take them. Needs GLFW.
//
//   c++ live.cpp $(pkg-config --cflags --libs mimo glfw3 gl) && ./a.out playdate
//
// Drag to turn, scroll to come nearer, space to pause, R to start again. With --compare it shows no window: it moves
// for half a second, draws one picture, and tells how far that is from the library's own; more than 2 of 255 fail.
#define GL_GLEXT_PROTOTYPES  // shaders; elsewhere than on Linux they are to be had by glfwGetProcAddress
#define GLFW_INCLUDE_GLEXT
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mimo/mimo.hpp>
#include <random>

namespace {

const int kWidth = 640, kHeight = 480;
const double kFovy = 45, kPi = 3.14159265358979;

struct Camera {
  double azimuth = 135, elevation = -25, distance = 2.2;  // as of mimo_picture_config, around the point (0, 0, 0.3)
};

// ---- What is uploaded once --------------------------------------------------------------------------------------

GLuint upload(const mimo::Texture& texture) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  // The six pictures of a cube lie one above the other: smaller ones would mix their edges.
  const bool flat = texture.type == MIMO_TEXTURE_FLAT;
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, flat ? GL_TRUE : GL_FALSE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, flat ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, static_cast<GLsizei>(texture.width), static_cast<GLsizei>(texture.height), 0,
               GL_RGBA, GL_UNSIGNED_BYTE, texture.pixels.data());
  return id;
}

// A display list that draws the mesh.
GLuint upload(const mimo::Mesh& mesh) {
  const GLuint list = glGenLists(1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glNormalPointer(GL_FLOAT, 0, mesh.normals.data());
  glTexCoordPointer(2, GL_FLOAT, 0, mesh.texcoords.data());
  glNewList(list, GL_COMPILE);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
  glEndList();
  return list;
}

// Phong's light at each pixel: a floor of two triangles has lamps in its middle. What mimo_light and mimo_appearance
// say are OpenGL's own lights and materials.
const char* const kVertices =
    "varying vec3 place, normal; varying vec2 texel;"
    "void main() {"
    "  place = vec3(gl_ModelViewMatrix * gl_Vertex); normal = gl_NormalMatrix * gl_Normal; texel = "
    "gl_MultiTexCoord0.xy;"
    "  gl_Position = ftransform();"
    "}";
const char* const kPixels =
    "uniform sampler2D image; uniform int textured, lights; varying vec3 place, normal; varying vec2 texel;"
    "void main() {"
    "  vec3 n = normalize(normal), light = gl_FrontMaterial.emission.rgb, bright = vec3(0.0);"
    "  for (int i = 0; i < 8; ++i) if (i < lights) {"
    "    vec3 way = gl_LightSource[i].position.xyz - place * gl_LightSource[i].position.w, l = normalize(way);"
    "    float d = length(way), in_cone = dot(-l, normalize(gl_LightSource[i].spotDirection)), strength = 1.0;"
    "    if (gl_LightSource[i].position.w > 0.0)"
    "      strength = 1.0 / (gl_LightSource[i].constantAttenuation + d * gl_LightSource[i].linearAttenuation +"
    "                        d * d * gl_LightSource[i].quadraticAttenuation);"
    "    if (gl_LightSource[i].spotCutoff <= 90.0)"
    "      strength *= in_cone < gl_LightSource[i].spotCosCutoff ? 0.0 : pow(in_cone, gl_LightSource[i].spotExponent);"
    "    float facing = max(dot(n, l), 0.0), shine = max(dot(n, normalize(l - normalize(place))), 0.0);"
    "    light += strength * gl_FrontMaterial.diffuse.rgb * (gl_LightSource[i].ambient.rgb + facing * "
    "gl_LightSource[i].diffuse.rgb);"
    "    if (facing > 0.0) bright += strength * gl_FrontMaterial.specular.rgb * gl_LightSource[i].specular.rgb *"
    "                                pow(shine, gl_FrontMaterial.shininess);"
    "  }"
    "  vec4 color = vec4(min(light + bright, 1.0), gl_FrontMaterial.diffuse.a);"
    "  gl_FragColor = textured == 1 ? color * texture2D(image, texel) : color;"
    "}";

GLuint make_program() {
  const GLuint program = glCreateProgram();
  for (const auto& part : {std::make_pair(GL_VERTEX_SHADER, kVertices), std::make_pair(GL_FRAGMENT_SHADER, kPixels)}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(part.first));
    glShaderSource(shader, 1, &part.second, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  glUseProgram(program);
  return program;
}

struct Shape {
  GLuint list;
  mimo_appearance material;
};

struct World {
  explicit World(const char* scene);
  void upload();
  void step();

  mimo::Env env;
  mimo::Block block;
  std::vector<float> actions, poses;
  std::vector<Shape> shapes;
  std::vector<GLuint> textures;
  GLuint program = 0;
  std::mt19937 random;
};

mimo::Env make(const char* scene) {
  mimo_scene_config room = mimo::scene_config();
  room.name = scene;
  mimo::Scene built(room);
  mimo_agent_config infant = built.default_agent();
  infant.vision = infant.touch = 0;  // nobody looks at what it senses here
  built.add_agents(&infant);
  mimo_env_config config = mimo::env_config();
  config.render = 0;  // pictures to compare with: neither shadows nor mirrors nor sky
  config.samples = 4;
  return mimo::Env(built, config);
}

World::World(const char* scene) : env(make(scene)), block(env.make_block()), actions(env.layout().info().actions) {
  env.reset(1, block);
  poses = env.poses(MIMO_GEOM);
}

void World::upload() {
  program = make_program();
  for (std::size_t i = 0; i < env.texture_count(); ++i) {
    textures.push_back(::upload(env.texture(static_cast<std::int32_t>(i))));
  }
  for (std::size_t i = 0; i < env.count(MIMO_GEOM); ++i) {
    const std::int32_t geom = static_cast<std::int32_t>(i);
    shapes.push_back({::upload(env.mesh(geom, MIMO_AXES_MIMO, 32, 100)), env.appearance(geom)});
  }
}

// Random movement, another one each quarter of a second.
void World::step() {
  std::uniform_real_distribution<float> share(-0.3f, 0.3f);
  if (std::fmod(env.time() + 1e-9, 0.25) < 0.009)
    std::generate(actions.begin(), actions.end(), [&] { return share(random); });
  env.step(actions, block);
  env.read_poses(MIMO_GEOM, MIMO_AXES_MIMO, poses);
}

// ---- What is drawn in each frame --------------------------------------------------------------------------------

void look_from(const Camera& camera, int width, int height) {
  const double top = 0.05 * std::tan(kFovy * kPi / 360), side = top * width / height;
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-side, side, -top, top, 0.05, 200);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslated(0, 0, -camera.distance);
  glRotated(-90 - camera.elevation, 1, 0, 0);
  glRotated(90 - camera.azimuth, 0, 0, 1);
  glTranslated(0, 0, -0.3);
}

void shine(GLenum name, const mimo_light& light) {
  const auto color = [name](GLenum what, const float* rgb) {
    const float rgba[] = {rgb[0], rgb[1], rgb[2], 1};
    glLightfv(name, what, rgba);
  };
  const float *p = light.position, *d = light.direction;
  const float place[] = {light.directional ? -d[0] : p[0], light.directional ? -d[1] : p[1],
                         light.directional ? -d[2] : p[2], light.directional ? 0.0f : 1.0f};
  glLightfv(name, GL_POSITION, place);
  glLightfv(name, GL_SPOT_DIRECTION, d);
  glLightf(name, GL_SPOT_CUTOFF, light.directional ? 180 : light.cutoff);
  glLightf(name, GL_SPOT_EXPONENT, light.exponent);
  glLightf(name, GL_CONSTANT_ATTENUATION, light.attenuation[0]);
  glLightf(name, GL_LINEAR_ATTENUATION, light.attenuation[1]);
  glLightf(name, GL_QUADRATIC_ATTENUATION, light.attenuation[2]);
  color(GL_AMBIENT, light.ambient);
  color(GL_DIFFUSE, light.diffuse);
  color(GL_SPECULAR, light.specular);
}

// The world's lights, and the one that the camera carries; gives their number.
int set_lights(const mimo::Env& env) {
  GLenum name = GL_LIGHT0;
  const mimo_light headlight = env.light(MIMO_HEADLIGHT);
  if (headlight.active) {
    mimo_light carried = headlight;
    const float ahead[] = {0, 0, -1};
    std::copy(ahead, ahead + 3, carried.direction);
    glPushMatrix();
    glLoadIdentity();
    shine(name++, carried);
    glPopMatrix();
  }
  for (std::size_t i = 0; i < env.count(MIMO_LIGHT) && name < GL_LIGHT0 + 8; ++i) {
    const mimo_light light = env.light(static_cast<std::int32_t>(i));
    if (light.active) shine(name++, light);
  }
  return static_cast<int>(name - GL_LIGHT0);
}

// The matrix of a pose, column after column: position, and a quaternion w x y z.
void move(const float* pose) {
  const float w = pose[3], x = pose[4], y = pose[5], z = pose[6];
  const float matrix[16] = {1 - 2 * (y * y + z * z),
                            2 * (x * y + w * z),
                            2 * (x * z - w * y),
                            0,
                            2 * (x * y - w * z),
                            1 - 2 * (x * x + z * z),
                            2 * (y * z + w * x),
                            0,
                            2 * (x * z + w * y),
                            2 * (y * z - w * x),
                            1 - 2 * (x * x + y * y),
                            0,
                            pose[0],
                            pose[1],
                            pose[2],
                            1};
  glMultMatrixf(matrix);
}

void use(const mimo_appearance& material, const World& world) {
  const float* c = material.color;
  const float glow[] = {c[0] * material.emission, c[1] * material.emission, c[2] * material.emission, 1};
  const float shine[] = {material.specular, material.specular, material.specular, 1};
  glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, c);
  glMaterialfv(GL_FRONT, GL_EMISSION, glow);
  glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT, GL_SHININESS, 128 * material.shininess);
  if (material.texture >= 0) glBindTexture(GL_TEXTURE_2D, world.textures[static_cast<std::size_t>(material.texture)]);
  glUniform1i(glGetUniformLocation(world.program, "textured"), material.texture >= 0);
}

void draw(const World& world, const Camera& camera, int width, int height) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  look_from(camera, width, height);
  glUniform1i(glGetUniformLocation(world.program, "lights"), set_lights(world.env));
  for (const bool clear : {false, true}) {  // what can be looked through comes last
    clear ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
    for (std::size_t i = 0; i < world.shapes.size(); ++i) {
      const mimo_appearance& material = world.shapes[i].material;
      if (!material.visible || (material.color[3] < 1) != clear) continue;
      use(material, world);
      glPushMatrix();
      move(&world.poses[7 * i]);
      glCallList(world.shapes[i].list);
      glPopMatrix();
    }
  }
}

// ---- The window -------------------------------------------------------------------------------------------------

struct Hand {
  Camera camera;
  double x = 0, y = 0;
  bool paused = false, again = false;
};

Hand& hand_of(GLFWwindow* window) { return *static_cast<Hand*>(glfwGetWindowUserPointer(window)); }

void listen(GLFWwindow* window) {
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    Hand& hand = hand_of(w);
    if (glfwGetMouseButton(w, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
      hand.camera.azimuth -= 0.3 * (x - hand.x);
      hand.camera.elevation = std::max(-89.0, std::min(89.0, hand.camera.elevation - 0.3 * (y - hand.y)));
    }
    hand.x = x;
    hand.y = y;
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double up) {
    Hand& hand = hand_of(w);
    hand.camera.distance = std::max(0.3, std::min(10.0, hand.camera.distance * std::pow(0.9, up)));
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
    Hand& hand = hand_of(w);
    if (action == GLFW_PRESS && key == GLFW_KEY_SPACE) hand.paused = !hand.paused;
    if (action == GLFW_PRESS && key == GLFW_KEY_R) hand.again = true;
  });
}

void show(GLFWwindow* window, World& world) {
  Hand hand;
  glfwSetWindowUserPointer(window, &hand);
  listen(window);
  double last = glfwGetTime(), due = world.env.time();
  while (!glfwWindowShouldClose(window)) {
    const double now = glfwGetTime();
    if (hand.again) world.env.reset(world.block), due = 0;
    hand.again = false;
    if (!hand.paused) due += std::min(now - last, 0.1);  // who is slow does not try to catch up
    last = now;
    while (world.env.time() < due) world.step();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    draw(world, hand.camera, width, std::max(1, height));
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}

// ---- Beside the library's own picture ---------------------------------------------------------------------------

// Mean over all pixels of how far the two are apart, of 255.
double compare(World& world) {
  const Camera camera;
  for (int i = 0; i < 50; ++i) world.step();
  draw(world, camera, kWidth, kHeight);
  std::vector<std::uint8_t> ours(3 * kWidth * kHeight);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, ours.data());

  mimo_picture_config config = mimo::picture_config();
  config.width = kWidth;
  config.height = kHeight;
  config.look_at[0] = config.look_at[1] = 0;
  config.look_at[2] = 0.3;
  config.distance = camera.distance;
  config.azimuth = camera.azimuth;
  config.elevation = camera.elevation;
  const std::vector<mimo::Rgb> theirs = world.env.render(config).color.pixels;
  double sum = 0;
  for (int row = 0; row < kHeight; ++row) {  // OpenGL's first row is the lowest
    const std::uint8_t *here = &ours[3 * kWidth * (kHeight - 1 - row)], *there = &theirs[kWidth * row].r;
    for (int i = 0; i < 3 * kWidth; ++i) sum += std::abs(here[i] - there[i]);
  }
  return sum / (3 * kWidth * kHeight);
}

}  // namespace

int main(int argc, char** argv) try {
  const bool comparing = argc > 1 && std::strcmp(argv[argc - 1], "--compare") == 0;
  const char* const scene = argc > (comparing ? 2 : 1) ? argv[1] : "benchmark";
  World world(scene);
  if (!glfwInit()) {
    std::fprintf(stderr, "there is no display to open a window on\n");
    return 77;
  }
  glfwWindowHint(GLFW_SAMPLES, 4);
  glfwWindowHint(GLFW_VISIBLE, comparing ? GLFW_FALSE : GLFW_TRUE);
  GLFWwindow* const window = glfwCreateWindow(kWidth, kHeight, scene, nullptr, nullptr);
  if (window == nullptr) {
    std::fprintf(stderr, "OpenGL cannot be used here\n");
    return 77;
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  world.upload();
  double apart = 0;
  if (comparing) {
    apart = compare(world);
    std::printf("%s: %.2f of 255 from the library's picture\n", scene, apart);
  } else {
    show(window, world);
  }
  glfwTerminate();
  return apart < 2 ? 0 : 1;
} catch (const mimo::Exception& error) {
  std::fprintf(stderr, "%s: %s\n", mimo_status_name(error.status()), error.what());
  return 1;
}
