#include "cli/behaviours.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

// Months that are not known are 0 in the interface.
Json months(double number) { return number > 0 ? Json(number) : Json(); }

Json describe(const std::string& scene, const mimo_behaviour& it) {
  return {{"task", kBehaviour},
          {"scene", scene},
          {"about", it.about},
          {"measure", it.measure},
          {"unit", it.unit},
          {"at_most", it.at_most != 0},
          {"threshold", it.threshold},
          {"conditions", it.conditions},
          {"hold_seconds", it.hold_seconds},
          {"episode_seconds", it.episode_seconds},
          {"norm",
           {{"early_months", months(it.norm_early)},
            {"months", months(it.norm_age)},
            {"late_months", months(it.norm_late)},
            {"about", it.norm}}},
          {"source", it.norm_source}};
}

Json describe_all() {
  Json all = Json::array();
  for (const std::string& name : mimo::task_names()) {
    if (name != kBehaviour) all.push_back({{"task", name}, {"scene", nullptr}, {"measure", nullptr}});
  }
  for (const std::string& name : mimo::scene_names()) {
    WorldOptions options;
    options.scene = name;
    mimo::Scene scene = load_scene(options);
    if (const auto behaviour = behaviour_of(scene)) all.push_back(describe(name, *behaviour));
  }
  return all;
}

Json describe_one(const WorldOptions& options) {
  mimo::Scene scene = load_scene(options);
  return Json::array({describe(options.scene, scene.behaviour())});
}

std::string threshold_text(const Json& it) {
  const std::string unit = it["unit"].get<std::string>();
  std::string told = text("at %s %g%s%s", it["at_most"].get<bool>() ? "most" : "least", it["threshold"].get<double>(),
                          unit.empty() ? "" : " ", unit.c_str());
  const double seconds = it["hold_seconds"].get<double>();
  return seconds > 0 ? told + text(" for %g s", seconds) : told;
}

std::string norm_text(const Json& norm) {
  std::string told;
  for (const char* which : {"early_months", "months", "late_months"}) {
    told += told.empty() ? "" : " ";
    told += norm[which].is_null() ? "-" : text("%g", norm[which].get<double>());
  }
  return told;
}

// What a line of the table has room for; --json has it all.
std::string shortened(const std::string& measure) {
  constexpr std::size_t kMost = 48;
  return measure.size() <= kMost ? measure : measure.substr(0, kMost - 3) + "...";
}

void print_for_people(const Json& all) {
  Table table(4);
  table.add({"scene", "the infant", "measure", "reached", "months"});
  for (const Json& it : all) {
    if (it["measure"].is_null()) continue;
    table.add({it["scene"].get<std::string>(), it["about"].get<std::string>(),
               shortened(it["measure"].get<std::string>()), threshold_text(it), norm_text(it["norm"])});
  }
  table.print(std::cout);
  std::string others;
  for (const Json& it : all) {
    if (it["measure"].is_null()) others += (others.empty() ? "" : ", ") + it["task"].get<std::string>();
  }
  if (!others.empty()) std::cout << "\ntasks that no document describes: " << others << '\n';
  std::cout << "\nmonths: at which the first, the middle and the last infants show it; sources: --json\n";
}

}  // namespace

std::optional<mimo_behaviour> behaviour_of(mimo::Scene& scene) {
  try {
    return scene.behaviour();
  } catch (const mimo::Exception& error) {
    if (error.status() != MIMO_E_NOT_FOUND) throw;
    return std::nullopt;
  }
}

void print_behaviours(const WorldOptions& options, bool one_scene, bool json) {
  const Json all = one_scene ? describe_one(options) : describe_all();
  if (json) {
    std::cout << all.dump(2) << '\n';
  } else {
    print_for_people(all);
  }
}

}  // namespace cli
