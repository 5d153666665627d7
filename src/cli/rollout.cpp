// mimo rollout: applies a stored control sequence and writes down the states.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/commands.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/world.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

struct RolloutOptions {
  WorldOptions world;
  std::string controls, out, jacobian;
  std::uint64_t every = 1;
  bool no_contact = false, no_gravity = false;
};

mimo_env_config config_of(const RolloutOptions& options) {
  auto config = make_env_config();
  if (options.no_contact) config.disable |= MIMO_DISABLE_CONTACT;
  if (options.no_gravity) config.disable |= MIMO_DISABLE_GRAVITY;
  if (options.jacobian == "dense") config.jacobian = MIMO_JACOBIAN_DENSE;
  if (options.jacobian == "sparse") config.jacobian = MIMO_JACOBIAN_SPARSE;
  config.frame_skip = 1;                                          // a row of controls each
  if (options.world.actuation != "torque") config.task = "none";  // which such a step would evaluate
  return config;
}

std::string body_label(const mimo::Env& env, std::int32_t body) {
  const std::string name = env.name(MIMO_BODY, body);
  return name.empty() ? "body:" + std::to_string(body) : name;
}

// One quantity of all of a kind, by name.
class NamedQuantity {
 public:
  NamedQuantity(const mimo::Env& env, std::int32_t kind, std::int32_t quantity,
                std::string (*label)(const mimo::Env&, std::int32_t))
      : quantity_(quantity), ids_(env.ids(kind)) {
    for (const std::int32_t id : ids_) {
      labels_.push_back(label(env, id));
      widths_.push_back(env.width(quantity, {id}));
    }
  }

  std::vector<double> read(const mimo::Env& env) const { return env.get_values(quantity_, ids_); }

  Json to_json(const std::vector<double>& values) const {
    Json json = Json::object();
    auto next = values.begin();
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      const auto end = next + static_cast<std::ptrdiff_t>(widths_[i]);
      json[labels_[i]] = std::vector<double>(next, end);
      next = end;
    }
    return json;
  }

 private:
  std::int32_t quantity_;
  std::vector<std::int32_t> ids_;
  std::vector<std::string> labels_;
  std::vector<std::size_t> widths_;
};

// The states of a rollout as bare numbers: nothing is written before all went well.
class Recording {
 public:
  explicit Recording(const mimo::Env& env)
      : qpos_(env, MIMO_JOINT, MIMO_JOINT_POSITION, joint_label),
        qvel_(env, MIMO_JOINT, MIMO_JOINT_VELOCITY, joint_label),
        xpos_(env, MIMO_BODY, MIMO_BODY_POSITION, body_label) {}

  void add(mimo::Env& env, std::size_t step) {
    env.update();  // else the bodies are where they were one physics step ago
    states_.push_back({step, qpos_.read(env), qvel_.read(env), xpos_.read(env)});
  }

  void write(const std::string& path) const {
    std::ostringstream file;
    file << "{\"states\": [";
    for (const State& state : states_) file << (&state == states_.data() ? "\n" : ",\n") << to_json(state).dump();
    file << "\n]}\n";
    write_file(path, file.str());
  }

 private:
  struct State {
    std::size_t step;
    std::vector<double> qpos, qvel, xpos;
  };

  Json to_json(const State& state) const {
    return {{"step", state.step},
            {"qpos", qpos_.to_json(state.qpos)},
            {"qvel", qvel_.to_json(state.qvel)},
            {"xpos", xpos_.to_json(state.xpos)}};
  }

  NamedQuantity qpos_, qvel_, xpos_;
  std::vector<State> states_;
};

// What the columns of a file are for.
template <typename Find>
auto find_columns(const NumberTable& controls, const std::string& path, Find&& find) {
  std::vector<decltype(find(controls.names[0]))> columns;
  for (const std::string& name : controls.names) {
    try {
      columns.push_back(find(name));
    } catch (const std::runtime_error& error) {
      throw Failure(path + ", line 1: " + error.what());
    }
  }
  return columns;
}

