// Everything that libmimo can do with one foreign model: the file is loaded and simulated with an agent that has skin,
// shoved about, touched by a ball, and drawn; then once more with an infant in it. What happened is told line by line,
// a word and what belongs to it, so that the last line names the stage in which a crash came. zoo.py runs it on many
// files.
//
//   zoo_visit FILE    0: went well; 1: something was wrong that is no crash; 3: the model was refused
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mimo/mimo.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int kSteps = 100, kShoveEvery = 10;  // with an infant a fifth of the steps
constexpr std::uint32_t kPixels = 128;
using Random = std::mt19937;

void tell(const char* word, const std::string& what) {
  std::printf("%s %s\n", word, what.c_str());
  std::fflush(stdout);
}

int refuse(const mimo::Exception& error) {
  tell("refused", std::string(mimo_status_name(error.status())) + ": " + error.what());
  return error.status() == MIMO_E_INTERNAL ? 1 : 3;
}

mimo::Scene load(const char* file) {
  auto config = mimo::scene_config();
  config.file = file;
  return mimo::Scene(config);
}

// The body, child of the world, to which the first joint belongs; all bodies where it has no name or nothing moves.
std::string root_of(const mimo::Env& env) {
  if (env.count(MIMO_JOINT) == 0) return "world";
  std::int32_t body = env.body_of(MIMO_JOINT, 0);
  for (std::int32_t parent = body; parent != 0; parent = env.body_of(MIMO_BODY, body)) body = parent;
  const std::string found = env.name(MIMO_BODY, body);
  return found.empty() ? "world" : found;
}

// Where the model is: the box around the frames of its bodies, and how large it is.
struct Extent {
  double low[3], high[3], size;
  double middle(int axis) const { return (low[axis] + high[axis]) / 2; }
};

Extent extent_of(const mimo::Env& env) {
  const auto places = env.get_values(MIMO_BODY_POSITION, env.ids(MIMO_BODY));
  Extent extent = {{0, 0, 0}, {0, 0, 0}, 0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    extent.low[i % 3] = std::min(extent.low[i % 3], places[i]);
    extent.high[i % 3] = std::max(extent.high[i % 3], places[i]);
  }
  for (int axis = 0; axis < 3; ++axis) extent.size = std::max(extent.size, extent.high[axis] - extent.low[axis]);
  extent.size = std::max(extent.size, 0.2);  // a single body
  return extent;
}

std::vector<float> draw_actions(const mimo::Env& env, Random& random) {
  std::vector<float> actions;
  for (const mimo_action& action : env.layout().actions()) {
    const double from = std::max(action.low, -10.0), to = std::min(action.high, 10.0);
    const double drawn = from < to ? std::uniform_real_distribution<double>(from, to)(random) : action.low;
    actions.push_back(static_cast<float>(drawn));
  }
  return actions;
}

// Pushes one body with some times its own weight, and lets go of the one before.
void shove(mimo::Env& env, std::int32_t& pushed, Random& random) {
  const auto bodies = static_cast<std::int32_t>(env.count(MIMO_BODY));
  if (bodies < 2) return;
  if (pushed > 0) env.set_values(MIMO_BODY_FORCE, {pushed}, {0, 0, 0, 0, 0, 0});
  pushed = std::uniform_int_distribution<std::int32_t>(1, bodies - 1)(random);
  const double weight = 9.81 * env.get_values(MIMO_BODY_MASS, {pushed})[0];
  std::uniform_real_distribution<double> times(-5, 5);
  env.set_values(MIMO_BODY_FORCE, {pushed},
                 {weight * times(random), weight * times(random), weight * times(random), 0, 0, 0});
}

// A ball that touches the skin wherever it is put.
struct Ball {
  static constexpr const char* kName = "zoo_ball";
  double radius;

  void add_to(mimo::Scene& scene) const {
    auto object = mimo::object_config();
    object.name = kName;
    object.size[0] = radius;
    object.position[2] = -100 * radius;
    scene.add_object(object);
  }
};

