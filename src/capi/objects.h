// What the public handles stand for.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/fail.h"
#include "batch/batch.h"
#include "blueprint/aging_world.h"
#include "blueprint/blueprint.h"
#include "capi/handle.h"
#include "capi/results.h"
#include "capi/sense_plan.h"
#include "env/attached.h"
#include "env/description.h"
#include "env/world.h"
#include "mimo/experimental.h"
#include "recording/recorder.h"
#include "recording/recording.h"
#include "stage/stage.h"

namespace mimo::capi {

class RunningSense;

struct SceneObject {
  blueprint::Blueprint blueprint;
  std::vector<std::string> told{};  // texts that mimo_scene_behaviour gave last
};

struct LayoutObject {
  const env::LiveDescription& description;
};

// A layout's handle belongs to what it describes: no call destroys it, and it is retired when that goes.
struct RetireLayout {
  void operator()(mimo_layout* layout) const noexcept;
};
using OwnLayout = std::unique_ptr<mimo_layout, RetireLayout>;
OwnLayout own_layout(const env::LiveDescription& description);

struct BatchObject;

// A world of its own; the view of one in a batch, which answers with the batch's layout; or what functions of a sense
// see of one, which changes nothing.
struct EnvObject {
  EnvObject(blueprint::WorldsByAgePtr worlds, env::CompiledWorldPtr compiled);
  // In the state that another world is in.
  explicit EnvObject(const EnvObject& original);
  EnvObject(BatchObject& all, std::size_t which);
  explicit EnvObject(RunningSense& running);

  blueprint::AgingWorld& aging() const;
  env::World& world() const { return seen == nullptr ? aging().world() : *seen; }  // until a reset to another age

  mimo_env* handle = nullptr;
  // Of a world of its own.
  std::unique_ptr<blueprint::AgingWorld> owned;
  OwnLayout own_layout;
  // Of any.
  const mimo_layout* layout;
  batch::Batch* batch = nullptr;
  const BatchObject* whole = nullptr;  // of that batch
  std::size_t number = 0;
  env::LoadReport loaded;
  bool task_is_missing = false;  // of a recording that had the user's own
  // Of what a sense sees.
  RunningSense* sense = nullptr;
  env::World* seen = nullptr;  // to be read

 private:
  env::Identity identity() const { return {0, 0, &handle}; }  // for tasks of the user's own
};

// For a number that is none of a world's agents.
template <typename Agents>
void check_agent(const Agents& agents, std::size_t agent) {
  require(agent < agents.size(), "agent is {}, but there are {} agents", agent, agents.size());
}

mimo_env* wrap_env(std::unique_ptr<EnvObject> object);

// The handles of a batch's worlds; null until a caller asks for one.
struct Views {
  explicit Views(std::size_t worlds) : handles(worlds) {}
  ~Views();
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  std::vector<mimo_env*> handles;
  std::mutex mutex;  // of these, which several threads may ask for
};

struct BatchObject {
  BatchObject(const blueprint::WorldsByAgePtr& worlds, const batch::CompiledWorlds& compiled,
              const batch::Options& options);
  // The handle of a world, made when first asked for.
  mimo_env* view(std::size_t world);

  const mimo_batch* handle = nullptr;
  // Before the batch, which waits for its work when it goes: tasks may be at work with them until then.
  Views views;
  batch::Batch batch;
  OwnLayout layout;
  env::LoadReport loaded;
};

struct SensesObject {
  SensesObject(const env::CompiledWorld& compiled, double step)
      : attached(compiled, step), description(describe(attached)), layout(own_layout(description)) {}

  env::Attached attached;
  env::LiveDescription description;
  OwnLayout layout;
  env::LoadReport loaded;
};

struct RecorderObject {
  mimo_env* env = nullptr;                        // that is recorded, destroyed or not
  std::shared_ptr<recording::Recorder> recorder;  // which its world has as well
};

// Senses of the user's own by their names.
using Senses = std::map<std::string, std::shared_ptr<SensePlan>>;

struct RecordingObject {
  RecordingObject(const std::string& path, std::string here)
      : recording(std::make_shared<recording::Recording>(path)), build(std::move(here)) {}

