#include "engine/host_model.h"

#include <mujoco/mjxmacro.h>

#include <cstdint>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/data.h"
#include "engine/physics.h"

namespace mimo::engine {
namespace {

// MuJoCo puts all arrays of a struct into one buffer, in the order of its fields. Where that is not what one finds, the
// bytes are no such struct, or one of other sizes.
class BufferWalk {
 public:
  BufferWalk(const void* buffer, std::int64_t bytes)
      : next_(reinterpret_cast<std::uintptr_t>(buffer)), end_(next_ + static_cast<std::uintptr_t>(bytes)) {
    sound_ = buffer != nullptr && bytes >= 0;
  }

  void visit(const void* array, std::size_t size, long long rows, long long columns) {
    const auto start = reinterpret_cast<std::uintptr_t>(array);
    sound_ = sound_ && rows >= 0 && columns >= 0 && start >= next_ && start <= next_ + kGap && start <= end_;
    if (!sound_) return;
    const auto bytes = static_cast<std::uintptr_t>(rows) * static_cast<std::uintptr_t>(columns) * size;
    sound_ = bytes <= end_ - start;
    next_ = start + bytes;
  }

  // Some place in the buffer.
  void skip_to(const void* array) {
    const auto start = reinterpret_cast<std::uintptr_t>(array);
    sound_ = sound_ && start >= next_ && start <= end_;
    if (sound_) next_ = start;
  }

  bool in_bounds() const { return sound_; }
  bool sound() const { return sound_ && end_ - next_ <= 2 * kGap; }

 private:
  static constexpr std::uintptr_t kGap = 64;  // at most, for alignment
  std::uintptr_t next_, end_;
  bool sound_;
};

// Sizes from which MuJoCo's own formulas for the lengths of arrays do not overflow. What counts bytes may be larger,
// and limits of contacts and constraints are -1 where MuJoCo 4 has none.
template <typename Size>
bool is_size(const mjModel& model, const Size& size) {
  constexpr int kMost = (1 << 29) - 1;
  const void* at = &size;
  bool bytes = at == &model.nbuffer;
  int least = 0;
#if MIMO_MUJOCO_4
  bytes = bytes || at == &model.narena;
  if (at == &model.nconmax || at == &model.njmax) least = -1;
#endif
  return size >= least && (bytes || size <= kMost);
}

bool is_sound(const mjModel& model) {
#define X(n) \
  if (!is_size(model, model.n)) return false;
  MIMO_MODEL_SIZES
#undef X
  const mjModel* m = &model;
  BufferWalk walk(m->buffer, m->nbuffer);
  MJMODEL_POINTERS_PREAMBLE(m)
#define X(type, name, rows, columns) walk.visit(m->name, sizeof(type), m->rows, columns);
  MJMODEL_POINTERS
#undef X
  return walk.sound() && model.nbody >= 1;
}

#if MIMO_MUJOCO_4

bool has_room(const mjModel&, const mjData& data) {
  BufferWalk walk(data.arena, data.narena);
  if (data.ncon > 0) walk.skip_to(data.contact);
  if (data.ncon > 0) walk.visit(data.contact, sizeof(mjContact), data.ncon, 1);
  return walk.in_bounds();
}

#else

bool has_room(const mjModel& model, const mjData& data) {
  return data.ncon <= model.nconmax && data.nefc <= model.njmax;
}

#endif

// MuJoCo 4 names more sizes beforehand than its list of arrays uses.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-variable"
bool is_sound(const mjModel& model, const mjData& data) {
  const mjModel* m = &model;
  BufferWalk walk(data.buffer, data.nbuffer);
#if MIMO_MUJOCO_4
  MJMODEL_POINTERS_PREAMBLE(m)
#else
  MJDATA_POINTERS_PREAMBLE(m)
#endif
#define X(type, name, rows, columns) walk.visit(data.name, sizeof(type), m->rows, columns);
  MJDATA_POINTERS
#undef X
  return walk.sound() && data.ncon >= 0 && data.nefc >= 0 && has_room(model, data);
}
#pragma GCC diagnostic pop

// The limits that a step of MuJoCo's has. Senses would make infinite numbers of what is beyond.
void require_sound(const mjModel& model, const mjData& data) {
  struct Part {
    const char* name;
    const double* values;
    int count;
  };
  const auto nq = static_cast<int>(model.nq), nv = static_cast<int>(model.nv);
  for (const auto& [name, values, count] :
       {Part{"qpos", data.qpos, nq}, {"qvel", data.qvel, nv}, {"qacc", data.qacc, nv}}) {
    const int bad = first_bad(values, count);
    if (bad < 0) continue;
    fail(Status::kSimulation, "data: {}[{}] is {}: the host's simulation has diverged", name, bad, values[bad]);
  }
}

void check_size(const char* what, std::size_t theirs, std::size_t ours) {
  if (theirs == 0 || theirs == ours) return;
  fail(Status::kUnsupported, "{} has {} bytes in the host's MuJoCo, but {} in libmimo's", what, theirs, ours);
}

}  // namespace

ModelPtr adopt(const HostModel& host) {
  if (host.version != mjVERSION_HEADER) {
    fail(Status::kUnsupported, "mujoco_version is {}, but libmimo runs on MuJoCo {} ({}), and models are not the same",
         host.version, mujoco_version(), mjVERSION_HEADER);
  }
  check_size("model_size: mjModel", host.model_size, sizeof(mjModel));
  check_size("data_size: mjData", host.data_size, sizeof(mjData));
  require(host.model != nullptr, "model is NULL, expected an mjModel");
  const auto* model = static_cast<const mjModel*>(host.model);
  require(is_sound(*model), "model does not point to an mjModel of MuJoCo {}", mujoco_version());
  return ModelPtr(model, [](const mjModel*) {});
}

const mjData& adopt_data(const mjModel& model, const void* data) {
  require(data != nullptr, "data is NULL, expected an mjData");
  const auto& theirs = *static_cast<const mjData*>(data);
  require(is_sound(model, theirs), "data does not point to an mjData of the model that the senses are attached to");
  require_sound(model, theirs);
  return theirs;
}

}  // namespace mimo::engine
