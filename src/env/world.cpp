#include "env/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/names.h"
#include "body/body.h"
#include "engine/model.h"
#include "engine/present.h"
#include "env/perception.h"
#include "env/reflexes.h"
#include "env/surroundings.h"
#include "senses/fusimotor_drives.h"
#include "senses/hearing/soundscape.h"
#include "sound/vocal.h"

namespace mimo::env {
namespace {

constexpr int kFrameSkip = 2;  // where neither config nor scene say
constexpr const char* kCustomTask = "custom";

// True as long as this lives.
class Flag {
 public:
  explicit Flag(bool& flag) : flag_(flag) { flag_ = true; }
  ~Flag() { flag_ = false; }
  Flag(const Flag&) = delete;
  Flag& operator=(const Flag&) = delete;

 private:
  bool& flag_;
};

body::Eyes eyes_of(const World& world, std::size_t agent) {
  return body::Eyes(world.model(), world.agents()[agent].body);
}

}  // namespace

World::World(engine::ModelPtr model, const std::vector<AgentOptions>& agents, const EnvOptions& options,
             const Services& services, const Identity& identity)
    : options_(options),
      services_(services),
      shared_model_(std::move(model)),
      physics_(shared_model_, options.physics),
      faces_(body::faces_of(physics_.model())),
      step_contacts_(options.step_contacts),
      limits_(observer_),
      random_(identity.seed),
      number_(identity.number) {
  adopt_scene_choices();
  body::read_stored_pose(physics_.model(), physics_.start());
  const TaskMaker make_task = task_maker(identity);
  render::Renderer* eyes = draws(agents, options_) ? &renderer() : nullptr;
  const double tick = physics_.model().opt.timestep;
  soundscape_ = add_soundscape(observer_, physics_.model(), tick, agents, options_);
  const Setting setting{tick, things_of(physics_.model(), agents, options_),
                        static_cast<std::size_t>(options_.frame_skip), soundscape_};
  for (const AgentOptions& agent : agents) add_agent(agent, setting, make_task, eyes);
  for (const CameraOptions& camera : options_.cameras) observer_.add(make_camera(physics_.model(), camera, eyes));
  add_own_senses(agents);
  if (options_.further_sense) observer_.add(options_.further_sense(physics_.model(), this));
  for (std::size_t i = 0; i < agents.size(); ++i) {
    limits_.add(agents[i].prefix(), agents[i].limits, nature_of_senses(physics_.model(), agents_[i], agents[i]),
                clock());
  }
  limits_.make_room();
  bounded_.resize(action_size_);
  start();
  episode_.start(random_, true);
  sense(nullptr, Moment::kStart);
  archive_ = Archive(engine::fingerprint(*shared_model_), sections());
  report_warnings();
  let_own_senses_complain();
}

World::~World() {
  if (step_observer_ != nullptr) step_observer_->ends(*this);
}

void World::take_step_observer(World& before) {
  step_observer_ = std::move(before.step_observer_);
  if (step_observer_ != nullptr) step_observer_->goes_on_in(*this);
}

void World::warn(const std::string& text) const {
  services_.log({LogLevel::kWarning, text, 0, true, number_, data().time});
}

void World::add_agent(const AgentOptions& options, const Setting& setting, const TaskMaker& make_task,
                      render::Renderer* eyes) {
  const std::size_t number = agents_.size();
  const SkinPtr shared = services_.skins == nullptr ? nullptr : services_.skins->of(number);
  Agent agent = make_agent(physics_, options, setting, make_task, number, eyes, shared);
  if (services_.skins != nullptr) services_.skins->keep(number, agent.skin);
  agent.path =
      actuation::MotorPath::make(*agent.actuation, options.prefix(), options.motors,
                                 motor_delays(physics_.model(), agent.body, *agent.actuation, options), clock());
  agent.action_offset = action_size_;
  action_size_ += agent.actuation->size();
  for (const auto& sense : agent.senses) observer_.add(*sense);
  agents_.push_back(std::move(agent));
}

// Behind all senses of all agents, which they may look at.
void World::add_own_senses(const std::vector<AgentOptions>& agents) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    for (const OwnSense& own : agents[i].own_senses) {
      add_sense(agents_[i], agents[i], own.make(*this, i, own.values));
      own_senses_.push_back(agents_[i].senses.back().get());
      observer_.add(*own_senses_.back());
      sensors_in_each_step_ = sensors_in_each_step_ || own_senses_.back()->follows_sensors();
    }
  }
}

