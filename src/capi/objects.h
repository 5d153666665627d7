// What the public handles stand for.
#pragma once

#include <memory>
#include <vector>

#include "base/fail.h"
#include "batch/batch.h"
#include "blueprint/blueprint.h"
#include "capi/handle.h"
#include "capi/report.h"
#include "env/attached.h"
#include "env/description.h"
#include "env/world.h"
#include "mimo/mimo.h"

namespace mimo::capi {

struct SceneObject {
  blueprint::Blueprint blueprint;
};

struct LayoutObject {
  env::Description description;
};

// A layout's handle belongs to what it describes: no call destroys it, and it is retired when that goes.
struct RetireLayout {
  void operator()(mimo_layout* layout) const noexcept;
};
using OwnLayout = std::unique_ptr<mimo_layout, RetireLayout>;
OwnLayout own_layout(env::Description description);

// A world of its own, or the view of one in a batch, which answers with the batch's layout.
struct EnvObject {
  explicit EnvObject(blueprint::KitPtr of);
  // In the state that a world of this kit is in.
  EnvObject(blueprint::KitPtr of, const env::World& original);
  EnvObject(blueprint::KitPtr of, batch::Batch& all, std::size_t which, const mimo_layout* of_all)
      : kit(std::move(of)), world(all.world(which)), layout(of_all), batch(&all), number(which) {}

  blueprint::KitPtr kit;
  mimo_env* handle = nullptr;
  std::unique_ptr<env::World> owned;
  env::World& world;
  OwnLayout own;  // of a world of its own
  const mimo_layout* layout;
  const batch::Batch* batch = nullptr;
  std::size_t number = 0;
  env::LoadReport loaded;

 private:
  env::Identity identity() const { return {0, 0, &handle}; }  // for tasks of the user's own
};

// For a number that is none of a world's agents.
template <typename Agents>
void check_agent(const Agents& agents, std::size_t agent) {
  require(agent < agents.size(), "agent is {}, but there are {} agents", agent, agents.size());
}

mimo_env* wrap_env(std::unique_ptr<EnvObject> object);

// The handles of a batch's worlds, null for those that nobody has asked for.
struct Views {
  explicit Views(std::size_t worlds) : handles(worlds) {}
  ~Views();
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  std::vector<mimo_env*> handles;
};

struct BatchObject {
  BatchObject(blueprint::KitPtr of, const batch::Options& options);
  // The handle of a world, made when first asked for.
  mimo_env* view(std::size_t world);

  blueprint::KitPtr kit;
  // Before the batch, which waits for its work when it goes: tasks may be at work with them until then.
  Views views;
  OwnLayout layout;
  batch::Batch batch;
  env::LoadReport loaded;
};

struct SensesObject {
  SensesObject(const env::Kit& kit, double step) : attached(kit, step), layout(own_layout(describe(attached))) {}

  env::Attached attached;
  OwnLayout layout;
  env::LoadReport loaded;
};

// Whether a handle may be used by this thread now.
inline void require_access(const SceneObject&) {}
inline void require_access(const EnvObject& env) {
  if (env.batch != nullptr) env.batch->require_access(env.number);
}
inline void require_access(const BatchObject&) {}  // the batch itself knows which calls it takes
inline void require_access(const SensesObject&) {}
inline void require_access(const LayoutObject&) {}  // it never changes

// Views belong to their batch; a task must not pull away the world that it is at work in.
inline bool is_destructible(const SceneObject&) { return true; }
inline bool is_destructible(const EnvObject& env) { return env.batch == nullptr && !env.world.in_task(); }
inline bool is_destructible(const BatchObject& object) { return !object.batch.works_on_this_thread(); }
inline bool is_destructible(const SensesObject&) { return true; }

template <>
struct HandleTraits<mimo_scene> {
  using Type = SceneObject;
  static constexpr HandleType kType = HandleType::kScene;
  static constexpr const char* kName = "scene";
};

template <>
struct HandleTraits<mimo_batch> {
  using Type = BatchObject;
  static constexpr HandleType kType = HandleType::kBatch;
  static constexpr const char* kName = "batch";
};

template <>
struct HandleTraits<mimo_senses> {
  using Type = SensesObject;
  static constexpr HandleType kType = HandleType::kSenses;
  static constexpr const char* kName = "senses";
};

template <>
struct HandleTraits<mimo_layout> {
  using Type = LayoutObject;
  static constexpr HandleType kType = HandleType::kLayout;
  static constexpr const char* kName = "layout";
};

template <>
struct HandleTraits<mimo_env> {
  using Type = EnvObject;
  static constexpr HandleType kType = HandleType::kEnv;
  static constexpr const char* kName = "env";
};

}  // namespace mimo::capi
