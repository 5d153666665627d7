#include "programs/world.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "programs/senses.h"
#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

template <std::size_t kCount>
std::vector<std::string> names_of(const Word (&words)[kCount]) {
  std::vector<std::string> names;
  for (const Word& word : words) names.emplace_back(word.name);
  return names;
}

template <std::size_t kCount>
std::optional<std::uint32_t> value_of(const Word (&words)[kCount], const std::string& name) {
  for (const Word& word : words) {
    if (name == word.name) return word.value;
  }
  return std::nullopt;
}

bool is_given(const AgeOptions& it) {
  const AgeOptions usual;
  return it.age || it.physiological_age || it.sex != usual.sex || it.growth != usual.growth || it.percentile != 0 ||
         it.z_length != 0 || it.z_weight != 0 || it.z_head != 0;
}

// Goes into the `log` member of configs.
void print_message(void*, const mimo_log_record* record) {
  std::fprintf(stderr, "mimo: %s: %s\n", record->level == MIMO_LOG_WARNING ? "warning" : "note", record->text);
}

bool is_builtin(const std::string& scene) {
  const auto names = mimo::scene_names();
  return std::find(names.begin(), names.end(), scene) != names.end();
}

// A path looks like one and is no built-in name. For anything else, the library has the best message.
bool is_file(const std::string& scene) {
  return !is_builtin(scene) && scene.find_first_of("./\\") != std::string::npos;
}

std::string list(const std::vector<std::string>& names, const char* comma = ", ") {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : comma) + name;
  return text;
}

// Broken into lines that fit beside the options.
std::string list_in_help(const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 60;
  std::string text;
  std::size_t line = 0;
  for (const std::string& name : names) {
    if (line + name.size() > kLongest) text += '\n', line = 0;
    text += name + ',';
    line += name.size() + 1;
  }
  text.pop_back();
  return text;
}

}  // namespace

mimo::Scene load_scene(const WorldOptions& options) {
  auto config = mimo::scene_config();
  (is_file(options.scene) ? config.file : config.name) = options.scene.c_str();
  config.log = print_message;
  return mimo::Scene(config);
}

namespace {

// Only the compiled model knows: the body may come from an include. The file's task may need infants that it lacks.
mimo::Env bare_file(const WorldOptions& options) {
  auto config = mimo::env_config();
  config.renderer = "none";
  config.task = "none";
  return mimo::Env(load_scene(options), config);
}

// Everything in a file that knows nothing of infants is one agent, with the senses that there is something for.
void make_agent_of_all(const WorldOptions& options, mimo_agent_config& agent) {
  const mimo::Env world = bare_file(options);
  agent.body = "scene";
  agent.root = "world";
  agent.vestibular = 0;
  if (world.count(MIMO_CAMERA) == 0) agent.vision = 0;
}

// "scene" where the infant is part of the scene's file, "" where there is none: then everything in it is one agent.
std::string body_of_scene(const WorldOptions& options, const mimo_agent_config& usual) {
  if (is_file(options.scene) && !infants(bare_file(options)).empty()) return "scene";
  return is_file(options.scene) || !options.body.empty() ? options.body : usual.body;
}

std::uint32_t pixels(const WorldOptions& options) {
  if (options.vision == "off") return 0;
  return options.vision.empty() ? 256 : static_cast<std::uint32_t>(std::stoul(options.vision));
}

std::string check_vision(const std::string& text) {
  const bool number = !text.empty() && text.size() <= 4 &&
                      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const auto& range = mimo::ranges::agent_config::vision_width;
  if (text == "off" || (number && range.has(static_cast<std::uint32_t>(std::stoul(text))))) return "";
  return cli::text("expected 'off' or a number of pixels from %u to %u, not '%s'", range.low, range.high, text.c_str());
}

std::string check_number(const std::string& text, double low, double high, const char* also = "") {
  const std::optional<double> value = finite_number(text);
  if (value && *value >= low && *value <= high) return "";
  return cli::text("expected %sa number from %g to %g, not '%s'", also, low, high, text.c_str());
}

std::string check_touch(const std::string& text) {
  const auto& range = mimo::ranges::agent_config::touch_scale;
  return text == "off" ? "" : check_number(text, range.low, range.high, "'off' or ");
}

// The parser alone would convert -1 to a huge number.
std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), seed);
  const bool good = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return good ? "" : "expected a whole number from 0 to 18446744073709551615, not '" + text + "'";
}