// What they did wrong is told when everything else has happened.
void World::let_own_senses_complain() const {
  for (observation::Sense* sense : own_senses_) sense->complain();
}

void World::require_outside_task() const {
  if (in_task_) fail(Status::kBusy, "a task may not reset, step or load the world that runs it");
}

void World::succeed(const World& before) {
  changes_ = before.changes_ + 1;
  random_ = before.random_;
  episode_ = before.episode_;
  timing_ = before.timing_;
  physics_.succeed(before.physics_);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (const int shown = before.face(i); shown >= 0) show_face(i, shown);
  }
}

void World::require_ready_to_reset() const {
  require_outside_task();
  physics_.require_undisturbed();
}

std::string task_of(const EnvOptions& options, const mjModel& model) {
  if (!options.task.empty()) return options.task;
  if (options.custom_task) return kCustomTask;
  const std::string own = engine::custom_text(model, names::kTask);
  return own.empty() ? "none" : own;
}

// What the config leaves open, the scene's document may say.
void World::adopt_scene_choices() {
  options_.task = task_of(options_, model());
  if (options_.frame_skip > 0) return;
  const Span<const double> own = engine::custom_numbers(model(), names::kFrameSkip);
  options_.frame_skip =
      own.size() == 1 && own[0] >= 1 && own[0] <= kMostFrameSkip ? static_cast<int>(own[0]) : kFrameSkip;
}

TaskMaker World::task_maker(const Identity& identity) const {
  if (options_.task == kCustomTask && options_.custom_task) {
    return [this, identity](const mjModel&, const body::Body&, std::size_t agent) {
      return options_.custom_task(identity, agent);
    };
  }
  const tasks::Definition& task = tasks::definition(options_.task);
  return [this, &task](const mjModel& model, const body::Body& body, std::size_t) {
    return task.make(model, body, options_.parameters);
  };
}

// The stored state, before any task.
void World::start() {
  physics_.reset();
  step_contacts_.begin();
  for (const Agent& agent : agents_) {
    agent.actuation->reset(physics_);
    if (agent.voice) *agent.voice = {};
    if (agent.path) agent.path->forget();
    if (agent.drives) agent.drives->reset();
  }
}

// What the task lets pass before an episode begins. Nothing that remembers the last one has a part in it.
void World::open() {
  tasks::Opening opening;
  for (const Agent& agent : agents_) opening = agent.task->opening();  // all have the same task
  for (int step = 0; step < opening.still + opening.random; ++step) {
    for (const Agent& agent : agents_) {
      if (step >= opening.still) babble(agent);
      agent.actuation->advance(physics_);
    }
    physics_.step(1, false);
  }
}

// Numbers of others that an action may set stay as they are.
void World::babble(const Agent& agent) {
  const actuation::Actuation& actuation = *agent.actuation;
  const Span<float> actions(bounded_.data() + agent.action_offset, actuation.size());
  for (std::size_t i = 0; i < actuation.size(); ++i) {
    const bool moves = i < actuation.commands();
    const auto low = static_cast<double>(actuation.low()[i]), high = static_cast<double>(actuation.high()[i]);
    actions[i] = moves ? static_cast<float>(random_.uniform(low, high)) : std::numeric_limits<float>::quiet_NaN();
  }
  agent.actuation->apply({actions.data(), actions.size()}, physics_);
}

render::Renderer& World::renderer() {
  if (services_.renderer != nullptr) return *services_.renderer;
  if (own_renderer_ == nullptr) own_renderer_ = make_renderer(shared_model_, options_, services_);
  return *own_renderer_;
}

bool draws(const std::vector<AgentOptions>& agents, const EnvOptions& options) {
  const auto sees = [](const AgentOptions& agent) { return agent.vision.wanted != 0; };
  return options.renderer != RendererChoice::kNone &&
         (!options.cameras.empty() || std::any_of(agents.begin(), agents.end(), sees));
}

void World::reset(const std::uint64_t* seed, std::uint8_t* block) {
  require_ready_to_reset();
  ++changes_;
  if (seed != nullptr) random_.reseed(*seed);
  episode_.start(random_, seed != nullptr);
  start();
  {
    const Flag at_work(in_task_);
    for (const Agent& agent : agents_) {
      agent.task->clear();
      agent.task->reset(physics_, random_);
    }
  }
  open();
  physics_.data().time = 0;
  physics_.forward();
  sense(block, Moment::kStart);
  report_warnings();
  let_own_senses_complain();
}

