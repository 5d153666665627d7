// What one agent senses: an infant, or any other part of a model.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "actuation/actuation.h"
#include "body/body.h"
#include "env/compiled_world.h"
#include "observation/sense.h"
#include "senses/touch/things.h"
#include "senses/touch/touch.h"

namespace mimo::sound {
struct Utterance;
}

namespace mimo::senses {
class FusimotorDrives;
class Soundscape;
}  // namespace mimo::senses

namespace mimo::env {

struct Perception {
  body::Body body;
  std::unique_ptr<actuation::Actuation> actuation;  // whose commands are felt
  std::vector<std::unique_ptr<observation::Sense>> senses;
  SkinPtr skin;                                       // null without touch
  std::shared_ptr<sound::Utterance> voice{};          // what it is told to say; null where it has none
  std::optional<std::size_t> own_sound{};             // of the sources around, its voice
  std::shared_ptr<senses::FusimotorDrives> drives{};  // of its spindles; null without them
};

// What its senses need to know of the world around.
struct Setting {
  double tick;  // from one advance of the senses' processes to the next, s
  senses::touch::ThingsPtr things;
  std::size_t ticks;                         // of a step
  senses::Soundscape* soundscape = nullptr;  // null where nobody hears
};

// Finds the agent in the model and attaches the senses that its options ask for; `renderer` is needed only for vision.
// A skin that is there already is shared instead of made anew.
Perception perceive(const mjModel& model, const AgentOptions& options, const Setting& setting,
                    render::Renderer* renderer, SkinPtr skin = nullptr);

// One more sense, unless it has no fields; the agent's name goes before theirs.
void add_sense(Perception& agent, const AgentOptions& options, std::unique_ptr<observation::Sense> sense);

// A camera that belongs to no agent; the renderer is null where there is none.
std::unique_ptr<observation::Sense> make_camera(const mjModel& model, const CameraOptions& options,
                                                render::Renderer* renderer);

}  // namespace mimo::env