// The bits of a list of words; nothing where one is unknown.
template <std::size_t kCount>
std::optional<std::uint32_t> bits_of(const Word (&words)[kCount], const std::string& list) {
  std::uint32_t bits = 0;
  if (list == "none") return bits;
  for (const std::string& part : parts_of(list)) {
    const std::optional<std::uint32_t> bit = value_of(words, part);
    if (!bit) return std::nullopt;
    bits |= *bit;
  }
  return bits;
}

std::optional<std::uint32_t> reflexes_of(const std::string& list) {
  return list == "all" ? MIMO_REFLEX_ALL : bits_of(kReflexWords, list);
}

std::string check_reflexes(const std::string& given) {
  if (reflexes_of(given)) return "";
  return "expected all, none or a list of " + list(names_of(kReflexWords)) + ", separated by commas, not '" + given +
         "'";
}

std::string check_effects(const std::string& given) {
  if (bits_of(kRenderWords, given)) return "";
  return "expected none or a list of " + list(names_of(kRenderWords)) + ", separated by commas, not '" + given + "'";
}

void set_vision(std::uint32_t size, mimo_agent_config& agent) {
  agent.vision = size != 0;
  if (size != 0) agent.vision_width = agent.vision_height = size;
}

void set_touch(const std::string& touch, mimo_agent_config& agent) {
  agent.touch = touch != "off";
  if (agent.touch != 0) agent.touch_scale = std::stod(touch);
}

// Switches on all receptors of the agent's senses, and the senses that are off by default.
void add_receptors(mimo_agent_config& agent) {
  const mimo_agent_config usual = mimo::agent_config();
  constexpr std::uint32_t kForces = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;  // exclude each other
  const std::uint32_t vision = agent.vision, forces = agent.touch & kForces;
  for (const Sense& sense : kSenses) {
    if (agent.*sense.bits != 0 || usual.*sense.bits == 0) agent.*sense.bits = sense.every;
  }
  agent.vision = vision;
  if (agent.touch != 0) agent.touch = (agent.touch & ~kForces) | forces;
  agent.proprioception = MIMO_PROPRIOCEPTION_ALL;
}

// "strength=0.7" as a name and a number; no number where the text has none.
std::pair<std::string, std::optional<double>> parts_of_setting(const std::string& setting) {
  const std::size_t equals = std::min(setting.find('='), setting.size());
  return {setting.substr(0, equals), finite_number(equals == setting.size() ? "" : setting.substr(equals + 1))};
}

// Sets "strength=0.7". Returns the name of the number; "" if no number has it, or cannot have the value.
std::string set_number(mimo_agent_config& agent, const std::string& setting) {
  const auto [name, value] = parts_of_setting(setting);
  std::string done;
  for_each_number(agent, [&, name = name, value = value](const char* known, auto& number) {
    using Number = std::decay_t<decltype(number)>;
    using Limits = std::numeric_limits<Number>;
    if (name != known || !value) return;
    const bool fits = *value >= static_cast<double>(Limits::lowest()) && *value <= static_cast<double>(Limits::max());
    if (!fits || (Limits::is_integer && std::trunc(*value) != *value)) return;
    number = static_cast<Number>(*value);
    done = name;
  });
  return done;
}

std::string check_setting(const std::string& setting) {
  mimo_agent_config agent = mimo::agent_config();
  if (!set_number(agent, setting).empty()) return "";
  std::vector<std::string> names;
  for_each_number(agent, [&](const char* name, auto&) { names.emplace_back(name); });
  return "expected NAME=VALUE with a number that fits, not '" + setting + "'; names are " + list(names);
}

std::string check_parameter(const std::string& setting) {
  const auto [name, value] = parts_of_setting(setting);
  return !name.empty() && value ? "" : "expected NAME=VALUE with a number, not '" + setting + "'";
}

// Gives each infant the user's own senses.
void add_own(const WorldOptions& options, std::size_t agents, mimo::Scene& scene) {
  for (const std::string& library : options.own_senses) {
    for (std::size_t agent = 0; agent < agents; ++agent) scene.load_sense(library, agent);
  }
  for (const std::string& setting : options.parameters) {
    const auto [name, value] = parts_of_setting(setting);
    scene.set_parameter(name, value.value_or(0));
  }
}