// Control inputs as they are, of any actuator.
class Motors {
 public:
  Motors(const mimo::Env& env, const NumberTable& controls, const std::string& path)
      : actuators_(find_columns(controls, path, [&](const auto& name) { return env.find(MIMO_ACTUATOR, name); })) {}

  void step(mimo::Env& env, const std::vector<double>& row) {
    env.set_values(MIMO_ACTUATOR_CONTROL, actuators_, row);
    env.physics_step(1);
  }

 private:
  std::vector<std::int32_t> actuators_;
};

// Targets of joints or activations of muscles, clipped to their bounds.
class ControlRows {
 public:
  ControlRows(const mimo::Env& env, const NumberTable& controls, const std::string& path)
      : actions_(env.layout().actions()),
        columns_(find_columns(controls, path, [&](const auto& name) { return index(name); })),
        action_(actions_.size()) {}

  void step(mimo::Env& env, const std::vector<double>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) action_[columns_[i]] = static_cast<float>(row[i]);
    env.step(action_, nothing_, unwanted_);
  }

 private:
  std::size_t index(const std::string& name) const {
    const auto named = [&](const mimo_action& action) { return action.name == name; };
    const auto found = std::find_if(actions_.begin(), actions_.end(), named);
    if (found == actions_.end()) throw Failure("no action is called '" + name + "'");
    return static_cast<std::size_t>(found - actions_.begin());
  }

  std::vector<mimo_action> actions_;
  std::vector<std::size_t> columns_;
  std::vector<float> action_;
  mimo::Block nothing_;  // nothing is sensed, nothing rewarded
  mimo::Results unwanted_;
};

template <typename Controls>
void roll_out(const RolloutOptions& options) {
  const NumberTable table = read_numbers(options.controls, "actuator");
  require_writable(options.out);
  mimo::Env env = open_bare_world(options.world, config_of(options));
  Controls controls(env, table, options.controls);
  Recording recording(env);
  {
    Progress progress(table.rows.size());
    for (std::size_t step = 0; step < table.rows.size(); ++step) {
      if (step % options.every == 0) recording.add(env, step);
      controls.step(env, table.rows[step]);
      progress.show(step + 1);
    }
  }
  recording.add(env, table.rows.size());
  recording.write(options.out);
}

}  // namespace

void add_rollout(CLI::App& program) {
  auto options = std::make_shared<RolloutOptions>();
  CLI::App* command = program.add_subcommand("rollout", "Apply stored motor commands and write down the states");
  add_scene_options(*command, options->world);
  options->world.actuation = "torque";
  add_actuation_option(*command, options->world);
  command
      ->add_option("--controls", options->controls,
                   "A header of actuator names, then a row of numbers a physics step;\n"
                   "actuators that are not named stay at 0. With another --actuation than\n"
                   "torque: names of actions")
      ->type_name("FILE.csv")
      ->required();
  command->add_option("--out", options->out, "The states")->type_name("FILE.json")->required();
  command->add_option("--every", options->every, "Keep every K-th state; the last one is always kept")
      ->type_name("K")
      ->check(CLI::Range(1, 1000000000).description(""))
      ->capture_default_str();
  command->add_flag("--no-contact", options->no_contact, "Let bodies pass through each other");
  command->add_flag("--no-gravity", options->no_gravity, "Let everything float");
  command
      ->add_option("--jacobian", options->jacobian,
                   "dense: as the original solves; sparse: the same to rounding, and\n"
                   "faster. Default: as the scene says")
      ->type_name("dense|sparse")
      ->check(CLI::IsMember({"dense", "sparse"}).description(""));
  command->footer(
      "Starts from the scene's stored state; nothing is random. Writes\n"
      "  {\"states\": [{\"step\": 0, \"qpos\": {joint: [..]}, \"qvel\": {joint: [..]}, \"xpos\": {body: [x, y, z]}}, "
      "...]}\n"
      "with the states before steps 0, K, 2K, ... and after the last one. Free joints without a name are called\n"
      "free:<body>.\n"
      "Example:\n"
      "  mimo rollout --controls controls.csv --every 20 --out states.json");
  command->callback([options] {
    options->world.actuation == "torque" ? roll_out<Motors>(*options) : roll_out<ControlRows>(*options);
  });
}

}  // namespace cli
