#include "engine/data.h"

#include <mujoco/mjxmacro.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/guard.h"
#include "engine/physics.h"

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace mimo::engine {
namespace {

void free_data(mjData* data) { mj_deleteData(data); }

DataPtr made(const mjModel& model) {
  mjData* data = nullptr;
  const Complaint complaint = guarded([&] { data = mj_makeData(&model); });
  DataPtr owned(data, free_data);
  if (complaint.failed || data == nullptr) {
    fail(Status::kOutOfMemory, "no memory for the simulation's data: {}", complaint.error.data());
  }
  return owned;
}

#if !MIMO_MUJOCO_4

constexpr bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  for (const std::string_view one : names) {
    if (name == one) return true;
  }
  return false;
}

enum class Group { kCleared, kConstraints, kJacobian };

// What is not cleared a step writes before it reads it: as much as it has contacts and constraints.
constexpr Group group_of(std::string_view name) {
  if (is_one_of(name, {"efc_J", "efc_J_colind", "efc_JT", "efc_JT_colind"})) return Group::kJacobian;
  return name == "contact" || name.substr(0, 4) == "efc_" ? Group::kConstraints : Group::kCleared;
}

// How many numbers arrays have that mjData lists as if full. The Jacobian's transpose does need all of that room:
// MuJoCo makes its rows apart from each other before it moves them together.
struct Room {
  std::size_t jacobian;
  std::size_t dual;  // of what only solvers in the space of forces read

  constexpr std::size_t count(std::string_view name, std::size_t listed) const {
    if (is_one_of(name, {"efc_J", "efc_J_colind"})) return jacobian;
    return is_one_of(name, {"efc_AR", "efc_AR_colind"}) ? dual : listed;
  }
};

Room room_of(const mjModel& model) {
  const auto rows = static_cast<std::size_t>(model.njmax);
  return {jacobian_room(model), mj_isDual(&model) != 0 ? rows * rows : 0};
}

// Shows each array of a group with the bytes that it takes.
template <Group kGroup, typename Visit>
void visit_arrays(const mjModel* m, mjData& data, const Room& room, Visit&& visit) {
  MJDATA_POINTERS_PREAMBLE(m)
#define X(type, name, rows, columns)       \
  if constexpr (group_of(#name) == kGroup) \
    visit(data.name,                       \
          sizeof(type) * room.count(#name, static_cast<std::size_t>(m->rows) * static_cast<std::size_t>(columns)));
  MJDATA_POINTERS
#undef X
}

constexpr std::size_t aligned(std::size_t bytes) {
  constexpr std::size_t kAlignment = 64;  // as MuJoCo's own
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

template <Group kGroup>
std::size_t bytes_of(const mjModel& model, mjData& data, const Room& room) {
  std::size_t bytes = 0;
  visit_arrays<kGroup>(&model, data, room, [&](const auto*, std::size_t size) { bytes += aligned(size); });
  return bytes;
}

// Gives arrays their places from `at` on, and returns the end.
template <Group kGroup>
unsigned char* lay_out(const mjModel& model, mjData& data, const Room& room, unsigned char* at) {
  visit_arrays<kGroup>(&model, data, room, [&](auto*& array, std::size_t size) {
    array = reinterpret_cast<std::remove_reference_t<decltype(array)> >(at);
    at += aligned(size);
  });
  return at;
}

// Memory that nobody reads before it is written: of what malloc had given to others before, the system takes the pages
// back.
void leave_to_system([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto start = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  if (start < end) madvise(reinterpret_cast<void*>(start), end - start, MADV_DONTNEED);  // without it all is as usual
#endif
}

// MuJoCo counts the Jacobian's entries by int.
void require_countable(const mjModel& model) {
  if (static_cast<std::int64_t>(model.njmax) * model.nv <= INT_MAX) return;
  fail(Status::kOutOfMemory,
       "no memory for {} constraints (njmax) of {} degrees of freedom: there is room for at most {}", model.njmax,
       model.nv, INT_MAX / model.nv);
}

#endif

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

// Rows concern one joint, or what moves one of two bodies; those of tendons any number: friction, two limits,
// equalities.
std::size_t jacobian_room(const mjModel& model) {
  const auto count = [](int number) { return static_cast<std::size_t>(number); };
  const std::size_t all = count(model.njmax) * count(model.nv);
  if (mj_isSparse(&model) == 0) return all;
  std::vector<int> depth(count(model.nv));
  int deepest = 0;
  for (int dof = 0; dof < model.nv; ++dof) {
    const int parent = model.dof_parentid[dof];
    deepest = std::max(deepest, depth[count(dof)] = 1 + (parent < 0 ? 0 : depth[count(parent)]));
  }
  const auto of_tendons = std::count(model.eq_type, model.eq_type + model.neq, mjEQ_TENDON);
  const std::size_t tendon_rows = 3 * count(model.ntendon) + static_cast<std::size_t>(of_tendons);
  return std::min(all, 2 * count(deepest) * count(model.njmax) + count(model.nv) * tendon_rows);
}

#if MIMO_MUJOCO_4

// The constraints' matrices lie in an arena there, as large as they are in this very step.
DataPtr make_data(const mjModel& model) { return made(model); }

#else

// Constraints lie behind what MuJoCo takes for the whole buffer and clears in a reset: for memory that no code touches
// the system gives none. The Jacobian comes last (engine/scratch.cpp).
DataPtr make_data(const mjModel& model) {
  require_countable(model);
  mjModel unconstrained = model;  // the struct only
  unconstrained.njmax = 0;
  DataPtr data = made(unconstrained);
  const Room room = room_of(model);
  const std::size_t cleared = bytes_of<Group::kCleared>(model, *data, room);
  const std::size_t behind =
      bytes_of<Group::kConstraints>(model, *data, room) + bytes_of<Group::kJacobian>(model, *data, room);
  void* buffer = nullptr;
  const Complaint complaint = guarded([&] { buffer = mju_malloc(cleared + behind); });
  if (complaint.failed || buffer == nullptr || cleared > INT_MAX) {
    mju_free(buffer);
    fail(Status::kOutOfMemory, "no memory for the simulation's data of {} bytes", cleared + behind);
  }
  mju_free(data->buffer);
  data->buffer = buffer;
  data->nbuffer = static_cast<int>(cleared);
  auto* at = lay_out<Group::kCleared>(model, *data, room, static_cast<unsigned char*>(buffer));
  at = lay_out<Group::kConstraints>(model, *data, room, at);
  lay_out<Group::kJacobian>(model, *data, room, at);
  mj_resetData(&model, data.get());
  leave_to_system(static_cast<unsigned char*>(buffer) + cleared, behind);
  leave_to_system(data->stack, sizeof(mjtNum) * static_cast<std::size_t>(data->nstack));
  return data;
}

#endif

int first_bad(const double* values, int count) {
  const double* const end = values + count;
  const double* const bad = std::find_if(values, end, [](double value) { return !(std::abs(value) <= mjMAXVAL); });
  return bad == end ? -1 : static_cast<int>(bad - values);
}

ModelPtr adopt(const HostModel& host) {
  if (host.version != mjVERSION_HEADER) {
    fail(Status::kUnsupported, "mujoco_version is {}, but libmimo runs on MuJoCo {} ({}), whose models differ",
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
