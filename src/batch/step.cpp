// What a step of the batch means for one world: act, or start anew where an episode has ended or the world has failed.
#include <algorithm>

#include "base/fail.h"
#include "batch/batch.h"

namespace mimo::batch {

void Batch::step_world(std::size_t world) {
  const bool anew = due_for_reset(world);
  const Span<const float> actions = anew ? Span<const float>() : actions_of(world);  // refused: nothing is written
  if (call_.output.was_reset != nullptr) call_.output.was_reset[world] = 0;
  if (call_.output.final_written != nullptr) call_.output.final_written[world] = 0;
  if (anew) {
    blank(world, false);
    restart(world);
    return;
  }
  try_step(world, actions);
  if (options_.autoreset != Autoreset::kNone && worlds_[world]->over()) end_episode(world);
}

// Nothing to be remembered between steps: the world itself knows, also after its state was loaded.
bool Batch::due_for_reset(std::size_t world) const {
  const env::World& it = *worlds_[world];
  if (it.physics().failed()) return options_.restart_failed;
  return options_.autoreset == Autoreset::kNextStep && it.over();
}

void Batch::try_step(std::size_t world, Span<const float> actions) {
  Report& report = reports_[world];
  const bool failed_before = worlds_[world]->physics().failed();
  try {
    worlds_[world]->step(actions, block(world), results_of(world));
  } catch (const Error& error) {
    const bool failed = worlds_[world]->physics().failed();
    blank(world, failed);
    if (failed_before && report.status == Status::kSimulation) throw Error(report.status, std::string(report.message));
    if (!failed || !options_.restart_failed) throw;
    note(world, error.status(), error.what());
    report.settled = true;
    if (options_.autoreset != Autoreset::kNextStep) restart(world);
  }
}

// An agent whose episode ends because another's has ended is cut off.
void Batch::end_episode(std::size_t world) {
  const env::Results results = results_of(world);
  for (std::size_t i = 0; i < results.truncated.size(); ++i) {
    const bool over = worlds_[world]->agents()[i].task->over();
    if (!over) results.truncated[i] = 1;
  }
  if (options_.autoreset != Autoreset::kSameStep) return;
  const std::size_t bytes = worlds_[world]->layout().bytes();
  if (call_.output.final_blocks != nullptr && call_.output.blocks != nullptr) {
    std::copy_n(block(world), bytes, call_.output.final_blocks + world * bytes);
    if (call_.output.final_written != nullptr) call_.output.final_written[world] = 1;
  }
  restart(world);
}

void Batch::restart(std::size_t world) {
  worlds_[world]->reset(nullptr, block(world));
  if (call_.output.was_reset != nullptr) call_.output.was_reset[world] = 1;
}

// Defined bytes where there is nothing to tell: learners average over whole batches.
void Batch::blank(std::size_t world, bool cut_off) {
  if (std::uint8_t* start = block(world)) std::fill_n(start, worlds_[world]->layout().bytes(), std::uint8_t{0});
  const env::Results results = results_of(world);
  std::fill(results.reward.begin(), results.reward.end(), 0.0);
  std::fill(results.terminated.begin(), results.terminated.end(), std::uint8_t{0});
  std::fill(results.truncated.begin(), results.truncated.end(), static_cast<std::uint8_t>(cut_off));
}

Span<const float> Batch::actions_of(std::size_t world) const {
  if (call_.actions == nullptr) return {};
  const std::size_t count = worlds_[world]->action_size();
  const Span<const float> actions(call_.actions + world * count, count);
  worlds_[world]->check_actions(actions);
  return actions;
}

env::Results Batch::results_of(std::size_t world) const {
  const auto row = [this, world](auto* first) {
    return first == nullptr ? decltype(Span(first, 0))() : Span(first + world * agents_, agents_);
  };
  return {row(call_.output.reward), row(call_.output.terminated), row(call_.output.truncated)};
}

}  // namespace mimo::batch
