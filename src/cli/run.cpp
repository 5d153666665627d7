// mimo run: random or learned movements, all senses, pictures, and a table of what each sense gave.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/chosen_actions.h"
#include "cli/commands.h"
#include "cli/episode.h"
#include "cli/picture.h"
#include "cli/touch_picture.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"
#include "programs/world.h"

namespace cli {
namespace {

struct RunOptions {
  WorldOptions world;
  double seconds = 10;
  std::string out = "mimo_run";
  std::string sound;  // a file, or "" for none
  double full_scale = 1;
  ActionOptions actions;
  std::string task;  // "" for the scene's own
  bool json = false;
};

class Run {
 public:
  explicit Run(const RunOptions& options);
  void simulate();
  void report() const;

 private:
  void save(const std::string& name, const ColorPicture& picture, const std::string& what);
  void save_pictures(const std::string& prefix, const std::string& when);
  void save_touch(const std::string& prefix, const std::string& when);
  void save_eyes(const std::string& infant, const std::string& prefix, const std::string& when);
  void save_cameras(const std::string& prefix, const std::string& when);
  const mimo_field* field(const std::string& name) const;

  // Refers to the options.
  static mimo_env_config config(const RunOptions& options) {
    auto config = make_env_config();
    config.timing = 1;
    config.task = options.task.empty() ? nullptr : options.task.c_str();
    return config;
  }
  bool whole_episode() const { return actions_.learned() || options_.json; }
  void print_report() const;
  void print_json() const;