mimo_agent_config agent_config(const WorldOptions& options, Senses senses, const mimo_agent_config& usual) {
  const bool own = senses == Senses::kOwn;
  auto agent = own ? usual : mimo::agent_config();
  agent.actuation = value_of(kActuationWords, options.actuation).value_or(usual.actuation);
  if (!own || !options.vision.empty()) set_vision(senses == Senses::kAllButVision ? 0 : pixels(options), agent);
  if (options.eye_width != 0) {
    agent.vision = MIMO_VISION_RGB;
    agent.vision_width = options.eye_width;
    agent.vision_height = options.eye_height;
  }
  agent.vision_foveation = options.foveation;
  if (!own || !options.touch.empty()) set_touch(options.touch, agent);
  if (!options.face.empty()) agent.face = options.face.c_str();
  if (options.every_sense) add_receptors(agent);
  agent.reflexes = reflexes_of(options.reflexes).value_or(0) | (options.every_sense ? MIMO_REFLEX_FELT : 0U);
  agent.voice = options.voice ? 1 : 0;
  if (options.hearing) agent.hearing = MIMO_HEARING_EARS | MIMO_HEARING_BANDS;
  for (const std::string& setting : options.settings) set_number(agent, setting);
  if (senses == Senses::kNone) {
    for (const Sense& sense : kSenses) agent.*sense.bits = 0;
  }
  return agent;
}

}  // namespace

void add_age_options(CLI::App& command, AgeOptions& options) {
  command.add_option("--age", options.age, "Age of the infants in months, 0 to 24. Default: 18")
      ->type_name("MONTHS")
      ->check(number(0, 24));
  command
      .add_option("--physiological-age", options.physiological_age,
                  "Age of strength, range of motion and tone. Default: --age")
      ->type_name("MONTHS")
      ->check(number(0, 24));
  command.add_option("--sex", options.sex, "Sex of the infants: " + list(names_of(kSexWords)))
      ->type_name("SEX")
      ->check(CLI::IsMember(names_of(kSexWords)).description(""))
      ->capture_default_str();
  command
      .add_option("--percentile", options.percentile,
                  "Percentile of length, weight and head at that age and sex,\n1 to 99.865. Default: 50")
      ->type_name("P")
      ->check(number(1, 99.865));
  const auto add_z = [&](const char* name, double& z, const char* what) {
    command.add_option(name, z, std::string(what) + ": standard deviations from the median, -3 to 3")
        ->type_name("Z")
        ->check(number(-3, 3));
  };
  add_z("--z-length", options.z_length, "Length");
  add_z("--z-weight", options.z_weight, "Weight");
  add_z("--z-head", options.z_head, "Circumference of the head");
  command
      .add_option("--growth", options.growth,
                  "Source of sizes: who, the WHO's standards of growth, or original,\nthe rules of MIMo v2")
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(kGrowthModelWords)).description(""))
      ->capture_default_str();
}

void add_maturity_options(CLI::App& command, AgeOptions& options) {
  options.eyes = options.delays = true;
  const auto add = [&](const char* name, bool& on, const std::string& off, const char* what) {
    command
        .add_option_function<std::string>(
            name, [&on, off](const std::string& word) { on = word != off; }, what)
        ->type_name("WHICH")
        ->check(CLI::IsMember(std::vector<std::string>{"age", off}).description(""));
  };
  add("--eyes", options.eyes, "perfect",
      "With an age: age, for eyes of that age, or perfect. Pictures through\ntheir cameras show what they see. "
      "Default: "
      "age");
  add("--delays", options.delays, "none",
      "With an age: age, for nerves of that age, or none, for no delays.\nDefault: age");
}

std::optional<mimo_growth> growth_of(const AgeOptions& options) {
  if (!is_given(options)) return std::nullopt;
  mimo_growth growth = mimo::growth();
  growth.age = options.age.value_or(growth.age);
  growth.matures_apart = options.physiological_age.has_value();
  growth.physiological_age = options.physiological_age.value_or(0);
  growth.sex = static_cast<std::int32_t>(value_of(kSexWords, options.sex).value_or(0));
  growth.model = static_cast<std::int32_t>(value_of(kGrowthModelWords, options.growth).value_or(0));
  growth.percentile = options.percentile;
  growth.z_length = options.z_length;
  growth.z_weight = options.z_weight;
  growth.z_head = options.z_head;
  if (options.age || options.physiological_age) {
    growth.maturity |= (options.eyes ? MIMO_MATURITY_EYES : 0U) | (options.delays ? MIMO_MATURITY_DELAYS : 0U);
  }
  return growth;
}

