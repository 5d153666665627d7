// mimo render: one picture of a scene's initial state.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/picture.h"
#include "cli/touch_picture.h"
#include "programs/files.h"
#include "programs/world.h"

namespace cli {
namespace {

struct RenderOptions {
  WorldOptions world;
  std::string camera;
  std::uint32_t width = 640, height = 480;
  std::vector<double> look_at;
  std::optional<double> distance, azimuth, elevation;
  std::string out, depth, segmentation;
};

bool is_png(const std::string& path) { return has_ending(path, ".png"); }

mimo_picture_config view(mimo::Env& env, const RenderOptions& options) {
  auto config = overview(env, options.width, options.height);
  if (!options.camera.empty()) {
    config.camera = options.camera.c_str();
    config.fovy = 0;  // the camera's own
  }
  std::copy(options.look_at.begin(), options.look_at.end(), config.look_at);
  config.distance = options.distance.value_or(config.distance);
  config.azimuth = options.azimuth.value_or(config.azimuth);
  config.elevation = options.elevation.value_or(config.elevation);
  config.foveation = options.world.foveation;
  return config;
}

// The field of an infant's own eye, where it is that which is to be drawn: as old as the infant is. "" for others.
std::string eye_of(const RenderOptions& options) {
  const bool grown = options.world.age.age || options.world.age.physiological_age;
  const std::size_t start = options.camera.rfind('/') + 1;  // behind the infant's name
  const std::string name = options.camera.substr(start);
  if (!grown || !options.world.age.eyes || (name != "eye_left" && name != "eye_right")) return "";
  return options.camera.substr(0, start) + "vision/" + name;
}

void render(RenderOptions options) {
  const std::string eye = eye_of(options);
  if (!eye.empty()) {
    options.world.vision.clear();
    options.world.eye_width = options.width;
    options.world.eye_height = options.height;
  }
  for (const std::string& path : {options.out, options.depth, options.segmentation}) {
    if (!path.empty()) require_writable(path);
  }
  mimo::Env env = open_world(options.world, make_env_config());
  mimo::Block block = env.make_block();
  env.reset(options.world.seed, block);
  const auto config = view(env, options);
  mimo::Pictures seen = env.render(config, MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION);
  if (!eye.empty()) seen.color = picture_in(env.layout().field(eye), block);
  const Picture<float>& depth = seen.depth;
  const Picture<std::int32_t>& ids = seen.segmentation;

  TouchPicture touch(env);
  write_png(options.out, touch.possible() ? touch.draw(env, config, block) : seen.color);
  if (!options.depth.empty()) {
    is_png(options.depth) ? write_png(options.depth, millimetres(depth, ids)) : write_npy(options.depth, depth);
  }
  if (!options.segmentation.empty()) {
    is_png(options.segmentation) ? write_png(options.segmentation, color_coded(ids))
                                 : write_npy(options.segmentation, ids);
  }
}

void add_camera_options(CLI::App& command, RenderOptions& options) {
  CLI::Option* camera =
      command.add_option("--camera", options.camera, "Camera of the model, such as eye_left. Default: a free one")
          ->option_text("NAME");
  const std::vector<CLI::Option*> free = {
      command.add_option("--look-at", options.look_at, "The point in the middle, metres")
          ->expected(3)
          ->check(number(-1e6, 1e6))
          ->option_text("X Y Z"),
      command.add_option("--distance", options.distance, "From that point, metres")
          ->check(number(1e-3, 1e6))
          ->option_text("M"),
      command.add_option("--azimuth", options.azimuth, "Degrees; 0 looks along +x, 90 along +y")
          ->check(number(-1e6, 1e6))
          ->option_text("DEG"),
      command.add_option("--elevation", options.elevation, "Degrees; negative looks down")
          ->check(number(-1e6, 1e6))
          ->option_text("DEG")};
  for (CLI::Option* option : free)
    option->group("Free camera. Default: shows the infants and their surroundings")->excludes(camera);
}

void add_size_option(CLI::App& command, const std::string& name, std::uint32_t& value) {
  command.add_option(name, value, "Pixels, 1 to 4096")
      ->type_name("N")
      ->check(count(mimo::ranges::picture_config::width))
      ->capture_default_str();
}

}  // namespace

void add_render(CLI::App& program) {
  auto options = std::make_shared<RenderOptions>();
  options->world.vision = "off";  // no eyes: only the camera asked for is drawn
  options->world.touch = "off";
  CLI::App* command = program.add_subcommand("render", "Draw one picture of a scene as it starts");
  add_scene_options(*command, options->world);
  add_maturity_options(*command, options->world.age);
  add_camera_options(*command, *options);
  add_size_option(*command, "--width", options->width);
  add_size_option(*command, "--height", options->height);
  add_foveation_option(*command, options->world);
  add_renderer_option(*command, options->world);
  add_touch_option(*command, options->world);
  add_face_option(*command, options->world);
  add_seed_option(*command, options->world);
  command->add_option("--out", options->out, "The picture, a PNG file")
      ->type_name("FILE.png")
      ->check(CLI::Validator(ends_in({".png"}), ""))
      ->required();
  command
      ->add_option("--depth", options->depth,
                   "Depth along the camera's axis: a .png of 16-bit millimetres, 0 for\n"
                   "nothing or more than 65.5 m; a .npy of NumPy's: float32 metres")
      ->type_name("FILE")
      ->check(CLI::Validator(ends_in({".png", ".npy"}), ""));
  command
      ->add_option("--segmentation", options->segmentation,
                   "The geom that each pixel shows: a .png of colours, black for none;\n"
                   "a .npy of NumPy's: int32 ids, -1 for none")
      ->type_name("FILE")
      ->check(CLI::Validator(ends_in({".png", ".npy"}), ""));
  command->footer(
      "Examples:\n"
      "  mimo render --out scene.png\n"
      "  mimo render --camera eye_left --width 512 --height 512 --out left.png --depth left.npy\n"
      "  mimo render --scene my_room.xml --body mitten --touch 0.5 --out felt.png\n"
      "  mimo render --look-at 0 0 0.77 --distance 0.5 --azimuth 180 --elevation 0 --face enjoyment --out face.png");
  command->callback([options] { render(*options); });
}

}  // namespace cli
