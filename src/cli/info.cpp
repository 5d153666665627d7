// mimo info: what a scene holds and what its infant senses.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/behaviours.h"
#include "cli/commands.h"
#include "programs/summary.h"
#include "programs/text.h"
#include "programs/world.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

// Milliseconds after the step's end.
std::string time_text(const mimo_field& field) {
  const std::string start = text("%g", 1000 * field.start), end = text("%g", 1000 * field.end);
  return start == end ? end : start + " to " + end;
}

// Infinite bounds become null: JSON has no infinity.
Json describe(const mimo_field& field) {
  return {{"name", field.name},
          {"dtype", dtype_name(field)},
          {"shape", shape(field)},
          {"unit", field.unit},
          {"frame", field.frame},
          {"start", field.start},
          {"end", field.end},
          {"period", field.period},
          {"low", field.low},
          {"high", field.high},
          {"offset", field.offset},
          {"receptors", field.receptors},
          {"sample_rate", field.sample_rate}};
}

// What each action is and may be.
Json describe_actions(const mimo::Env& env) {
  Json actions = Json::array();
  for (const mimo_action& action : env.layout().actions()) {
    actions.push_back({{"name", action.name},
                       {"unit", action.unit},
                       {"agent", action.agent},
                       {"low", action.low},
                       {"high", action.high}});
  }
  return actions;
}

// A quantity of all parts of a kind that have a name; a number where each has one.
Json by_name(const mimo::Env& env, int kind, int quantity) {
  Json values = Json::object();
  for (const std::int32_t id : env.ids(kind)) {
    const std::string name = env.name(kind, id);
    const std::vector<double> of_it = env.get_values(quantity, {id});
    if (!name.empty()) values[name] = of_it.size() == 1 ? Json(of_it[0]) : Json(of_it);
  }
  return values;
}

// Parts of the body, and the bodies of the left side or the middle that stand for them.
constexpr std::pair<const char*, const char*> kParts[] = {{"face", "head"},
                                                          {"chest", "upper_body"},
                                                          {"upper_arm", "left_upper_arm"},
                                                          {"lower_arm", "left_lower_arm"},
                                                          {"hand", "left_hand"},
                                                          {"fingers", "left_fingers"},
                                                          {"belly", "lower_body"},
                                                          {"hip", "hip"},
                                                          {"upper_leg", "left_upper_leg"},
                                                          {"lower_leg", "left_lower_leg"},
                                                          {"foot", "left_foot"},
                                                          {"toes", "left_toes"}};

// How eyes and nerves of the first infant's age are, whether its world has them so or not.
void describe_maturity(const mimo::Env& env, Json& info) {
  if (env.width(MIMO_AGENT_PHYSIOLOGICAL_AGE, {0}) == 0) return;  // no infant
  const mimo_maturity at = mimo::maturity(env.get_values(MIMO_AGENT_PHYSIOLOGICAL_AGE, {0})[0]);
  info["vision"] = {{"acuity_cpd", at.acuity}, {"peak_contrast", at.peak_contrast}, {"chroma", at.chroma}};
  const std::string name = env.agents()[0].name, prefix = name.empty() ? "" : name + "/";
  Json& delays = info["delays_s"] = {
      {"vision", at.vision_delay}, {"vestibular", at.vestibular_delay}, {"hearing", at.hearing_delay}};
  const Json lengths = by_name(env, MIMO_BODY, MIMO_BODY_NERVE_LENGTH);
  for (const auto& [part, body] : kParts) {
    const auto length = lengths.find(prefix + body);
    if (length == lengths.end()) continue;  // five fingers have other bones
    const double along = length->get<double>() / at.conduction_speed;
    delays[part] = along + at.sensory_delay;
    delays[std::string("motor_") + part] = along + at.motor_delay;
  }
}

