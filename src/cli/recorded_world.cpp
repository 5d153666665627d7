#include "cli/recorded_world.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "programs/failure.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kNoVision[] = "off";

// Options and their values, of all that `add_options` knows.
Json given(void (*add_options)(CLI::App&, WorldOptions&), const CLI::App& command) {
  Json json = Json::object();
  WorldOptions options;
  CLI::App known;
  add_options(known, options);
  for (const CLI::Option* option : known.get_options()) {
    const std::string name = option->get_single_name();
    const CLI::Option* found = command.get_option_no_throw("--" + name);
    if (name == "help" || found == nullptr || found->count() == 0) continue;
    json[name] = found->results();
  }
  return json;
}

// So that it is found from everywhere.
void make_scene_absolute(Json& json) {
  if (!json.contains("scene")) return;
  const std::string scene = json["scene"][0];
  if (scene.find_first_of("./\\") == std::string::npos || !std::filesystem::exists(scene)) return;
  json["scene"][0] = std::filesystem::absolute(scene).string();
}

void parse(const Json& json, CLI::App& parser) {
  std::vector<std::string> arguments;
  for (const auto& [name, values] : json.items()) {
    arguments.push_back("--" + name + "=" + values.at(0).get<std::string>());
    for (std::size_t i = 1; i < values.size(); ++i) arguments.push_back(values[i].get<std::string>());
  }
  std::reverse(arguments.begin(), arguments.end());  // as the parser wants them
  parser.parse(arguments);
}

}  // namespace

void add_sense_options(CLI::App& command, WorldOptions& options) {
  options.vision = kNoVision;
  add_vision_options(command, options, kNoVision);
  add_foveation_option(command, options);
  add_touch_option(command, options);
  add_senses_option(command, options);
}

void add_acting_options(CLI::App& command, WorldOptions& options) {
  add_scene_options(command, options);
  add_maturity_options(command, options.age);
  add_actuation_option(command, options);
  add_reflexes_option(command, options);
  add_face_option(command, options);
}

void add_recorded_options(CLI::App& command, WorldOptions& options) {
  add_acting_options(command, options);
  add_sense_options(command, options);
}

std::string configuration_of(const CLI::App& command) {
  Json json = given(add_recorded_options, command);
  make_scene_absolute(json);
  return json.dump();
}

bool is_ours(const std::string& configuration) {
  const Json json = Json::parse(configuration, nullptr, false);
  if (!json.is_object()) return false;
  WorldOptions options;
  CLI::App known;
  add_recorded_options(known, options);
  return std::all_of(json.items().begin(), json.items().end(),
                     [&](const auto& item) { return known.get_option_no_throw("--" + item.key()) != nullptr; });
}

bool senses_changed(const CLI::App& command) { return !given(add_sense_options, command).empty(); }

std::string changed_configuration(const std::string& file, const std::string& configuration, const CLI::App& changes) {
  Json acting = given(add_acting_options, changes);
  make_scene_absolute(acting);
  const bool ours = is_ours(configuration);
  if (!ours && !acting.contains("scene")) {
    throw Failure(file + " was recorded by a program of its own; --scene says which scene that was");
  }
  if (ours && !acting.empty()) {
    throw Failure("--" + acting.begin().key() + ": " + file + " tells its world itself, which was made by mimo record");
  }
  Json json = ours ? Json::parse(configuration) : acting;
  json.update(given(add_sense_options, changes));
  return json.dump();
}

WorldOptions read_configuration(const std::string& file, const std::string& configuration) {
  WorldOptions options;
  CLI::App known;
  add_recorded_options(known, options);
  try {
    parse(Json::parse(configuration), known);
  } catch (const CLI::Error& error) {
    throw Failure(file + " has a configuration that this program does not understand: " + error.what());
  } catch (const nlohmann::json::exception&) {
    throw Failure(file + " is not a whole recording: its attribute 'configuration' is not what it should be");
  }
  return options;
}

}  // namespace cli