  const RunOptions& options_;
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  std::vector<FieldStatistics> statistics_;
  std::optional<Wave> wave_;
  Table pictures_{2};
  ChosenActions actions_;
  Episode episode_;
  std::size_t steps_ = 0;
  double simulated_ = 0, wall_ = 0;
};

Run::Run(const RunOptions& options)
    : options_(options),
      env_(open_world(options.world, config(options))),
      block_(env_.make_block()),
      results_(env_.make_results()),
      actions_(env_, options.actions, options.world.seed) {
  for (const mimo_field& field : env_.layout().fields()) statistics_.emplace_back(field);
  if (!options.sound.empty()) {
    const std::string name = env_.agents()[0].name;
    wave_.emplace(env_.layout(), name.empty() ? "" : name + "/");
  }
  make_folder(options.out);
}

void Run::simulate() {
  const double dt = env_.timestep() * env_.frame_skip();
  const auto steps = steps_in(options_.seconds, dt);
  const Interrupt interrupt;
  env_.reset(options_.world.seed, block_);
  save_pictures("start_", "at the start");
  {
    Progress progress(steps);
    do {
      const auto action = actions_.next(block_);
      const auto start = Clock::now();
      env_.step(action, block_, results_);
      wall_ += seconds_since(start);
      simulated_ = static_cast<double>(++steps_) * dt;
      for (FieldStatistics& field : statistics_) field.add(block_);
      if (wave_) wave_->add(block_);
      episode_.add(results_, simulated_);
      progress.show(steps_);
    } while (steps_ < steps && !(whole_episode() && episode_.over()) && !Interrupt::requested());
  }
  save_pictures("", "at the end");
  if (wave_) wave_->write(options_.sound, options_.full_scale);
}

void Run::save(const std::string& name, const ColorPicture& picture, const std::string& what) {
  const std::string path =
      (std::filesystem::path(options_.out) / (name + ".png")).generic_string();  // slashes of one kind
  write_png(path, picture);
  pictures_.add({path, what});
}

const mimo_field* Run::field(const std::string& name) const {
  for (const FieldStatistics& field : statistics_) {
    if (name == field.field().name) return &field.field();
  }
  return nullptr;
}

// Those of an infant with a name carry it, as its fields do.
void Run::save_eyes(const std::string& infant, const std::string& prefix, const std::string& when) {
  const std::string path = infant.empty() ? "" : infant + "/", owner = infant.empty() ? "the" : infant + "'s";
  const mimo_field *left = field(path + "vision/eye_left"), *right = field(path + "vision/eye_right");
  if (left == nullptr || right == nullptr) return;
  const std::string start = prefix + (infant.empty() ? "" : infant + "_");
  const ColorPicture left_picture = picture_in(*left, block_), right_picture = picture_in(*right, block_);
  save(start + "left", left_picture, owner + " left eye's view " + when);
  save(start + "right", right_picture, owner + " right eye's view " + when);
  save(start + "anaglyph", anaglyph(left_picture, right_picture), "both, for red-cyan glasses");
}

// What cameras see that are no eyes: an agent that is no infant sees with all that it has.
void Run::save_cameras(const std::string& prefix, const std::string& when) {
  const std::string path = "vision/";
  for (const FieldStatistics& statistics : statistics_) {
    const mimo_field& field = statistics.field();
    std::string name = field.name;
    if (field.dtype != MIMO_U8 || name.rfind(path, 0) != 0 || name.rfind(path + "eye_", 0) == 0) continue;
    name = name.substr(path.size());
    std::replace(name.begin(), name.end(), '/', '_');
    save(prefix + "camera_" + name, picture_in(field, block_), "camera " + name + " " + when);
  }
}

void Run::save_touch(const std::string& prefix, const std::string& when) {
  TouchPicture touch(env_);
  if (!touch.possible()) return;
  const std::string sensors = std::to_string(touch.sensors()) + " sensors";
  save(prefix + "touch", touch.draw(env_, touch.close_up(env_, block_), block_), "what " + sensors + " feel " + when);
  for (const mimo_agent_info& agent : env_.agents()) {
    const TouchMap map(env_, agent.name);
    if (!map.possible()) continue;
    std::string name = prefix;
    if (*agent.name != '\0') name.append(agent.name).append("_");
    save(name.append("touch_map"), map.draw(block_), "all skin, unfolded");
  }
}

void Run::save_pictures(const std::string& prefix, const std::string& when) {
  for (const mimo_agent_info& infant : env_.agents()) save_eyes(infant.name, prefix, when);
  save_cameras(prefix, when);
  try {
    save(prefix + "outside", env_.render(overview(env_)).color, "seen from outside " + when);
    save_touch(prefix, when);
  } catch (const mimo::Exception& error) {
    if (error.status() != MIMO_E_UNSUPPORTED) throw;
    pictures_.add({"none " + when + ":", error.what()});
  }
}

void Run::report() const {
  if (options_.json) {
    print_json();
  } else {
    print_report();
  }
}

void Run::print_json() const {
  nlohmann::ordered_json told = episode_.describe(env_, options_.world);
  const bool learned = actions_.learned();
  told["policy"] = learned ? nlohmann::ordered_json(options_.actions.policy) : nlohmann::ordered_json();
  if (learned) told["policy_us"] = 1e6 * actions_.seconds_thought() / static_cast<double>(steps_);
  told["step_ms"] = 1000 * wall_ / static_cast<double>(steps_);
  std::cout << told.dump(2) << '\n';
}

void Run::print_report() const {
  const double step_ms = 1000 * wall_ / static_cast<double>(steps_);
  if (Interrupt::requested()) std::cout << text("interrupted after %g of %g s\n", simulated_, options_.seconds);
  std::cout << text("%.2f s of scene %s simulated in %.2f s: %.2f x real time, %.3f ms a step\n", simulated_,
                    options_.world.scene.c_str(), wall_, simulated_ / wall_, step_ms);
  std::cout << "\nmilliseconds a step\n";
  Table times(1);
  for (const auto& [part, ms] : split_ms(env_.timing(), step_ms)) times.add({part, text("%.3f", ms)});
  times.print(std::cout);

  std::cout << "\nsenses over all steps\n";
  Table senses(4);
  senses.add({"field", "type", "shape", "unit", "min", "mean", "max"});
  for (const FieldStatistics& field : statistics_) {
    const mimo_field& f = field.field();
    senses.add({f.name, dtype_name(f), shape_text(f), or_dash(f.unit), text("%.4g", field.min()),
                text("%.4g", field.mean()), text("%.4g", field.max())});
  }
  senses.print(std::cout);

  if (wave_) {
    const auto peak = static_cast<double>(wave_->peak());
    std::cout << text("\nsound of both ears of the first infant: %s, peak %.3g Pa; full scale is %g Pa%s\n",
                      options_.sound.c_str(), peak, options_.full_scale,
                      peak > options_.full_scale ? ", louder sound is clipped: see --full-scale" : "");
  }
  std::cout << "\npictures\n";
  pictures_.print(std::cout);
}

}  // namespace

void add_run(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      program.add_subcommand("run", "Move at random or as learned, with all senses on; write pictures and a report");
  add_scene_options(*command, options->world);
  add_maturity_options(*command, options->world.age);
  add_actuation_option(*command, options->world);
  add_reflexes_option(*command, options->world);
  add_seconds_option(*command, options->seconds);
  add_vision_options(*command, options->world);
  add_foveation_option(*command, options->world);
  add_touch_option(*command, options->world);
  add_face_option(*command, options->world);
  add_seed_option(*command, options->world);
  command->add_option("--out", options->out, "Folder for the pictures, which is made if necessary")
      ->type_name("DIR")
      ->capture_default_str();
  add_senses_option(*command, options->world);
  add_own_senses_option(*command, options->world);
  add_parameter_option(*command, options->world);
  add_action_options(*command, options->actions);
  command->add_option("--task", options->task, "Task in place of the scene's own")->type_name("NAME");
  command->add_flag(
      "--json", options->json,
      "Print one JSON object in place of the report: reward, outcome, and what\nthe task measured, at the "
      "episode's end");
  add_voice_option(*command, options->world);
  command
      ->add_option("--sound", options->sound,
                   "Also write what both ears of the first infant hear, as a WAV file;\nswitches the ears on")
      ->type_name("FILE")
      ->check(CLI::Validator(ends_in({".wav"}), ""));
  command
      ->add_option("--full-scale", options->full_scale,
                   "Sound pressure of the largest number in that file; louder sound is\nclipped. A cry reaches 13 "
                   "at the own ears")
      ->type_name("PA")
      ->check(number(1e-4, 1000))
      ->capture_default_str();
  command->footer(
      "Writes left.png, right.png, anaglyph.png (both eyes, for red-cyan glasses), outside.png, touch.png (what is\n"
      "felt, from its side: sensors as points, forces as arrows) and touch_map.png (all skin, unfolded) as things are\n"
      "at the end, and the same with start_ before the name as they were at the start. In a scene with several "
      "infants\n"
      "pictures of eyes and of all skin are called after them,\n"
      "anna_left.png. Ctrl-C ends the movements early and keeps pictures and report; a second one ends at once.\n"
      "Examples:\n"
      "  mimo run\n"
      "  mimo run --seconds 2 --vision 512 --seed 7 --out pictures\n"
      "  mimo run --policy reach.json --vision off --json\n"
      "  mimo run --scene my_room.xml --body mitten");
  command->callback([options, command] {
    follow_policy(*command, options->actions, options->world);
    if (!options->sound.empty()) {
      require_writable(options->sound);
      options->world.hearing = true;
    }
    Run run(*options);
    run.simulate();
    run.report();
    std::cout.flush();
    if (Interrupt::requested()) Interrupt::pass_on();
  });
}

}  // namespace cli