mimo_agent_config sensing_agent(const WorldOptions& options) {
  return agent_config(options, Senses::kAll, mimo::agent_config());
}

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    parts.push_back(list.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

std::size_t steps_in(double seconds, double step) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds / step)));
}

CLI::Validator number(double low, double high) {
  return CLI::Validator([low, high](const std::string& text) { return check_number(text, low, high); }, "");
}

CLI::Validator number(const mimo::ranges::Range<double>& range) { return number(range.low, range.high); }

CLI::Validator count(const mimo::ranges::Range<std::uint32_t>& range) {
  return CLI::Range(static_cast<int>(range.low), static_cast<int>(range.high)).description("");
}

void add_scene_options(CLI::App& command, WorldOptions& options) {
  command.add_option("--scene", options.scene, "Built-in scene (" + list(mimo::scene_names()) + ") or MJCF file")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  command
      .add_option("--body", options.body,
                  "Body of the infant: mitten or fingers; mitten-mirrored or\n"
                  "fingers-mirrored, whose left side mirrors the right one. A file\n"
                  "with an infant keeps that infant; a file without one gets an\n"
                  "infant only with this option")
      ->type_name("BODY");
  command
      .add_option(
          "--set", options.settings,
          "A number of the infant, by its name in mimo_agent_config, as\nstrength=0.7; overrides other options; "
          "may be given several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(CLI::Validator(check_setting, ""));
  add_age_options(command, options.age);
}

void add_vision_options(CLI::App& command, WorldOptions& options, const std::string& usual) {
  command
      .add_option("--vision", options.vision,
                  "Width and height of each eye's picture in pixels, or off.\nDefault: " + usual)
      ->type_name("PX|off")
      ->check(CLI::Validator(check_vision, ""));
  add_renderer_option(command, options);
}

void add_foveation_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option("--foveation", options.foveation,
                  "Enlarge the middle of the picture L / ln(1 + L) times and shrink\nthe rim, 0.01 to 100. Default: "
                  "as drawn")
      ->type_name("L")
      ->check(number(0.01, 100));
}

void add_touch_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option(
          "--touch", options.touch,
          "Density of the touch sensors, 2 for half the usual distances\nbetween them, or off. " +
              std::string(options.touch.empty() ? "Default: the scene's own" : "Pictures show what the sensors feel"))
      ->type_name("SCALE|off")
      ->check(CLI::Validator(check_touch, ""))
      ->capture_default_str();
}

void add_renderer_option(CLI::App& command, WorldOptions& options) {
  command.add_option("--renderer", options.renderer, "Renderer of pictures: auto, ray, osmesa or gl")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option(
          "--samples", options.samples,
          "Samples a pixel, for smooth edges: 1, 4, 16 or 64. Default: 1\nwith rays, the scene's own with OpenGL")
      ->type_name("N")
      ->check(CLI::IsMember({1, 4, 16, 64}).description(""));
  command
      .add_option(
          "--effects", options.effects,
          "What pictures show: none, or a list of " + list(names_of(kRenderWords), ",") + ".\nDefault: all except fog")
      ->type_name("LIST")
      ->check(CLI::Validator(check_effects, ""));
  command.add_option("--render-threads", options.render_threads, "Threads that draw one picture, with rays: 1 to 64")
      ->type_name("N")
      ->check(count(mimo::ranges::env_config::render_threads))
      ->capture_default_str();
}

void add_actuation_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option("--actuation", options.actuation,
                  "What actions are: " + list(names_of(kActuationWords)) +
                      ".\nDefault: " + (options.actuation.empty() ? "the scene's own" : options.actuation))
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(kActuationWords)));
}

void add_senses_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option_function<std::string>(
          "--senses",
          [&options](const std::string& which) {
            options.every_sense = which == "all";
            options.hearing = which != "usual";
          },
          "usual; hearing: adds ears; or all: adds ears, and the nerves of\nskin, muscles, joints and labyrinth. "
          "Default: usual")
      ->type_name("WHICH")
      ->check(CLI::IsMember({"usual", "hearing", "all"}).description(""));
}