void World::check_actions(Span<const float> actions) const {
  for (std::size_t i = 0; i < actions.size(); ++i) require(!std::isnan(actions[i]), "action[{}] is not a number", i);
  if (actions.empty()) return;
  for (const Agent& agent : agents_) {
    const actuation::Actuation& actuation = *agent.actuation;
    for (std::size_t i = 0; i < actuation.size(); ++i) {
      const std::size_t at = agent.action_offset + i;
      require(std::isfinite(std::clamp(actions[at], actuation.low()[i], actuation.high()[i])),
              "action[{}] is {}, expected a finite number: it has no bounds", at, actions[at]);
    }
  }
}

template <typename Move>
void World::advance(Move&& move) {
  step_contacts_.begin();
  for (int i = 1; i <= options_.frame_skip; ++i) {
    const std::uint64_t tick = ticks() + static_cast<std::uint64_t>(i);
    const bool last = i == options_.frame_skip, sensed = !last && limits_.wants(tick);
    move(i - 1, last || sensed || sensors_in_each_step_);
    observer_.advance(model(), data(), options_.timing ? &timing_.senses : nullptr);
    for (const Agent& agent : agents_) agent.task->watch(physics_);
    if (sensed) limits_.pass(model(), data(), tick, options_.timing ? &timing_.senses : nullptr);
  }
  ++episode_.step;
  if (options_.timing) ++timing_.steps;
}

void World::step(Span<const float> actions, std::uint8_t* block, const Results& results) {
  require_outside_task();
  physics_.require_usable();
  physics_.require_undisturbed();
  observed(&StepObserver::step_begins, actions, block, [&](std::uint8_t* filled) { go(actions, filled, results); });
}

template <typename Work>
void World::observed(std::uint8_t* (StepObserver::*begins)(const World&, std::uint8_t*) noexcept,
                     Span<const float> actions, std::uint8_t* block, Work&& work) {
  if (step_observer_ == nullptr) return work(block);
  const std::shared_ptr<StepObserver> observer = step_observer_;  // a task or the log may let it go
  std::uint8_t* const filled = (*observer.*begins)(*this, block);
  try {
    work(filled);
  } catch (...) {
    ++changes_;
    observer->step_failed();
    throw;
  }
  observer->step_ends(*this, actions, filled);
}

void World::go(Span<const float> actions, std::uint8_t* block, const Results& results) {
  const observation::Stopwatch total(options_.timing, timing_.total);
  act(actions);
  advance([this](int done, bool sensors) {
    let_arrive(ticks() + static_cast<std::uint64_t>(done));
    const observation::Stopwatch watch(options_.timing, timing_.physics);
    step_once(sensors);
  });
  const bool senses_first = judges_senses();
  if (senses_first) sense(block, Moment::kStep);
  evaluate(actions, block);
  if (!senses_first) sense(block, Moment::kStep);
  if (senses_first && block != nullptr) observer_.observe_share(observation::Share::kTask, model(), data(), block);
  report(results);
  report_warnings();
  let_own_senses_complain();
}

void World::check_movement(Span<const double> positions) const {
  const auto nq = static_cast<std::size_t>(model().nq), skip = static_cast<std::size_t>(options_.frame_skip);
  require(positions.size() == skip * nq, "movement: position_count is {}, expected {}: {} for each of {} physics steps",
          positions.size(), skip * nq, nq, skip);
  check_finite(positions.data(), positions.size(), "movement: positions");
  for (std::size_t moment = 0; moment < positions.size(); moment += nq) {
    for (int joint = 0; joint < model().njnt; ++joint) {
      const int place = engine::quaternion_place(model().jnt_type[joint]);
      if (place < 0) continue;
      const std::size_t first = moment + static_cast<std::size_t>(model().jnt_qposadr[joint] + place);
      require(Eigen::Map<const Eigen::Vector4d>(&positions[first]).squaredNorm() > 1e-20,
              "movement: positions[{}] begins a quaternion of length 0", first);
    }
  }
}