// A vector of a body's frame in the world's.
mimo::Vector rotate(const std::vector<double>& quaternion, const mimo::Vector& vector) {
  const double w = quaternion[0], *axis = quaternion.data() + 1;
  mimo::Vector cross, turned;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    cross[i] = axis[j] * vector[k] - axis[k] * vector[j] + w * vector[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    turned[i] = vector[i] + 2 * (axis[j] * cross[k] - axis[k] * cross[j]);
  }
  return turned;
}

// Presses the ball half its radius deep into the skin at some sensor, at rest.
void poke(mimo::Env& env, const std::vector<mimo::Receptor>& skin, const Ball& ball, Random& random) {
  if (skin.empty()) return;
  const mimo::Receptor& sensor = skin[std::uniform_int_distribution<std::size_t>(0, skin.size() - 1)(random)];
  auto place = env.get_values(MIMO_BODY_POSITION, {sensor.body});
  mimo::Vector local;
  for (std::size_t i = 0; i < 3; ++i) local[i] = sensor.position[i] + 0.5 * ball.radius * sensor.normal[i];
  const mimo::Vector offset = rotate(env.get_values(MIMO_BODY_ORIENTATION, {sensor.body}), local);
  for (std::size_t i = 0; i < 3; ++i) place[i] += offset[i];
  const std::int32_t body = env.find(MIMO_BODY, Ball::kName);
  env.set_values(MIMO_BODY_POSITION, {body}, place);
  env.set_values(MIMO_JOINT_VELOCITY, {env.find(MIMO_JOINT, Ball::kName)}, {0, 0, 0, 0, 0, 0});
}

// The receptors of the agent's touch; none where it has no skin.
std::vector<mimo::Receptor> skin_of(const mimo::Env& env) {
  for (const mimo_field& field : env.layout().fields()) {
    if (field.receptors > 0) return env.layout().receptors(field.name);
  }
  return {};
}

struct Seen {
  int diverged = 0, touched = 0, contacts = 0;
  std::string broken;  // a field that holds what is no number
};

template <typename T>
void look_at(const mimo_field& field, const mimo::Block& block, Seen& seen) {
  bool felt = false;
  for (const T value : block.view<T>(field)) {
    if (!std::isfinite(static_cast<double>(value))) seen.broken = field.name;
    felt = felt || value != 0;
  }
  seen.touched += felt && std::string(field.name).find("touch/force") != std::string::npos;
}

void look_at(const std::vector<mimo_field>& fields, const mimo::Block& block, Seen& seen) {
  for (const mimo_field& field : fields) {
    if (field.dtype == MIMO_F32) look_at<float>(field, block, seen);
    if (field.dtype == MIMO_F64) look_at<double>(field, block, seen);
  }
}

// Many models fly apart under random actions. That is no defect, if the library says so and starts anew.
Seen move(mimo::Env& env, int steps, const Ball* ball) {
  Seen seen;
  Random random(1);
  auto block = env.make_block();
  const auto fields = env.layout().fields();
  const auto skin = skin_of(env);
  std::int32_t pushed = 0;
  env.reset(1, block);
  for (int step = 0; step < steps; ++step) {
    try {
      if (step % kShoveEvery == 0) shove(env, pushed, random);
      if (step % kShoveEvery == 1 && ball != nullptr) poke(env, skin, *ball, random);
      env.step(draw_actions(env, random), block);
    } catch (const mimo::Exception& error) {
      if (error.status() != MIMO_E_SIMULATION) throw;
      ++seen.diverged;
      env.reset(1, block);
    }
    look_at(fields, block, seen);
    seen.contacts += env.contact_count() > 0;
  }
  return seen;
}

