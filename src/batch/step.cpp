#include "batch/step.h"

#include <algorithm>

#include "base/fail.h"
#include "base/format.h"

namespace mimo::batch {

void Report::note(Status what, const char* why) noexcept {
  status = what;
  try {
    message = as_line(why);
  } catch (...) {
    message.clear();
  }
}

void Step::operator()(std::size_t world, Report& report) const {
  const bool anew = due_for_reset(world);
  const Span<const float> actions = anew ? Span<const float>() : actions_of(world);  // refused: nothing is written
  if (output_.was_reset != nullptr) output_.was_reset[world] = 0;
  if (output_.final_written != nullptr) output_.final_written[world] = 0;
  if (anew) {
    blank(world, false);
    restart(world);
    return;
  }
  act(world, actions, report);
  if (options_.autoreset != Autoreset::kNone && at(world).over()) end_episode(world);
}

// Nothing to be remembered between steps: the world itself knows, also after its state was loaded.
bool Step::due_for_reset(std::size_t world) const {
  const env::World& it = at(world);
  if (it.physics().failed()) return options_.restart_failed;
  return options_.autoreset == Autoreset::kNextStep && it.over();
}

void Step::act(std::size_t world, Span<const float> actions, Report& report) const {
  const bool failed_before = std::as_const(at(world)).physics().failed();
  try {
    at(world).step(actions, block(world), results_of(world));
  } catch (const Error& error) {
    const bool failed = std::as_const(at(world)).physics().failed();
    blank(world, failed);
    if (failed_before && report.status == Status::kSimulation) throw Error(report.status, std::string(report.message));
    if (!failed || !options_.restart_failed) throw;
    report.note(error.status(), error.what());
    report.settled = true;
    if (options_.autoreset != Autoreset::kNextStep) restart(world);
  }
}

// An agent whose episode ends because another's has ended is cut off.
void Step::end_episode(std::size_t world) const {
  const env::Results results = results_of(world);
  for (std::size_t i = 0; i < results.truncated.size(); ++i) {
    const bool over = at(world).agents()[i].task->over();
    if (!over) results.truncated[i] = 1;
  }
  if (options_.autoreset != Autoreset::kSameStep) return;
  const std::size_t bytes = at(world).layout().bytes();
  if (output_.final_blocks != nullptr && output_.blocks != nullptr) {
    std::copy_n(block(world), bytes, output_.final_blocks + world * bytes);
    if (output_.final_written != nullptr) output_.final_written[world] = 1;
  }
  restart(world);
}

void Step::restart(std::size_t world) const {
  at(world).reset(nullptr, block(world));
  if (output_.was_reset != nullptr) output_.was_reset[world] = 1;
}

// Defined bytes where there is nothing to tell: learners average over whole batches.
void Step::blank(std::size_t world, bool cut_off) const {
  if (std::uint8_t* start = block(world)) std::fill_n(start, at(world).layout().bytes(), std::uint8_t{0});
  const env::Results results = results_of(world);
  std::fill(results.reward.begin(), results.reward.end(), 0.0);
  std::fill(results.terminated.begin(), results.terminated.end(), std::uint8_t{0});
  std::fill(results.truncated.begin(), results.truncated.end(), static_cast<std::uint8_t>(cut_off));
  std::fill(results.outcome.begin(), results.outcome.end(), std::int32_t{0});
  std::fill(results.terms.begin(), results.terms.end(), 0.0);
}

Span<const float> Step::actions_of(std::size_t world) const {
  if (actions_ == nullptr) return {};
  const std::size_t count = at(world).action_size();
  const Span<const float> actions(actions_ + world * count, count);
  at(world).check_actions(actions);
  return actions;
}

env::Results Step::results_of(std::size_t world) const {
  const std::size_t agents = at(world).agents().size();
  const auto row = [world](auto* first, std::size_t length) {
    return first == nullptr ? decltype(Span(first, 0))() : Span(first + world * length, length);
  };
  return {row(output_.reward, agents), row(output_.terminated, agents), row(output_.truncated, agents),
          row(output_.outcome, agents), row(output_.terms, at(world).term_count())};
}

}  // namespace mimo::batch