Json describe(const mimo::Env& env) {
  const auto joints = env.ids(MIMO_JOINT);
  const auto agents = env.agents();
  Json info = {{"nq", env.width(MIMO_JOINT_POSITION, joints)},
               {"nv", env.width(MIMO_JOINT_VELOCITY, joints)},
               {"nu", env.count(MIMO_ACTUATOR)},
               {"bodies", env.count(MIMO_BODY)},
               {"joints", env.count(MIMO_JOINT)},
               {"geoms", env.count(MIMO_GEOM)},
               {"cameras", env.count(MIMO_CAMERA)},
               {"touch_sensors", touch_sensors(env)},
               {"agents", agents.size()},
               {"mass_kg", agents.empty() ? Json() : Json(agents[0].mass)},
               {"height_m", agents.empty() ? Json() : Json(agents[0].height)},
               {"stature_m", agents.empty() ? Json() : Json(agents[0].height)}};
  info["task"] = env.task();
  info["timestep_s"] = env.timestep();
  info["frame_skip"] = env.frame_skip();
  info["versions"] = {{"libmimo", mimo_version()}, {"abi", mimo_abi_version()}, {"mujoco", mimo_mujoco_version()}};
  info["observation_bytes"] = env.layout().info().block_bytes;
  info["observation_fields"] = Json::array();
  for (const mimo_field& field : env.layout().fields()) info["observation_fields"].push_back(describe(field));
  info["actions"] = describe_actions(env);
  if (!agents.empty()) describe_maturity(env, info);
  info["geom_sizes"] = by_name(env, MIMO_GEOM, MIMO_GEOM_SIZE);
  info["joint_ranges"] = by_name(env, MIMO_JOINT, MIMO_JOINT_RANGE);
  info["gears"] = by_name(env, MIMO_ACTUATOR, MIMO_ACTUATOR_GEAR);
  return info;
}

void print_for_people(const Json& info, const std::vector<mimo_field>& fields) {
  Table counts(1);
  for (const auto& [key, value] : info.items()) {
    if (value.is_number()) counts.add({key, value.dump()});
    if (value.is_string()) counts.add({key, value.get<std::string>()});
  }
  for (const auto& [key, value] : info["versions"].items()) {
    counts.add({key, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  counts.print(std::cout);

  std::cout << "\nobservation fields\n";
  Table table(8);
  table.add({"field", "type", "shape", "unit", "frame", "time, ms", "low", "high", "offset"});
  for (const mimo_field& f : fields) {
    table.add({f.name, dtype_name(f), shape_text(f), or_dash(f.unit), or_dash(f.frame), time_text(f), text("%g", f.low),
               text("%g", f.high), std::to_string(f.offset)});
  }
  table.print(std::cout);

  std::cout << "\nactions\n";
  Table actions(1);
  actions.add({"action", "low", "high", "unit"});
  for (const Json& it : info["actions"]) {
    actions.add({it["name"].get<std::string>(), text("%g", it["low"].get<double>()),
                 text("%g", it["high"].get<double>()), or_dash(it["unit"].get<std::string>())});
  }
  actions.print(std::cout);
}

}  // namespace

void add_info(CLI::App& program) {
  struct InfoOptions {
    WorldOptions world;
    bool json = false;
    bool tasks = false;
  };
  auto options = std::make_shared<InfoOptions>();
  options->world.touch = "";  // the scene's own
  CLI::App* command = program.add_subcommand("info", "Count what a scene holds, list what its infant senses and does");
  add_scene_options(*command, options->world);
  add_actuation_option(*command, options->world);
  add_reflexes_option(*command, options->world);
  add_vision_options(*command, options->world, "the scene's own");
  add_touch_option(*command, options->world);
  add_senses_option(*command, options->world);
  add_own_senses_option(*command, options->world);
  add_parameter_option(*command, options->world);
  add_voice_option(*command, options->world);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--tasks", options->tasks,
                    "List tasks: what is measured, what it has to reach, when infants\nshow it; with --scene of that "
                    "scene only");
  command->footer(
      "The world is the one that mimo_env_make(scene) and mimo.make(scene) give, but for what options change.\n"
      "Counts are MuJoCo's: the world is a body, too. nq, nv, nu: numbers of joint positions, joint velocities and\n"
      "motors. mass_kg and stature_m are the first agent's. The time of a field is when it is true, from the\n"
      "end of a step: 0 is that end, -5 the start of its last physics step, more where senses are late.\n"
      "Examples:\n"
      "  mimo info\n"
      "  mimo info --scene my_room.xml --json\n"
      "  mimo info --tasks");
  command->callback([options, command] {
    if (options->tasks) return print_behaviours(options->world, command->count("--scene") > 0, options->json);
    const mimo::Env env = open_own_world(options->world, make_env_config());
    const Json info = describe(env);
    if (options->json) {
      std::cout << info.dump(2) << '\n';
    } else {
      print_for_people(info, env.layout().fields());
    }
  });
}

}  // namespace cli