void add_seconds_option(CLI::App& command, double& seconds) {
  command.add_option("--seconds", seconds, "Simulated time, at 100 steps a second")
      ->type_name("S")
      ->check(number(0.01, 1e6))
      ->capture_default_str();
}

void add_voice_option(CLI::App& command, WorldOptions& options) {
  command.add_flag(
      "--voice", options.voice,
      "The infant has a voice: four more actions after those of its motors,\nloudness, pitch and two formants");
}

void add_reflexes_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option("--reflexes", options.reflexes,
                  "Reflexes of newborns, which fade with age: none, all that the body can do,\nor a list of\n" +
                      list_in_help(names_of(kReflexWords)))
      ->type_name("LIST")
      ->check(CLI::Validator(check_reflexes, ""))
      ->capture_default_str();
}

void add_face_option(CLI::App& command, WorldOptions& options) {
  command.add_option("--face", options.face, "The infant's face: " + list(mimo::face_names()))->type_name("NAME");
}

void add_own_senses_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option("--sense", options.own_senses,
                  "Shared library with a sense of your own, which is loaded and run;\nmay be given several times")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

void add_parameter_option(CLI::App& command, WorldOptions& options) {
  command
      .add_option("--parameter", options.parameters,
                  "A number of the task or of a sense of your own, as ct/gain=2; may be\ngiven several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(CLI::Validator(check_parameter, ""));
}

void add_seed_option(CLI::App& command, WorldOptions& options) {
  command.add_option("--seed", options.seed, "Seed of everything random")
      ->type_name("N")
      ->check(CLI::Validator(check_seed, ""))
      ->capture_default_str();
}

namespace {

// How many agents it has been given.
std::size_t add_agents(const WorldOptions& options, Senses senses, mimo::Scene& scene) {
  constexpr double kSpacing = 0.05;  // of touch sensors on what is no infant, m
  const mimo_agent_config usual = scene.default_agent();
  const std::string body = body_of_scene(options, usual);
  mimo_agent_config agent = agent_config(options, senses, usual);
  const std::optional<mimo_growth> growth = growth_of(options.age);
  if (growth) agent.growth = &*growth;
  if (body.empty()) {
    make_agent_of_all(options, agent);
    scene.add_agent(agent);
    if (agent.touch != 0) scene.set_touch(kSpacing / agent.touch_scale);
    return 1;
  }
  agent.body = body.c_str();
  return scene.add_agents(&agent);
}

}  // namespace

mimo::Scene make_scene(const WorldOptions& options, Senses senses) {
  mimo::Scene scene = load_scene(options);
  const std::size_t agents = add_agents(options, senses, scene);
  if (senses != Senses::kNone) add_own(options, agents, scene);
  return scene;
}

mimo_env_config make_env_config() {
  auto config = mimo::env_config();
  config.log = print_message;
  return config;
}

void set_renderer(const WorldOptions& options, mimo_env_config& config) {
  config.renderer = options.renderer.c_str();
  config.samples = options.samples;
  config.render_threads = options.render_threads;
  if (!options.effects.empty()) config.render = bits_of(kRenderWords, options.effects).value_or(config.render);
}

mimo::Env open_world(const WorldOptions& options, mimo_env_config config) {
  set_renderer(options, config);
  const mimo::Scene scene = make_scene(options, Senses::kAll);
  try {
    return mimo::Env(scene, config);
  } catch (const mimo::Exception& error) {
    if (error.status() != MIMO_E_UNSUPPORTED || !options.vision.empty()) throw;
    std::fprintf(stderr, "mimo: vision is off: %s\n", error.what());
    return mimo::Env(make_scene(options, Senses::kAllButVision), config);
  }
}

mimo::Env open_own_world(const WorldOptions& options, mimo_env_config config) {
  set_renderer(options, config);
  return mimo::Env(make_scene(options, Senses::kOwn), config);
}

mimo::Env open_bare_world(const WorldOptions& options, mimo_env_config config) {
  config.renderer = "none";
  return mimo::Env(make_scene(options, Senses::kNone), config);
}

}  // namespace cli
