// The scenario of tests/capi/same.c, which gives the same hashes in every language.
#include <cstdio>
#include <mimo/mimo.hpp>

namespace {

constexpr std::uint64_t kStart = 14695981039346656037U;

std::uint64_t hash_of(std::uint64_t hash, const void* bytes, std::size_t count) {  // FNV-1a
  const auto* const at = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < count; ++i) hash = (hash ^ at[i]) * 1099511628211U;
  return hash;
}

std::uint64_t hash_of(std::uint64_t hash, const mimo::Block& block) {
  return hash_of(hash, block.data(), block.bytes());
}

template <typename T>
std::uint64_t hash_of(std::uint64_t hash, const std::vector<T>& numbers) {
  return hash_of(hash, numbers.data(), numbers.size() * sizeof(T));
}

// The task "own" of tests/capi/same.c.
class Height : public mimo::Task {
 public:
  std::vector<std::string> terms() const override { return {"height", "effort"}; }
  std::vector<mimo::TaskField> fields() const override {
    return {mimo::TaskField("desired_goal", {}, "m", "world"), mimo::TaskField("achieved_goal", {}, "m", "world")};
  }
  std::size_t memory_bytes() const override { return sizeof(double); }

  void reset(mimo::Env& env, const mimo_task_moment& moment) override {
    double& height = *static_cast<double*>(moment.memory);
    height = 0.2 + 0.2 * env.random(1)[0];
    moment.fields[0] = static_cast<float>(height);
  }
  void evaluate(mimo::Env& env, const mimo_task_moment& moment, mimo_task_verdict& verdict) override {
    const double height = *static_cast<double*>(moment.memory);
    const double hand = env.get_values(MIMO_BODY_POSITION, {env.find(MIMO_BODY, "left_hand")})[2];
    double effort = 0;
    for (std::size_t i = 0; i < moment.action_count; ++i)
      effort += static_cast<double>(moment.action[i]) * moment.action[i];
    verdict.terms[0] = hand - height;
    verdict.terms[1] = -0.01 * effort;
    moment.fields[1] = static_cast<float>(hand);
    verdict.outcome = hand > height ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
    verdict.goes_on = 1;
  }
};

mimo::Env make_own(mimo::Task& task) {
  mimo_scene_config room = mimo::scene_config();
  room.name = "benchmark";
  mimo::Scene scene(room);
  mimo_agent_config infant = scene.default_agent();
  infant.vision = 0;
  scene.add_agent(infant);
  scene.set_task(task);
  return mimo::Env(scene);
}

void run(const std::string& scene) {
  Height task;
  mimo::Env env = scene == "own" ? make_own(task) : mimo::make(scene);
  mimo::Block block = env.make_block();
  std::vector<float> actions(env.layout().info().actions);
  env.reset(7, block);
  std::uint64_t hash = hash_of(kStart, block);
  double sum = 0;
  for (std::size_t step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      actions[i] = static_cast<float>(static_cast<int>((7 * step + 3 * i) % 21) - 10) / 10.0F;
    }
    sum += env.step(actions, block).at(0).reward;
    hash = hash_of(hash, block);
  }
  std::printf("%s %016llx %.6f\n", scene.c_str(), static_cast<unsigned long long>(hash), sum);
}

// The picture of tests/capi/same.c.
mimo::Stage make_stage() {
  const std::int32_t forms[2] = {MIMO_FORM_PLANE, MIMO_FORM_SPHERE}, materials[2] = {0, -1}, first = 0, two = 2;
  const std::int32_t flat = MIMO_TEXTURE_FLAT, sun = MIMO_LAMP_SUN;
  const double sizes[6] = {0, 0, 0, 0.5, 0, 0};
  const float colors[8] = {1, 1, 1, 1, 0.9F, 0.2F, 0.1F, 1}, white[4] = {1, 1, 1, 1};
  const std::uint8_t pixels[12] = {200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130}, coded = 1;
  auto geoms = mimo::stage_struct<mimo_stage_shapes>();
  geoms.object_type = 5;
  geoms.count = 2;
  geoms.forms = forms;
  geoms.sizes = sizes;
  geoms.colors = colors;
  geoms.materials = materials;
  auto textures = mimo::stage_struct<mimo_stage_textures>();
  textures.count = 1;
  textures.types = &flat;
  textures.widths = textures.heights = &two;
  textures.pixels = pixels;
  textures.pixel_bytes = sizeof pixels;
  textures.srgb = &coded;
  auto paints = mimo::stage_struct<mimo_stage_materials>();
  paints.count = 1;
  paints.colors = white;
  paints.textures = &first;
  auto lights = mimo::stage_struct<mimo_stage_lights>();
  lights.count = 1;
  lights.types = &sun;
  auto config = mimo::stage_struct<mimo_stage_config>();
  config.geoms = &geoms;
  config.textures = &textures;
  config.materials = &paints;
  config.lights = &lights;
  return mimo::Stage(config);
}

void draw_stage() {
  const double places[6] = {0, 0, 0, 0, 0, 0.5}, above[3] = {0, 0, 4}, lamp[3] = {0, 0, 5},
               direction[3] = {0, 0.6, -0.8};
  const double turns[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  constexpr std::size_t kWidth = 64, kHeight = 48, kPixels = kWidth * kHeight;
  std::vector<std::uint8_t> rgb(3 * kPixels);
  std::vector<float> depth(kPixels);
  std::vector<std::int32_t> objects(2 * kPixels);
  auto poses = mimo::stage_struct<mimo_stage_poses>();
  poses.geom_count = 2;
  poses.geom_positions = places;
  poses.geom_rotations = turns;
  poses.light_count = 1;
  poses.light_positions = lamp;
  poses.light_directions = direction;
  mimo_stage_view view = mimo::stage_view();
  view.width = kWidth;
  view.height = kHeight;
  view.position = above;
  view.rotation = turns;
  view.rgb = rgb.data();
  view.rgb_bytes = rgb.size();
  view.depth = depth.data();
  view.depth_count = depth.size();
  view.segmentation = objects.data();
  view.segmentation_count = objects.size();
  make_stage().draw(poses, view);
  const std::uint64_t hash = hash_of(hash_of(hash_of(kStart, rgb), depth), objects);
  double sum = 0;
  for (const std::uint8_t level : rgb) sum += level;
  std::printf("stage %016llx %.6f\n", static_cast<unsigned long long>(hash), sum);
}

}  // namespace

int main() {
  for (const char* scene : {"reach", "standup", "selfbody", "benchmark", "own"}) run(scene);
  draw_stage();
}