// From all cameras that have a name, and from outside.
int draw_all(mimo::Env& env, const Extent& extent) {
  constexpr std::uint32_t kAll = MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION;
  int pictures = 0;
  auto config = mimo::picture_config();
  config.width = config.height = kPixels;
  for (const std::int32_t camera : env.ids(MIMO_CAMERA)) {
    const std::string called = env.name(MIMO_CAMERA, camera);
    if (called.empty()) continue;
    config.camera = called.c_str();
    env.render(config, kAll);
    ++pictures;
  }
  config.camera = nullptr;
  for (int axis = 0; axis < 3; ++axis) config.look_at[axis] = extent.middle(axis);
  config.distance = 1.5 * extent.size;
  config.elevation = -20;
  for (const double azimuth : {30.0, 210.0}) {
    config.azimuth = azimuth;
    env.render(config, kAll);
    ++pictures;
  }
  return pictures;
}

// By rays; by OSMesa where they cannot, and why they cannot.
mimo::Env make(const mimo::Scene& scene) {
  auto config = mimo::env_config();
  config.renderer = "ray";
  try {
    return mimo::Env(scene, config);
  } catch (const mimo::Exception& error) {
    if (error.status() != MIMO_E_UNSUPPORTED) throw;
    tell("no_rays", error.what());
    config.renderer = "osmesa";
    return mimo::Env(scene, config);
  }
}

void report(const Seen& seen) {
  tell("contacts", std::to_string(seen.contacts));
  tell("touched", std::to_string(seen.touched));
  tell("diverged", std::to_string(seen.diverged));
  if (!seen.broken.empty()) tell("wrong", seen.broken + " is not finite");
}

// With skin all over; an agent without anything that can touch has none.
void visit(mimo::Scene& scene, const std::string& root, const Extent& extent, int steps) {
  const Ball ball{extent.size / 20};
  auto agent = mimo::agent_config();
  agent.body = "scene";
  agent.root = root.c_str();
  agent.vestibular_at = root.c_str();
  agent.vision = 0;
  scene.add_agent(agent);
  scene.set_touch(extent.size / 20);
  ball.add_to(scene);
  tell("stage", "compile with an agent");
  mimo::Env env = make(scene);
  tell("sensors", std::to_string(skin_of(env).size()));
  tell("stage", "step");
  report(move(env, steps, &ball));
  tell("stage", "draw");
  tell("pictures", std::to_string(draw_all(env, extent)));
}

// The same model as somebody's room.
void visit_with_infant(const char* file, const Extent& extent, int steps) {
  mimo::Scene scene = load(file);
  auto infant = mimo::agent_config();
  infant.name = "infant";
  infant.vision_width = infant.vision_height = kPixels / 2;
  infant.place = MIMO_PLACE_LOWEST;
  for (int axis = 0; axis < 2; ++axis) infant.position[axis] = extent.middle(axis);
  infant.position[2] = extent.high[2] + 0.5;
  scene.add_agent(infant);
  mimo::Env env = make(scene);
  tell("stage", "step with an infant");
  const Seen seen = move(env, steps / 5, nullptr);
  if (!seen.broken.empty()) tell("wrong", seen.broken + " is not finite with an infant");
  tell("infant", "ok");
}

int run(const char* file, int steps) {
  tell("stage", "load");
  mimo::Scene scene = load(file);
  tell("stage", "compile");
  auto blind = mimo::env_config();
  blind.renderer = "none";
  std::string root;
  Extent extent;
  {
    const mimo::Env env(scene, blind);
    root = root_of(env);
    extent = extent_of(env);
  }
  tell("root", root);
  visit(scene, root, extent, steps);
  tell("stage", "with an infant");
  try {
    visit_with_infant(file, extent, steps);
  } catch (const mimo::Exception& error) {
    if (error.status() == MIMO_E_INTERNAL) throw;
    tell("infant", std::string(mimo_status_name(error.status())) + ": " + error.what());
  }
  tell("done", "");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: zoo_visit FILE [STEPS]\n");
    return 2;
  }
  try {
    return run(argv[1], argc > 2 ? std::atoi(argv[2]) : kSteps);
  } catch (const mimo::Exception& error) {
    return refuse(error);
  }
}
