// A step of a world: its place in the episode, its time, its contacts, and who follows it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/random.h"
#include "base/span.h"
#include "engine/contacts.h"
#include "engine/physics.h"
#include "observation/observer.h"

namespace mimo::env {

// Where an episode is: its step, and the seed of all noise in it.

struct Episode {
  std::uint64_t step = 0;   // that were made
  std::uint64_t noise = 0;  // seed; the same random stream gives the same, and uses up nothing of it

  // `anew`: the stream was just seeded. Else noise goes on from that of the episode before, so that it differs even
  // where nothing draws random numbers.
  void start(const Random& random, bool anew) {
    std::array<std::uint8_t, 32> bytes{};
    ByteWriter writer{Span<std::uint8_t>(bytes)};
    random.save(writer);
    Hash hash;
    hash.add(Span<const std::uint8_t>(bytes));
    if (!anew) hash.add(noise);
    noise = hash.value();
    step = 0;
  }

  // This object outlives it.
  Section section() {
    Section section;
    section.name = "episode";
    section.save = [this](ByteWriter& to) {
      to.put(step);
      to.put(noise);
    };
    section.load = [this](ByteReader& from) {
      step = from.take<std::uint64_t>();
      noise = from.take<std::uint64_t>();
    };
    return section;
  }
};

// Where a step's time goes.

struct Timing {
  std::uint64_t steps = 0;
  double total = 0;
  double physics = 0;
  observation::ShareTimes senses{};
};

// What touched what in an environment step, also where it began and ended between two looks at the world.

// A pair of geoms or flexes, over all its contacts. Vectors are in the world frame, forces act on the second body.
struct StepContact {
  std::array<int, 2> geoms, flexes;                         // -1 where it is the other
  std::array<int, 2> bodies;                                // of a flex: where it touched first
  double start, end;                                        // s, since the step began
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();        // N s
  Eigen::Vector3d peak_force = Eigen::Vector3d::Zero();     // N, of the physics step in which it was largest
  Eigen::Vector3d peak_position = Eigen::Vector3d::Zero();  // m, of the strongest contact then
};

class StepContacts {
 public:
  explicit StepContacts(bool wanted) : wanted_(wanted) {}

  bool wanted() const { return wanted_; }
  // Throws Status::kUnsupported where they are not wanted.
  Span<const StepContact> all() const;

  // An environment step begins.
  void begin() {
    elapsed_ = 0;
    pairs_.clear();
  }
  // A physics step was done.
  void add(const engine::Physics& physics);

 private:
  // What one physics step does to a pair.
  struct Now {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    double strongest = -1;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
  };

  std::size_t find(const engine::Meeting& met);

  bool wanted_;
  double elapsed_ = 0;
  std::vector<StepContact> pairs_;
  std::vector<Now> now_;  // of the pairs
};

// Follows the steps of a world, as a recorder does. Errors in it do not affect the world: the world
// goes on.

class World;

class StepObserver {
 public:
  virtual ~StepObserver() = default;
  // A step begins. Gives the block that is filled: the caller's, or where that is null one of its own, or null.
  virtual std::uint8_t* step_begins(const World& world, std::uint8_t* block) noexcept = 0;
  // The same of a step in which joints follow a known movement.
  virtual std::uint8_t* movement_begins(const World& world, std::uint8_t* block) noexcept = 0;
  virtual void step_ends(World& world, Span<const float> actions, const std::uint8_t* block) noexcept = 0;
  virtual void step_failed() noexcept = 0;
  // Another world has taken the place of the one that is followed.
  virtual void goes_on_in(World& world) noexcept = 0;
  // The last moment in which it can be looked at.
  virtual void ends(const World& world) noexcept = 0;
};

}  // namespace mimo::env