  Senses senses;                                    // of the user's own, that the host has brought along
  std::shared_ptr<recording::Recording> recording;  // worlds made of it share it
  std::string build;                                // of this library
};

struct StageObject {
  StageObject(const stage::Given& given, std::size_t threads, LogSink log) : stage(given, threads, std::move(log)) {}

  stage::Stage stage;
};

// Throws if no caller can use the handle now.
inline void require_access(const SceneObject&) {}
void require_access(const EnvObject& env);
inline void require_access(const BatchObject&) {}  // the batch itself knows which calls it takes
inline void require_access(const SensesObject&) {}
inline void require_access(const RecorderObject&) {}
inline void require_access(const RecordingObject&) {}
inline void require_access(const StageObject&) {}
inline void require_access(const LayoutObject&) {}  // any thread may ask it at any time

// Whether this thread is at work for a batch: on one of its worlds, or for a task. Only the address is looked at, so
// the object may be another thread's.
inline bool is_at_work_for(const void*) { return false; }
inline bool is_at_work_for(const BatchObject* object) {
  return object != nullptr && batch::works_for(std::addressof(object->batch));
}

// The batch that a world is part of, where this thread has to share it to use the world: tasks have their world from
// the batch that is at work.
inline const void* whole_of(const void*) { return nullptr; }
inline const mimo_batch* whole_of(const EnvObject* env) {
  return env->batch == nullptr || env->batch->is_at(env->number) ? nullptr : env->whole->handle;
}

// Throws for what nobody may change.
inline void require_changeable(const void*) {}
inline void require_changeable(const EnvObject* env) {
  if (env == nullptr || env->sense == nullptr) return;
  fail(Status::kBusy, "env is lent to a function of a sense, which may only read the world");
}

// Whether a function that a call runs may use the handle of that call as if it had it to itself.
inline bool lends(const void*) { return false; }
inline bool lends(const EnvObject* env) { return env->world().in_task(); }

template <typename Object, HandleType type>
struct Behind {
  using Type = Object;
  static constexpr HandleType kType = type;
};

template <>
struct HandleTraits<mimo_scene> : Behind<SceneObject, HandleType::kScene> {
  static constexpr const char* kName = "scene";
};

template <>
struct HandleTraits<mimo_batch> : Behind<BatchObject, HandleType::kBatch> {
  static constexpr const char* kName = "batch";
};

template <>
struct HandleTraits<mimo_senses> : Behind<SensesObject, HandleType::kSenses> {
  static constexpr const char* kName = "senses";
};

template <>
struct HandleTraits<mimo_recorder> : Behind<RecorderObject, HandleType::kRecorder> {
  static constexpr const char* kName = "recorder";
};

template <>
struct HandleTraits<mimo_recording> : Behind<RecordingObject, HandleType::kRecording> {
  static constexpr const char* kName = "recording";
};

template <>
struct HandleTraits<mimo_stage> : Behind<StageObject, HandleType::kStage> {
  static constexpr const char* kName = "stage";
};

template <>
struct HandleTraits<mimo_layout> : Behind<LayoutObject, HandleType::kLayout> {
  static constexpr const char* kName = "layout";
};

template <>
struct HandleTraits<mimo_env> : Behind<EnvObject, HandleType::kEnv> {
  static constexpr const char* kName = "env";
};

// Worlds: from their configs to options.

mimo_env_config default_env_config();
env::EnvOptions env_options(const mimo_env_config& config);

// `described_at` as WorldsByAge has it.
blueprint::WorldsByAgePtr worlds_of(const blueprint::Blueprint& blueprint, const mimo_env_config& config,
                                    blueprint::WorldsByAge::DescribedAt described_at = {});

// The world of a recording, made of the calls that the file keeps.

std::unique_ptr<EnvObject> make_recorded(const RecordingObject& recording, const mimo_env_config* config,
                                         const mimo_agent_config* senses);
// Throws where its world had no such sense of the user's own.
void check_recorded_sense(const recording::Recording& recording, const std::string& name);

}  // namespace mimo::capi
