// A recording that is read, and played again in a world.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "blueprint/aging_world.h"
#include "recording/file.h"
#include "recording/rows.h"

namespace mimo::recording {

// Of all that was compared so far.
struct Verdict {
  bool identical = true;
  double largest = 0;
  std::string table;      // where that is, "" where all is identical
  std::size_t first = 0;  // the first step that differed
  std::size_t steps = 0;  // that were played
};

// How steps are played again.
struct Play {
  bool compares_fields = false;
  bool by_joints = false;    // joints are put where they were, and no state is loaded
  bool has_no_task = false;  // the world's task is one that does nothing, in place of one that is not in the file
};

class Recording {
 public:
  // Throws Status::kUnsupported for what comes from a newer version, kNotFound and kFile for what is no
  // recording.
  explicit Recording(const std::string& path);

  const Reader& file() const { return file_; }
  const std::string& configuration() const { return configuration_; }
  const std::string& seed() const { return seed_; }
  const std::string& build() const { return build_; }
  double step_seconds() const { return step_seconds_; }
  std::size_t steps() const { return steps_; }
  std::size_t states() const { return states_.size(); }
  std::size_t actions() const { return actions_; }
  std::size_t agents() const { return agents_; }
  std::size_t bodies() const { return bodies_; }
  // Versions; "" in recordings before format 3, which hold no world either.
  const std::string& library() const { return library_; }
  const std::string& mujoco() const { return mujoco_; }
  // The calls that made the world besides its scene. Throws where the file has none.
  std::string world() const;
  // A document of the scene, with all its files, of the first infants that were recorded, or of infants of these ages.
  // Throws Status::kUnsupported for ages that were not recorded.
  scene::Source scene() const { return scene_of(0); }
  scene::Source scene(const Growths& growths) const;
  Growths growths() const { return bodies_ == 0 ? Growths() : growths_of_body(0); }

  // To the last kept state that is not behind a step. Returns the state's own step.
  std::size_t seek(blueprint::AgingWorld& target, std::size_t step, const Play& how);
  // Plays the next step.
  void play(blueprint::AgingWorld& target, std::uint8_t* block, const env::Results& results);
  const Verdict& verdict() const { return verdict_; }
  std::size_t next() const { return next_; }

 private:
  struct State {
    std::size_t step;
    bool changed, moves;
    std::size_t body;
  };

  void read_states();
  Growths growths_of_state(std::size_t state) const { return growths_of_body(states_[state].body); }
  Growths growths_of_body(std::size_t body) const;
  scene::Source scene_of(std::size_t body) const;
  void require_same_model(const env::World& world, std::size_t body) const;
  void put_joints(env::World& world, std::uint8_t* block);
  void give_results(const env::Results& results);
  void require_fitting(const env::World& world, bool compare_fields) const;
  void enter(blueprint::AgingWorld& target, std::size_t state);
  // Compares a step that was made, and goes to the next.
  void go_on(const env::World& world, const std::uint8_t* block);
  void act(env::World& world, std::uint8_t* block, const env::Results& results);
  void compare(const env::World& world, const std::uint8_t* block);
  void compare_joints(const env::World& world);
  void compare_results(const env::World& world);
  void compare(const std::string& table, observation::Type type, const void* now, std::size_t bytes);

  Reader file_;
  std::string configuration_, seed_, build_, joint_names_, library_, mujoco_;
  double step_seconds_;
  std::size_t steps_ = 0, actions_ = 0, agents_ = 0, bodies_ = 0;
  std::vector<State> states_;
  // Of a replay.
  const blueprint::AgingWorld* target_ = nullptr;  // null: none has begun
  Play how_;
  std::set<std::string> untold_;  // fields of a task that is not there
  std::size_t next_ = 0, next_state_ = 0;
  Verdict verdict_;
  std::vector<std::uint8_t> own_block_, row_;
  std::vector<float> action_;
  std::vector<double> numbers_;
  StepResults results_;
};

}  // namespace mimo::recording
