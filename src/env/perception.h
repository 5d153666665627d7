// What one agent senses: an infant, or any other part of a model.
#pragma once

#include <memory>
#include <vector>

#include "body/body.h"
#include "env/kit.h"
#include "senses/sense.h"
#include "senses/touch/touch.h"

namespace mimo::env {

struct Perception {
  body::Body body;
  std::vector<std::unique_ptr<senses::Sense>> senses;
  SkinPtr skin;  // null without touch
};

// Finds the agent in the model and attaches the senses that its options ask for; `renderer` is needed only for vision.
// A skin that is there already is shared instead of made anew.
Perception perceive(const mjModel& model, const AgentOptions& options, render::Renderer* renderer,
                    SkinPtr skin = nullptr);

// Puts the agent's name before those of a sense's fields.
void name_fields(const AgentOptions& options, senses::Sense& sense);

}  // namespace mimo::env
