// One world: physics, agents with their senses, a task, random numbers.
#pragma once

#include <memory>
#include <vector>

#include "base/random.h"
#include "body/face.h"
#include "engine/physics.h"
#include "engine/present.h"
#include "env/compiled_world.h"
#include "env/perception.h"
#include "env/state.h"
#include "env/step.h"
#include "observation/observer.h"
#include "render/renderer.h"

namespace mimo::senses {
class Soundscape;
}

namespace mimo::env {

// Results of a step, for each agent and each term; empty where they are not wanted.
struct Results {
  Span<double> reward;
  Span<std::uint8_t> terminated;
  Span<std::uint8_t> truncated;
  Span<std::int32_t> outcome{};  // as tasks::Outcome
  Span<double> terms{};          // of all agents, one after the other
};

// What is to be done in a world: as its config says, or else its own task, its document, or "none".
std::string task_of(const EnvOptions& options, const mjModel& model);

class World {
 public:
  World(engine::ModelPtr model, const std::vector<AgentOptions>& agents, const EnvOptions& options,
        const Services& services = {}, const Identity& identity = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const mjModel& model() const { return physics_.model(); }
  const mjData& data() const { return physics_.data(); }
  // For callers that change it: counts as a change.
  engine::Physics& physics() {
    ++changes_;
    return physics_;
  }
  const engine::Physics& physics() const { return physics_; }
  const std::vector<Agent>& agents() const { return agents_; }
  const observation::Layout& layout() const { return observer_.layout(); }
  const observation::LimitedSenses& limits() const { return limits_; }
  const observation::Observer& observer() const { return observer_; }
  std::size_t number() const { return number_; }  // in its batch
  std::uint64_t noise() const { return episode_.noise; }
  std::size_t action_size() const { return action_size_; }
  // Terms of the rewards of all agents.
  std::size_t term_count() const;
  const Timing& timing() const { return timing_; }
  void reset_timing() { timing_ = {}; }

  int frame_skip() const { return options_.frame_skip; }
  double step_seconds() const { return options_.frame_skip * model().opt.timestep; }
  const std::string& task_name() const { return options_.task; }

  // The stream that all of the world's random numbers come from. Drawing one counts as a change.
  Random& random() {
    ++changes_;
    return random_;
  }

  // How often something else than a step may have changed what a state holds: resets, loaded states, values that were
  // set, physics alone, steps that failed. It tells observers of steps whether the world is as the last one left it.
  std::uint64_t changes() const { return changes_; }

  // Whether a task is at work in it right now.
  bool in_task() const { return in_task_; }

  // Whether the episode of any agent has ended, by success, failure or time.
  bool over() const;

  // Goes on from a world of the same agents in other bodies: its random numbers, its episodes' noise, gravity, faces,
  // and what was counted. An episode has to start then.
  void succeed(const World& before);
  // Throws within a task of this world, and where callbacks of the host would act on it.
  void require_ready_to_reset() const;
  // A block may be null: then nothing is observed.
  void reset(const std::uint64_t* seed, std::uint8_t* block);
  // Throws for actions that are no numbers, and for infinite ones where no bounds make them finite.
  void check_actions(Span<const float> actions) const;
  // Without actions the controls stay as they are. Actions are checked.
  void step(Span<const float> actions, std::uint8_t* block, const Results& results);
  // The results of the last step.
  void report(const Results& results) const;
  // Throws for positions of a movement that are too few or too many, not finite, or no orientations.
  void check_movement(Span<const double> positions) const;
  // A step in which joints go where they are told: positions of all joints at the end of each physics step, and room
  // for the forces that it takes, or none. Motors and tasks have no part in it. Positions are checked.
  void follow(Span<const double> positions, Span<double> forces, std::uint8_t* block);
  // Physics alone, with the controls as they are.
  void step_physics(int count);
  void observe(std::uint8_t* block);
  // Poses follow the joints at once, without a step.
  void update_poses() { physics_.update_poses(); }
  // A body plays samples from the next physics step on: see env/sounds.h.
  void play(const std::string& body, Span<const float> samples, double rate);

  // The world's state: see env/state.h. A failed world has none to save.
  std::size_t state_bytes() const { return archive_.bytes(); }
  std::uint64_t model_hash() const { return archive_.model(); }  // by which states tell models apart
  void save(Span<std::uint8_t> state) const;                     // exactly state_bytes()
  // Throws, with nothing changed, for anything but a state of the same model, agents and task. What senses and motor
  // paths remember starts afresh where the state does not hold it.
  LoadReport load(Span<const std::uint8_t> state);
  // In two parts, see Archive.
  LoadReport begin_load(Span<const std::uint8_t> state);
  void finish_load();
  void take_back_load() { archive_.take_back_load(); }

  // The faces of the model, which agents show by their number in this list, in this world only; they outlive resets.
  const std::vector<body::Face>& faces() const { return faces_; }
  void show_face(std::size_t agent, int face);
  int face(std::size_t agent) const;  // -1 for an agent that shows none of them

  // Called after each step; null: none.
  const std::shared_ptr<StepObserver>& step_observer() const { return step_observer_; }
  void tell(std::shared_ptr<StepObserver> observer) { step_observer_ = std::move(observer); }
  // The observer of a world whose place this one has taken.
  void take_step_observer(World& before);
  // Tells the user.
  void warn(const std::string& text) const;

  // What touched what in the last step.
  const StepContacts& step_contacts() const { return step_contacts_; }

  // Draws the world as it is now, with a renderer that is made when first needed.
  void draw(const render::Viewpoint& from, const render::Picture& picture);

 private:
  render::Renderer& renderer();
  void adopt_scene_choices();
  void add_agent(const AgentOptions& options, const Setting& setting, const TaskMaker& make_task,
                 render::Renderer* eyes);
  void add_own_senses(const std::vector<AgentOptions>& agents);
  void let_own_senses_complain() const;
  TaskMaker task_maker(const Identity& identity) const;
  void start();
  void open();
  void babble(const Agent& agent);
  void move_along(Span<const double> positions, Span<double> forces, std::uint8_t* block);
  // Does the work of a step, and tells the observer of it.
  template <typename Work>
  void observed(std::uint8_t* (StepObserver::*begins)(const World&, std::uint8_t*) noexcept, Span<const float> actions,
                std::uint8_t* block, Work&& work);
  void go(Span<const float> actions, std::uint8_t* block, const Results& results);
  // All physics steps of a step; move(i, sensors) makes the one after the first i.
  template <typename Move>
  void advance(Move&& move);
  void step_once(bool sensors);
  enum class Moment { kStart, kStep, kBetween };
  // Without a block only where senses are late, and what they give now is for later.
  void sense(std::uint8_t* block, Moment moment);
  bool judges_senses() const;
  void evaluate(Span<const float> actions, const std::uint8_t* block);
  Span<const float> bounded(const Agent& agent, Span<const float> actions);
  void check_reward(std::size_t agent);
  void require_outside_task() const;
  bool cut_off(const Agent& agent) const;
  void report_warnings();
  observation::Clock clock() const;
  // Ticks of the episode that its whole steps have.
  std::uint64_t ticks() const { return episode_.step * static_cast<std::uint64_t>(options_.frame_skip); }
  void act(Span<const float> actions);
  void apply(const Agent& agent, Span<const float> actions);
  void let_arrive(std::uint64_t tick);
  std::vector<Section> sections();
  void add_sections(Agent& agent, std::vector<Section>& sections);

  EnvOptions options_;
  Services services_;
  engine::ModelPtr shared_model_;
  engine::Physics physics_;
  engine::Present present_;  // of which pictures are drawn
  std::vector<body::Face> faces_;
  StepContacts step_contacts_;
  std::unique_ptr<render::Renderer> own_renderer_;
  std::vector<Agent> agents_;
  observation::Observer observer_;
  std::vector<observation::Sense*> own_senses_;  // of the user's own, among the agents'
  bool sensors_in_each_step_ = false;            // as one of these wants it
  senses::Soundscape* soundscape_ = nullptr;     // of the observer; null if no agent hears
  observation::LimitedSenses limits_;
  Random random_;
  std::size_t number_;  // in its batch
  std::size_t action_size_ = 0;
  std::vector<float> bounded_;  // actions of a step, for tasks
  Episode episode_;
  bool in_task_ = false;  // a task is at work, and must not start or step the world that it is part of
  Timing timing_;
  Archive archive_;
  std::shared_ptr<StepObserver> step_observer_;
  std::uint64_t changes_ = 0;
};

// Where an agent's eyes look, and making them look at a point.

// All throw what body::Eyes does where the agent has no such eyes.
body::Gaze gaze(const World& world, std::size_t agent);
// What looking at a point takes, from the pose that the world is in now.
body::Look look(const World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head);
// The same, and the joints take their angles.
body::Look look_at(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head);

}  // namespace mimo::env