void World::follow(Span<const double> positions, Span<double> forces, std::uint8_t* block) {
  require_outside_task();
  physics_.require_usable();
  physics_.require_undisturbed();
  if (model().opt.integrator != mjINT_EULER) {
    fail(Status::kUnsupported, "only models with MuJoCo's integrator Euler can follow movements");
  }
  observed(&StepObserver::movement_begins, {}, block,
           [&](std::uint8_t* filled) { move_along(positions, forces, filled); });
}

void World::move_along(Span<const double> positions, Span<double> forces, std::uint8_t* block) {
  const observation::Stopwatch total(options_.timing, timing_.total);
  ++changes_;
  const auto nq = static_cast<std::size_t>(model().nq), nv = static_cast<std::size_t>(model().nv);
  advance([&](int done, bool sensors) {
    const auto number = static_cast<std::size_t>(done);
    const observation::Stopwatch watch(options_.timing, timing_.physics);
    physics_.follow(positions.data() + number * nq, forces.empty() ? nullptr : forces.data() + number * nv, sensors);
    if (step_contacts_.wanted()) step_contacts_.add(physics_);
  });
  sense(block, Moment::kStep);
  report_warnings();
  let_own_senses_complain();
}

void World::act(Span<const float> actions) {
  for (const Agent& agent : agents_) {
    Span<const float> own;
    if (!actions.empty()) {
      own = agent.task->disturb(actions.part(agent.action_offset, agent.actuation->size()), random_);
    }
    if (agent.path) {
      agent.path->send(own, episode_.noise, episode_.step);
    } else if (!own.empty()) {
      apply(agent, own);
    }
  }
}

void World::apply(const Agent& agent, Span<const float> actions) {
  agent.actuation->apply(actions, physics_);
  if (agent.reflexes != nullptr) agent.reflexes->follow(actions, physics_);
}

void World::let_arrive(std::uint64_t tick) {
  for (const Agent& agent : agents_) {
    if (!agent.path) continue;
    const Span<const float> own = agent.path->arrive(tick);
    if (!own.empty()) apply(agent, own);
  }
}

observation::Clock World::clock() const {
  return {model().opt.timestep, static_cast<std::size_t>(options_.frame_skip), true};
}

void World::step_physics(int count) {
  require_outside_task();
  physics_.require_usable();
  physics_.require_undisturbed();
  ++changes_;
  step_contacts_.begin();
  for (int i = 0; i < count; ++i) {
    step_once(i + 1 == count || sensors_in_each_step_);
    observer_.advance(model(), data(), nullptr);
  }
  let_own_senses_complain();
}

void World::step_once(bool sensors) {
  for (const Agent& agent : agents_) {
    if (agent.reflexes != nullptr) agent.reflexes->act(physics_);
    agent.actuation->advance(physics_);
  }
  physics_.step(1, sensors);
  if (step_contacts_.wanted()) step_contacts_.add(physics_);
}

void World::observe(std::uint8_t* block) {
  physics_.forward();
  sense(block, Moment::kBetween);
  let_own_senses_complain();
}

// Only steps are timed: looking in between would blur what a step costs.
void World::sense(std::uint8_t* block, Moment moment) {
  if (moment == Moment::kStart) observer_.begin(model(), data());
  switch (moment) {
    case Moment::kStart: return limits_.begin(model(), data(), block, episode_.noise);
    case Moment::kStep:
      return limits_.step(model(), data(), block, episode_.noise, ticks(), options_.timing ? &timing_.senses : nullptr);
    case Moment::kBetween:
      if (block != nullptr) limits_.look(model(), data(), block, episode_.noise, ticks());
  }
}

// Built-in tasks turn the head after they have judged, before senses; those of the user's own come after senses, which
// they look at.
bool World::judges_senses() const {
  return std::any_of(agents_.begin(), agents_.end(), [](const Agent& agent) { return agent.task->judges_senses(); });
}

// Rewards belong to what the last physics step started from; then a task may turn the head.
void World::evaluate(Span<const float> actions, const std::uint8_t* block) {
  const Flag at_work(in_task_);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_[i];
    const double effort = agent.actuation->effort(model(), data());
    const Span<const std::uint8_t> sensed(block, block == nullptr ? 0 : layout().bytes());
    agent.task->consider({episode_.step, effort, bounded(agent, actions), sensed});
    agent.task->evaluate(physics_);
    check_reward(i);
  }
  for (const Agent& agent : agents_) agent.task->follow(physics_);
}

