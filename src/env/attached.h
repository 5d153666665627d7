// Senses of somebody else's simulation: they look at its data and change nothing of it. What they remember is theirs.
#pragma once

#include <vector>

#include "env/perception.h"
#include "env/state.h"
#include "env/step.h"
#include "observation/limited_senses.h"
#include "observation/observer.h"
#include "render/renderer.h"

namespace mimo::senses {
class Soundscape;
}

namespace mimo::env {

class Attached {
 public:
  // The model outlives this object. Of the options only those of pictures count. `step` is what the host calls a step,
  // in seconds; 0: a time step of the model.
  Attached(const CompiledWorld& compiled, double step);
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

  const mjModel& model() const { return *model_; }
  const observation::Layout& layout() const { return observer_.layout(); }
  const observation::LimitedSenses& limits() const { return limits_; }
  // What the host calls a step.
  double step_seconds() const { return step_seconds_; }
  const std::vector<Perception>& agents() const { return agents_; }

  // Data are of the model, as they are: of the last step that their owner made.
  // An episode starts with them. A null seed goes on from the last one.
  void reset(const mjData& data, const std::uint64_t* seed);
  // One step later: what is remembered takes them in.
  void advance(const mjData& data);
  // What is sensed, with what is remembered, which stays as it is.
  void observe(const mjData& data, std::uint8_t* block);

  // What the host tells the fusimotor neurons of these motors, as FusimotorDrives has it. Throws for what has none, and
  // for rates that are none.
  void drive_spindles(Span<const std::int32_t> motors, Span<const double> rates);
  // All motors that have spindles.
  Span<const std::int32_t> driven() const { return driven_; }
  // A body plays samples from the next advance on: see env/sounds.h.
  void play(const std::string& body, Span<const float> samples, double rate);

  // What is remembered.
  std::size_t state_bytes() const { return archive_.bytes(); }
  void save(Span<std::uint8_t> state) const { archive_.save(state); }
  LoadReport load(Span<const std::uint8_t> state) { return archive_.load(state); }

 private:
  senses::FusimotorDrives* drives_of(int motor) const;
  observation::Clock clock() const;
  std::uint64_t ticks(std::uint64_t steps) const;
  std::vector<Section> sections();

  engine::ModelPtr model_;
  double step_seconds_;
  std::unique_ptr<render::Renderer> renderer_;
  std::vector<Perception> agents_;
  std::vector<std::int32_t> driven_;
  observation::Observer observer_;
  senses::Soundscape* soundscape_ = nullptr;  // of the observer; null if no agent hears
  observation::LimitedSenses limits_;
  Random random_;
  Episode episode_;
  Archive archive_;
};

}  // namespace mimo::env
