#include "programs/policy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr double kTurn = 6.283185307179586;

std::size_t elements(const mimo_field& field) {
  std::size_t count = 1;
  for (const std::size_t length : shape(field)) count *= length;
  return count;
}

mimo_field field_of(const std::string& file, const std::vector<mimo_field>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const mimo_field& one) { return name == one.name; });
  if (found == all.end()) refuse_policy(file, text("the world has no field \"%s\"", shortened(name).c_str()));
  if (found->dtype != MIMO_F32)
    refuse_policy(file, text("field \"%s\" holds no 32-bit numbers", shortened(name).c_str()));
  return *found;
}

}  // namespace

void Policy::attach(const mimo::Env& env) {
  attach_step(env.timestep() * env.frame_skip());
  const auto& layout = env.layout();
  const auto all = layout.fields();
  places_.clear();
  for (const auto& field : file_.fields) {
    places_.push_back(field_of(name_, all, field.name));
    if (elements(places_.back()) != field.count) {
      refuse_policy(name_,
                    text("field \"%s\" has %zu numbers in this world, and %zu in the policy: another body, other "
                         "senses or other motors",
                         shortened(field.name).c_str(), elements(places_.back()), field.count));
    }
  }
  attach_actions(layout.actions());
  if (file_.reflex) attach_reflex(layout);
  seen_.resize(file_.mean.size());
  commands_.resize(file_.actions.size());
  rows_.resize(file_.layers.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].resize(file_.layers[i].rows);
}

void Policy::attach_step(double step) {
  if (file_.step_seconds > 0 && std::abs(step - file_.step_seconds) > 1e-9) {
    refuse_policy(name_,
                  text("it was learned with steps of %g s, and the world's last %g s", file_.step_seconds, step));
  }
  step_ = step;
  last_ = -1;
  const double steps = file_.hold_s > 0 ? file_.hold_s / step : 1;
  hold_ = std::llround(steps);
  if (hold_ < 1 || std::abs(steps - static_cast<double>(hold_)) > 1e-6 * steps) {
    refuse_policy(name_, text("\"hold_s\" is %g, expected a whole number of steps of %g s", file_.hold_s, step));
  }
}

void Policy::attach_actions(const std::vector<mimo_action>& actions) {
  const auto& own = file_.actions;
  if (actions.size() != own.size()) {
    refuse_policy(name_, text("the world has %zu actions, and the policy %zu", actions.size(), own.size()));
  }
  bounds_.clear();
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] != actions[i].name) {
      refuse_policy(name_, text("action %zu is \"%s\" in this world, and \"%s\" in the policy", i, actions[i].name,
                                shortened(own[i]).c_str()));
    }
    bounds_.push_back({static_cast<float>(actions[i].low), static_cast<float>(actions[i].high)});
  }
}

void Policy::attach_reflex(const mimo::Layout& layout) {
  const auto all = layout.fields();
  angles_ = field_of(name_, all, "proprioception/position");
  velocities_ = field_of(name_, all, "proprioception/velocity");
  const std::size_t count = std::min(elements(angles_), elements(velocities_));
  joints_.clear();
  for (const std::string& joint : file_.reflex->joints) {
    std::size_t at = 0;
    while (at < count && layout.label(angles_.name, at) != joint) ++at;
    if (at == count) {
      refuse_policy(name_, text("\"joints\" has \"%s\", and no element of proprioception/position is called so",
                                shortened(joint).c_str()));
    }
    joints_.push_back(at);
  }
}

const std::vector<float>& Policy::act(const mimo::Block& block, double time) {
  const std::int64_t step = std::llround(time / step_);
  if (last_ < 0 || step % hold_ == 0 || step / hold_ != last_ / hold_ || step < last_) think(block, time);
  last_ = step;
  if (file_.reflex) pull(block);
  return commands_;
}

// Renews the last of rows_, and without a reflex the commands.
void Policy::think(const mimo::Block& block, double time) {
  std::size_t at = 0;
  const auto see = [&](float value) {
    seen_[at] = std::clamp((value - file_.mean[at]) / file_.deviation[at], -file_.clip, file_.clip);
    ++at;
  };
  for (const mimo_field& place : places_) {
    for (const float value : block.view<float>(place)) see(value);
  }
  for (const double period : file_.clock_s) {
    see(static_cast<float>(std::sin(kTurn * time / period)));
    see(static_cast<float>(std::cos(kTurn * time / period)));
  }
  const std::vector<float>* in = &seen_;
  for (std::size_t l = 0; l < rows_.size(); ++l) {
    const auto& layer = file_.layers[l];
    std::vector<float>& out = rows_[l];
    out = layer.bias;
    for (std::size_t column = 0; column < layer.columns; ++column) {
      const float* weights = layer.weights.data() + column * layer.rows;
      const float value = (*in)[column];
      for (std::size_t row = 0; row < layer.rows; ++row) out[row] += weights[row] * value;
    }
    if (l + 1 < rows_.size()) {
      for (float& one : out) one = std::tanh(one);
    }
    in = &out;
  }
  if (!std::all_of(in->begin(), in->end(), [](float one) { return std::isfinite(one); })) {
    refuse_policy(name_, "its network gives what is no finite number");
  }
  if (file_.reflex) return;
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const Bounds& bounds = bounds_[i];
    commands_[i] = bounds.low + (bounds.high - bounds.low) * (std::clamp((*in)[i], -1.0F, 1.0F) + 1) / 2;
  }
}

// The reflex of this step, towards what the network gave last.
void Policy::pull(const mimo::Block& block) {
  const auto angles = block.view<float>(angles_), velocities = block.view<float>(velocities_);
  const auto& reflex = *file_.reflex;
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const std::size_t joint = joints_[i];
    const float away = reflex.start[i] + rows_.back()[i] - angles[joint];
    commands_[i] =
        std::clamp(reflex.stiffness * away - reflex.damping * velocities[joint], bounds_[i].low, bounds_[i].high);
  }
}

}  // namespace cli
