// mimo export: a scene or a recording as a file for other programs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <optional>

#include "cli/adapter.h"
#include "cli/commands.h"
#include "cli/glb.h"
#include "cli/page.h"
#include "fmi/unit_file.h"
#include "programs/files.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/world.h"

namespace cli {
namespace {

using Json = Glb::Json;

// What the Python package writes: an option, the package's extra, and what the command needs besides.
struct OfPython {
  const char *option, *type, *what, *extra, *rest;
};

constexpr OfPython kOfPython[] = {
    {"--usd", "FILE", "USD", "usd", "--scene SCENE"},
    {"--nwb", "FILE.nwb", "Neurodata Without Borders, of a recording", "nwb", "run.h5"},
    {"--bids-motion", "FOLDER", "BIDS with motion, of a recording", "bids", "run.h5"},
    {"--csv", "FOLDER", "Tables by field, of a recording", "bids", "run.h5"},
    {"--wav", "FOLDER", "Sounds by field, of a recording", "bids", "run.h5"},
    {"--mp4", "FOLDER", "Films by field, of a recording", "video", "run.h5"},
};

// What shapes alone have no use for.
constexpr const char* kOfUnits[] = {"--vision",         "--renderer",  "--samples", "--effects",
                                    "--render-threads", "--foveation", "--touch",   "--senses",
                                    "--reflexes",       "--outputs",   "--fmi"};
constexpr const char* kOfWorlds[] = {
    "--body",   "--age",    "--physiological-age", "--sex",  "--percentile", "--z-length", "--z-weight",
    "--z-head", "--growth", "--actuation",         "--face", "--seed"};
constexpr const char* kOfShapes[] = {"--seconds", "--segments"};

struct ExportOptions {
  UnitOptions unit;
  PageOptions page;
  std::string gltf, fmu, recording;
  std::array<std::string, std::size(kOfPython)> of_python;
  double seconds = 0;
  std::uint32_t segments = 24;
};

// Poses as glTF has them: a place, and a quaternion x y z w.
struct Pose {
  std::array<float, 3> place;
  std::array<float, 4> rotation;
};

// Rounding may leave a little more than 1, which glTF does not allow.
float part(double value) { return static_cast<float>(std::clamp(value, -1.0, 1.0)); }

Pose pose_at(const std::vector<float>& poses, std::int32_t id) {
  const float* p = &poses[7 * static_cast<std::size_t>(id)];
  return {{p[0], p[1], p[2]}, {part(double(p[3])), part(double(p[4])), part(double(p[5])), part(double(p[6]))}};
}

using Four = std::array<double, 4>;

Four product(const Four& a, const Four& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
          a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

// What is in `frame`, seen from there.
Pose within(const Pose& frame, const Pose& pose) {
  const auto& f = frame.rotation;
  const Four back = {-f[0], -f[1], -f[2], f[3]};
  const Four there = {f[0], f[1], f[2], f[3]};
  const auto& q = pose.rotation;
  Four offset{};
  for (std::size_t i = 0; i < 3; ++i) offset[i] = double(pose.place[i]) - double(frame.place[i]);
  const Four place = product(product(back, offset), there);
  const Four turn = product(back, {q[0], q[1], q[2], q[3]});
  return {{float(place[0]), float(place[1]), float(place[2])},
          {part(turn[0]), part(turn[1]), part(turn[2]), part(turn[3])}};
}

// Colours of MuJoCo's are as screens have them (sRGB), glTF's factors are linear.
double linear(float value) {
  const double coded = std::clamp(double(value), 0.0, 1.0);
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

// Phong's exponent n is a roughness of sqrt(2 / (n + 2)), as the viewer in the browser has it (mimo/view/glb.py).
double roughness(const mimo_appearance& look) {
  constexpr double kSmoothest = 0.2, kRoughest = 0.9;
  if (look.specular == 0) return kRoughest;
  return std::clamp(std::sqrt(2.0 / (128.0 * double(look.shininess) + 2.0)), kSmoothest, kRoughest);
}

class GltfScene {
 public:
  GltfScene(const mimo::Env& env, std::uint32_t segments) : env_(env), segments_(segments) {
    const std::vector<float> bodies = env.poses(MIMO_BODY, MIMO_AXES_GLTF);
    const std::vector<float> geoms = env.poses(MIMO_GEOM, MIMO_AXES_GLTF);
    std::map<std::int32_t, Json> children;
    for (const std::int32_t geom : env.ids(MIMO_GEOM)) {
      const mimo_appearance look = env.appearance(geom);
      if (look.visible == 0) continue;
      const std::int32_t body = env.body_of(MIMO_GEOM, geom);
      Json node = placed(name_of(MIMO_GEOM, geom, "geom:"), within(pose_at(bodies, body), pose_at(geoms, geom)));
      node["mesh"] = add_mesh(geom, look);
      children[body].push_back(file_.add("nodes", std::move(node)));
    }
    Json roots = Json::array();
    for (auto& [body, nodes] : children) {
      Json node = placed(name_of(MIMO_BODY, body, "body:"), pose_at(bodies, body));
      node["children"] = nodes;
      nodes_[body] = file_.add("nodes", std::move(node));
      roots.push_back(nodes_[body]);
    }
    file_.add("scenes", {{"name", env.task()}, {"nodes", roots}});
  }

  // Where the bodies are at this time.
  void keep(double time) {
    times_.push_back(static_cast<float>(time));
    env_poses_.push_back(env_.poses(MIMO_BODY, MIMO_AXES_GLTF));
  }

  void write(const std::string& path) {
    if (times_.size() > 1) animate();
    file_.write(path);
  }

 private:
  std::string name_of(std::int32_t kind, std::int32_t id, const char* otherwise) const {
    const std::string name = env_.name(kind, id);
    return name.empty() ? otherwise + std::to_string(id) : name;
  }

  static Json placed(const std::string& name, const Pose& pose) {
    return {{"name", name}, {"translation", pose.place}, {"rotation", pose.rotation}};
  }

  std::size_t add_mesh(std::int32_t geom, const mimo_appearance& look) {
    const mimo::Mesh mesh = env_.mesh(geom, MIMO_AXES_GLTF, segments_);
    Json attributes = {{"POSITION", file_.add_floats(mesh.positions, 3, true)},
                       {"NORMAL", file_.add_floats(mesh.normals, 3, true)}};
    if (look.texture >= 0) {
      attributes["TEXCOORD_0"] = file_.add_floats(with_margins(mesh.texcoords, env_.texture(look.texture)), 2, true);
    }
    const Json triangles = {
        {"attributes", attributes}, {"indices", file_.add_indices(mesh.indices)}, {"material", add_material(look)}};
    return file_.add("meshes", {{"name", name_of(MIMO_GEOM, geom, "geom:")}, {"primitives", Json::array({triangles})}});
  }

  // Geoms that look alike share one.
  std::size_t add_material(const mimo_appearance& look) {
    std::string key(reinterpret_cast<const char*>(&look), sizeof look);
    const auto found = materials_.find(key);
    if (found != materials_.end()) return found->second;
    const float* rgba = look.color;
    Json surface = {{"baseColorFactor", {linear(rgba[0]), linear(rgba[1]), linear(rgba[2]), rgba[3]}},
                    {"metallicFactor", 0},
                    {"roughnessFactor", roughness(look)}};
    Json material = {{"name", "material:" + std::to_string(materials_.size())}};
    const auto shine = [&](int k) { return linear(rgba[k] * look.emission); };
    if (look.emission > 0) material["emissiveFactor"] = {shine(0), shine(1), shine(2)};
    if (look.texture >= 0) {
      const Json texture = {{"index", add_texture(look.texture)}};
      surface["baseColorTexture"] = texture;
      if (look.emission > 0) material["emissiveTexture"] = texture;
    }
    material["pbrMetallicRoughness"] = std::move(surface);
    if (rgba[3] < 1) material["alphaMode"] = "BLEND";
    return materials_[key] = file_.add("materials", std::move(material));
  }

  std::size_t add_texture(std::int32_t id) {
    const auto found = textures_.find(id);
    if (found != textures_.end()) return found->second;
    return textures_[id] = file_.add_texture(with_margins(env_.texture(id)), "texture:" + std::to_string(id));
  }

  // Of bodies that move. A quaternion is also its negative: the one nearer to that before it.
  void animate() {
    Json channels = Json::array(), samplers = Json::array();
    const std::size_t input = file_.add_floats(times_, 1);
    const auto add = [&](std::size_t node, const char* path, const std::vector<float>& values, std::size_t width) {
      samplers.push_back({{"input", input}, {"output", file_.add_floats(values, width)}});
      channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    };
    for (const auto& [body, node] : nodes_) {
      std::vector<float> places, rotations;
      bool moves = false;
      std::array<float, 4> before = pose_at(env_poses_.front(), body).rotation;
      for (const std::vector<float>& poses : env_poses_) {
        Pose pose = pose_at(poses, body);
        float along = 0;
        for (std::size_t i = 0; i < 4; ++i) along += before[i] * pose.rotation[i];
        for (float& number : pose.rotation) number = along < 0 ? -number : number;
        before = pose.rotation;
        places.insert(places.end(), pose.place.begin(), pose.place.end());
        rotations.insert(rotations.end(), pose.rotation.begin(), pose.rotation.end());
        const std::size_t first = 7 * static_cast<std::size_t>(body);
        moves = moves || !std::equal(poses.begin() + static_cast<std::ptrdiff_t>(first),
                                     poses.begin() + static_cast<std::ptrdiff_t>(first + 7),
                                     env_poses_.front().begin() + static_cast<std::ptrdiff_t>(first));
      }
      if (!moves) continue;
      add(node, "translation", places, 3);
      add(node, "rotation", rotations, 4);
    }
    if (!channels.empty())
      file_.add("animations", {{"name", "movement"}, {"channels", channels}, {"samplers", samplers}});
  }

  const mimo::Env& env_;
  std::uint32_t segments_;
  Glb file_;
  std::map<std::int32_t, std::size_t> nodes_;  // of bodies
  std::map<std::string, std::size_t> materials_;
  std::map<std::int32_t, std::size_t> textures_;
  std::vector<float> times_;
  std::vector<std::vector<float>> env_poses_;
};

template <std::size_t kCount>
void refuse(const CLI::App& command, const char* const (&names)[kCount], const std::string& with) {
  for (const char* name : names) {
    if (command.count(name) > 0) throw Failure(std::string(name) + " has no effect with " + with);
  }
}

// Options as they were given, for the unit, which reads them again.
template <std::size_t kCount>
void add_given(const CLI::App& command, const char* const (&names)[kCount], std::vector<std::string>& words) {
  for (const char* name : names) {
    if (command.count(name) == 0) continue;
    words.emplace_back(name);
    const std::vector<std::string> given = command.get_option(name)->as<std::vector<std::string>>();
    words.insert(words.end(), given.begin(), given.end());
  }
}

void export_unit(const ExportOptions& options, const CLI::App& command) {
  refuse(command, kOfShapes, "--fmu");
  std::vector<std::string> words;
  add_given(command, kOfWorlds, words);
  add_given(command, kOfUnits, words);
  write_unit(options.fmu, options.unit, words, unit_adapter());
}

void export_page(const ExportOptions& options, const CLI::App& command) {
  for (const CLI::Option* other : command.get_options()) {
    const std::string name = other->get_name();
    if (other->count() > 0 && name != "--html" && name != "--page" && name != "recording") {
      throw Failure(name + " has no effect with --html, which writes a recording as it is");
    }
  }
  if (options.recording.empty()) throw CLI::RequiredError("--html: the recording, FILE.h5,");
  write_page(options.page, options.recording);
}

void export_scene(const ExportOptions& options, const CLI::App& command) {
  for (std::size_t i = 0; i < std::size(kOfPython); ++i) {
    const OfPython& it = kOfPython[i];
    if (options.of_python[i].empty()) continue;
    throw Failure(std::string(it.option) + " is written by the Python package: pip install 'mimo[" + it.extra +
                  "]', then python -m mimo.export " + it.option + ' ' + options.of_python[i] + ' ' +
                  (options.recording.empty() ? it.rest : options.recording));
  }
  if (!options.page.out.empty()) return export_page(options, command);
  if (!options.page.without.empty()) {
    throw Failure("--page is for --html, the page to be written: --html FILE.html run.h5 is missing");
  }
  if (!options.gltf.empty() && !options.fmu.empty()) throw Failure("--gltf and --fmu are two files; give one of them");
  if (options.gltf.empty() && options.fmu.empty()) throw CLI::RequiredError("--gltf, --fmu or --html");
  if (!options.recording.empty()) {
    throw Failure((options.fmu.empty() ? "--gltf" : "--fmu") + std::string(" writes a scene, not the recording ") +
                  options.recording);
  }
  if (!options.fmu.empty()) return export_unit(options, command);
  refuse(command, kOfUnits, "--gltf");
  require_writable(options.gltf);
  WorldOptions asked = options.unit.world;
  asked.touch = "off";
  mimo::Env env = open_bare_world(asked, make_env_config());
  mimo::Block block = env.make_block();
  env.reset(asked.seed, block);
  GltfScene scene(env, options.segments);
  RandomActions random(env, asked.seed);
  const double step = env.timestep() * env.frame_skip();
  const auto steps = static_cast<std::uint64_t>(std::llround(options.seconds / step));
  mimo::Results results = env.make_results();
  scene.keep(0);
  for (std::uint64_t i = 1; i <= steps; ++i) {
    env.step(random.draw(), block, results);
    scene.keep(static_cast<double>(i) * step);
  }
  scene.write(options.gltf);
}

std::string check_segments(const std::string& text) {
  const auto& range = mimo::ranges::mesh::segments;
  if (count(range)(text).empty() && std::stoi(text) % 4 == 0) return "";
  return cli::text("expected a multiple of 4 from %u to %u", range.low, range.high);
}

}  // namespace

void add_export(CLI::App& program) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write a scene or a recording for other programs");
  add_scene_options(*command, options->unit.world);
  add_actuation_option(*command, options->unit.world);
  add_face_option(*command, options->unit.world);
  add_seed_option(*command, options->unit.world);
  add_unit_options(*command, options->unit);
  command->add_option("--fmu", options->fmu, "A unit of FMI, for co-simulation: Simulink, Modelica, FMPy")
      ->type_name("FILE.fmu")
      ->check(CLI::Validator(ends_in({".fmu"}), ""));
  command->add_option("--gltf", options->gltf, "glTF 2.0, with textures inside: Blender, Unity, Godot, three.js")
      ->type_name("FILE.glb")
      ->check(CLI::Validator(ends_in({".glb"}), ""));
  command
      ->add_option("--html", options->page.out,
                   "A page that plays a recording, with all that it needs inside; it opens\nfrom a disk")
      ->type_name("FILE.html")
      ->check(CLI::Validator(ends_in({".html"}), ""));
  command
      ->add_option("--page", options->page.without,
                   "The page without a recording, which ./dev web makes. Default: that which is\nbeside the program")
      ->type_name("FILE");
  command->add_option("recording", options->recording, "The recording that --html or the Python package writes")
      ->type_name("FILE.h5");
  for (std::size_t i = 0; i < std::size(kOfPython); ++i) {
    const OfPython& it = kOfPython[i];
    const std::string told = std::string(it.what) + ": tells how the Python package writes it";
    command->add_option(it.option, options->of_python[i], told)->type_name(it.type);
  }
  command->add_option("--seconds", options->seconds, "Seconds of random movement as an animation. Default: none")
      ->check(number(0, 3600))
      ->option_text("S");
  command->add_option("--segments", options->segments, "Level of detail: pieces of a circle, a multiple of 4")
      ->type_name("N")
      ->check(CLI::Validator(check_segments, ""))
      ->capture_default_str();
  command->footer(
      "A glTF file has a node for each body and below it one for each of its geoms, by their names; y is up and "
      "metres\n"
      "are the unit. Lights, the sky and what MuJoCo does not draw are not in it. Actions are the inputs of a unit of\n"
      "FMI; rewards and the fields of --outputs are its outputs.\n"
      "Examples:\n"
      "  mimo export --scene showroom --seconds 5 --gltf infant.glb\n"
      "  mimo export --html run.html run.h5");
  command->callback([options, command] { export_scene(*options, *command); });
}

}  // namespace cli
