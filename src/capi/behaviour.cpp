// What a scene's document says of its behaviour.
#include "mimo/experimental/behaviour.h"

#include <string>
#include <utility>
#include <vector>

#include "base/format.h"
#include "base/names.h"
#include "capi/calls.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "tasks/behaviour/clauses.h"

namespace mimo::capi {
namespace {

// Texts of a description, which the scene keeps.
enum Told { kAbout, kMeasure, kUnit, kConditions, kNorm, kSource, kToldCount };

std::vector<std::string> texts_of(const scene::Scene& scene, const tasks::Clauses& clauses) {
  std::vector<std::string> texts(kToldCount);
  texts[kAbout] = scene.custom_text(names::kBehaviour);
  texts[kMeasure] = clauses.all.front().quantity;
  texts[kUnit] = clauses.all.front().unit;
  std::vector<std::string> conditions;
  for (std::size_t i = 1; i < clauses.all.size(); ++i) conditions.push_back(clauses.all[i].text);
  texts[kConditions] = join(conditions, "; ");
  texts[kNorm] = scene.custom_text(names::kNormAbout);
  texts[kSource] = scene.custom_text(names::kNormSource);
  return texts;
}

// Its texts are those that `texts` becomes.
mimo_behaviour described(const SceneObject& scene, std::vector<std::string>& texts) {
  const scene::Scene& document = scene.blueprint.current().scene;
  const std::string reached = document.custom_text(names::kReached);
  if (reached.empty()) {
    fail(Status::kNotFound, "the scene's document describes no behaviour: it has no custom text \"{}\"",
         names::kReached);
  }
  const tasks::Clauses clauses = tasks::read_clauses(reached);
  texts = texts_of(document, clauses);
  const auto text = [&](Told which) { return texts[which].c_str(); };
  mimo_behaviour ours{};
  ours.at_most = clauses.all.front().at_least ? 0 : 1;
  ours.about = text(kAbout);
  ours.measure = text(kMeasure);
  ours.unit = text(kUnit);
  ours.conditions = text(kConditions);
  ours.threshold = clauses.all.front().threshold;
  ours.hold_seconds = clauses.seconds;
  ours.episode_seconds = tasks::episode_seconds(document.custom_numbers(names::kSeconds));
  const std::vector<double> norm = document.custom_numbers(names::kNorm);
  if (norm.size() == 3) {
    ours.norm_early = norm[0];
    ours.norm_age = norm[1];
    ours.norm_late = norm[2];
  }
  ours.norm = text(kNorm);
  ours.norm_source = text(kSource);
  return ours;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" mimo_status mimo_scene_behaviour(mimo_scene* scene, mimo_behaviour* behaviour) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    std::vector<std::string> texts;
    write_described(behaviour, described(object, texts), "behaviour");
    object.told = std::move(texts);  // not before: after a failure, texts of the earlier call are still read
  });
}