Span<const float> World::bounded(const Agent& agent, Span<const float> actions) {
  if (actions.empty()) return {};
  const actuation::Actuation& actuation = *agent.actuation;
  float* own = bounded_.data() + agent.action_offset;
  for (std::size_t i = 0; i < actuation.size(); ++i) {
    own[i] = std::clamp(actions[agent.action_offset + i], actuation.low()[i], actuation.high()[i]);
  }
  return {own, actuation.size()};
}

// A task that gave no number gave nothing: a world's state holds numbers only.
void World::check_reward(std::size_t agent) {
  tasks::Task& task = *agents_[agent].task;
  const double reward = task.reward();
  if (std::isfinite(reward)) return;
  task.clear();
  fail(Status::kTask, "the task's function evaluate gave agent {} the reward {}, expected a finite number", agent,
       reward);
}

std::size_t World::term_count() const {
  std::size_t count = 0;
  for (const Agent& agent : agents_) count += agent.task->terms().size();
  return count;
}

void World::report(const Results& results) const {
  std::size_t next_term = 0;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const tasks::Task& task = *agents_[i].task;
    if (!results.reward.empty()) results.reward[i] = task.reward();
    if (!results.terminated.empty()) results.terminated[i] = task.over() ? 1 : 0;
    if (!results.truncated.empty()) results.truncated[i] = cut_off(agents_[i]) ? 1 : 0;
    if (!results.outcome.empty()) results.outcome[i] = static_cast<std::int32_t>(task.outcome());
    if (results.terms.empty()) continue;
    for (const tasks::Term& term : task.terms()) results.terms[next_term++] = term.value;
  }
}

bool World::cut_off(const Agent& agent) const {
  if (agent.task->cut_off()) return true;
  const std::uint64_t limit = options_.max_steps > 0 ? options_.max_steps : agent.task->episode_steps();
  return limit > 0 && episode_.step >= limit;
}

bool World::over() const {
  return std::any_of(agents_.begin(), agents_.end(),
                     [this](const Agent& agent) { return agent.task->over() || cut_off(agent); });
}

void World::show_face(std::size_t agent, int face) {
  ++changes_;
  physics_.paint(agents_[agent].faces.geom, faces_[static_cast<std::size_t>(face)].material);
}

int World::face(std::size_t agent) const {
  const body::Face* shown = agents_[agent].faces.shown(model());
  const auto same = [shown](const body::Face& face) { return shown != nullptr && face.material == shown->material; };
  const auto found = std::find_if(faces_.begin(), faces_.end(), same);
  return found == faces_.end() ? -1 : static_cast<int>(found - faces_.begin());
}

void World::draw(const render::Viewpoint& from, const render::Picture& picture) {
  render::Renderer& drawing = renderer();
  const mjData& now = present_.of(physics_);
  drawing.draw(model(), now, render::view_from(model(), now, from), picture);
}

void World::play(const std::string& body, Span<const float> samples, double rate) {
  ++changes_;
  env::play(soundscape_, model(), body, samples, rate);
}

void World::save(Span<std::uint8_t> state) const {
  physics_.require_usable();
  archive_.save(state);
}

LoadReport World::load(Span<const std::uint8_t> state) {
  LoadReport report = begin_load(state);
  finish_load();
  return report;
}

LoadReport World::begin_load(Span<const std::uint8_t> state) {
  require_outside_task();
  ++changes_;
  return archive_.begin_load(state);
}

void World::finish_load() {
  archive_.finish_load();
  step_contacts_.begin();
}

void World::report_warnings() {
  if (!services_.log) return;
  for (const engine::Note& note : physics_.take_warnings()) {
    services_.log({LogLevel::kWarning, note.text, static_cast<int>(note.kind), true, number_, data().time});
  }
}

body::Gaze gaze(const World& world, std::size_t agent) { return eyes_of(world, agent).gaze(world.data()); }

body::Look look(const World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  const body::Eyes eyes = eyes_of(world, agent);
  engine::Present present;
  return eyes.look_at(world.model(), present.of(world.physics()), point, turn_head);
}

body::Look look_at(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  body::Look wanted = look(world, agent, point, turn_head);
  engine::Physics& physics = world.physics();
  for (const body::JointAngle& joint : wanted.angles) physics.data().qpos[joint.qpos] = joint.angle;
  physics.update_poses();
  return wanted;
}

}  // namespace mimo::env
