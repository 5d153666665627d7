/**
 * @file mimo/mimo.hpp
 * libmimo for C++11 and later: handles that free themselves, exceptions, typed views. No logic of its own.
 * MIT licence, see LICENSE.
 *
 *     mimo::Env env = mimo::make("benchmark");
 *     mimo::Block block = env.make_block();
 *     env.reset(42, block);
 *     env.step(actions, block);
 *     mimo::View<const float> angles = block.view<float>(env.field("proprioception/position"));
 *
 * Everything that mimo.h says holds here; its functions take env.get(). A failed call throws mimo::Exception.
 */
#ifndef MIMO_HPP
#define MIMO_HPP

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mimo.h"

/// libmimo for C++, see mimo.hpp.
namespace mimo {

/// What a failed call throws: its status, and the library's message.
class Exception : public std::runtime_error {
 public:
  explicit Exception(mimo_status status) : std::runtime_error(mimo_last_error()), status_(status) {}
  mimo_status status() const noexcept { return status_; }

 private:
  mimo_status status_;
};

inline void check(mimo_status status) {
  if (status != MIMO_OK) throw Exception(status);
}

/// Configs with their defaults.
inline mimo_scene_config scene_config() {
  mimo_scene_config config;
  check(mimo_scene_config_init(&config, sizeof config));
  return config;
}
inline mimo_agent_config agent_config() {
  mimo_agent_config config;
  check(mimo_agent_config_init(&config, sizeof config));
  return config;
}
inline mimo_object_config object_config() {
  mimo_object_config config;
  check(mimo_object_config_init(&config, sizeof config));
  return config;
}
inline mimo_env_config env_config() {
  mimo_env_config config;
  check(mimo_env_config_init(&config, sizeof config));
  return config;
}
inline mimo_picture_config picture_config() {
  mimo_picture_config config;
  check(mimo_picture_config_init(&config, sizeof config));
  return config;
}

inline mimo_model_config model_config() {
  mimo_model_config config;
  check(mimo_model_config_init(&config, sizeof config));
  return config;
}

inline mimo_camera_config camera_config() {
  mimo_camera_config config;
  check(mimo_camera_config_init(&config, sizeof config));
  return config;
}

inline mimo_limits limits() {
  mimo_limits limits;
  check(mimo_limits_init(&limits, sizeof limits));
  return limits;
}

/// Contiguous elements that belong to somebody else.
template <typename T>
class View {
 public:
  View(T *data, std::size_t size) : data_(data), size_(size) {}
  T *data() const { return data_; }
  std::size_t size() const { return size_; }
  T *begin() const { return data_; }
  T *end() const { return data_ + size_; }
  T &operator[](std::size_t i) const { return data_[i]; }

 private:
  T *data_;
  std::size_t size_;
};

/// The dtype of a field for a C++ type.
template <typename T>
struct Dtype;
template <>
struct Dtype<std::uint8_t> {
  static const std::int32_t value = MIMO_U8;
};
template <>
struct Dtype<std::int32_t> {
  static const std::int32_t value = MIMO_I32;
};
template <>
struct Dtype<float> {
  static const std::int32_t value = MIMO_F32;
};
template <>
struct Dtype<double> {
  static const std::int32_t value = MIMO_F64;
};

/// An observation block, aligned to 64 bytes. Views of it live as long as it does.
class Block {
 public:
  explicit Block(std::size_t bytes) : room_(bytes + 63), bytes_(bytes) {}
  /// What was moved from has no bytes.
  Block(Block &&other) noexcept : room_(std::move(other.room_)), bytes_(other.bytes_) { other.bytes_ = 0; }
  Block &operator=(Block &&other) noexcept {
    room_.swap(other.room_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  Block(const Block &other) : Block(other.bytes_) { *this = other; }
  Block &operator=(const Block &other) {
    if (this == &other) return *this;
    room_.resize(other.bytes_ + 63);
    bytes_ = other.bytes_;
    const std::uint8_t *from = other.data();
    std::uint8_t *to = data();
    for (std::size_t i = 0; i < bytes_; ++i) to[i] = from[i];
    return *this;
  }

  std::uint8_t *data() { return room_.data() + padding(); }
  const std::uint8_t *data() const { return room_.data() + padding(); }
  std::size_t bytes() const { return bytes_; }

  /// The elements of a field; throws std::invalid_argument when the field holds another type, std::out_of_range when it
  /// lies outside: it is a field of something else, or the block was moved from.
  template <typename T>
  View<const T> view(const mimo_field &field) const {
    const std::string name = field.name == nullptr ? "the field" : field.name;
    if (field.dtype != Dtype<T>::value) throw std::invalid_argument(name + " has another dtype");
    if (field.bytes > bytes_ || field.offset > bytes_ - field.bytes) {
      throw std::out_of_range(name + " ends at byte " + std::to_string(field.offset + field.bytes) + " of a block of " +
                              std::to_string(bytes_));
    }
    return View<const T>(reinterpret_cast<const T *>(data() + field.offset), field.bytes / sizeof(T));
  }

 private:
  std::size_t padding() const { return (64 - reinterpret_cast<std::uintptr_t>(room_.data()) % 64) % 64; }

  std::vector<std::uint8_t> room_;
  std::size_t bytes_;
};

/// Owns a handle; moves, does not copy.
template <typename T, void (*Destroy)(T *)>
class Handle {
 public:
  explicit Handle(T *handle = nullptr) noexcept : handle_(handle) {}
  ~Handle() { Destroy(handle_); }
  Handle(Handle &&other) noexcept : handle_(other.release()) {}
  Handle &operator=(Handle &&other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;

  T *get() const noexcept { return handle_; }
  T *release() noexcept {
    T *handle = handle_;
    handle_ = nullptr;
    return handle;
  }

 private:
  T *handle_;
};

namespace detail {
inline void destroy_scene(mimo_scene *scene) { mimo_scene_destroy(scene); }
inline void destroy_env(mimo_env *env) { mimo_env_destroy(env); }
inline void destroy_batch(mimo_batch *batch) { mimo_batch_destroy(batch); }
inline void destroy_senses(mimo_senses *senses) { mimo_senses_destroy(senses); }
template <typename T>
Block block_of(const T *handle, mimo_status (*size)(const T *, std::size_t *, std::size_t *)) {
  std::size_t bytes = 0;
  check(size(handle, &bytes, nullptr));
  return Block(bytes);
}
template <typename T>
std::vector<mimo_field> fields_of(const T *handle, mimo_status (*size)(const T *, std::size_t *, std::size_t *),
                                  mimo_status (*describe)(const T *, std::size_t, mimo_field *)) {
  std::size_t count = 0;
  check(size(handle, nullptr, &count));
  std::vector<mimo_field> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i].struct_size = sizeof(mimo_field);
    check(describe(handle, i, &all[i]));
  }
  return all;
}
inline mimo_field field_named(const std::vector<mimo_field> &fields, const std::string &name) {
  for (const mimo_field &candidate : fields) {
    if (name == candidate.name) return candidate;
  }
  throw std::out_of_range("no field named " + name);
}
}  // namespace detail

class Scene : public Handle<mimo_scene, detail::destroy_scene> {
 public:
  explicit Scene(const mimo_scene_config &config) : Handle(create(config)) {}

  std::int32_t add_agent(const mimo_agent_config &config = agent_config()) {
    std::int32_t agent = 0;
    check(mimo_scene_add_agent(get(), &config, &agent));
    return agent;
  }
  void set_touch(double spacing, std::int32_t agent = 0) {
    check(mimo_scene_set_touch(get(), agent, nullptr, spacing));
  }
  void set_touch(const std::string &body, double spacing, std::int32_t agent = 0) {
    check(mimo_scene_set_touch(get(), agent, body.c_str(), spacing));
  }
  void read_joint(const std::string &joint, std::int32_t agent = 0) {
    check(mimo_scene_read_joint(get(), agent, joint.c_str()));
  }
  void limit_sense(const std::string &path, const mimo_limits &limits, std::int32_t agent = 0) {
    check(mimo_scene_limit_sense(get(), agent, path.c_str(), &limits));
  }
  /// All infants that the scene names; returns how many.
  std::size_t add_agents(const mimo_agent_config *config = nullptr) {
    std::size_t count = 0;
    check(mimo_scene_add_agents(get(), config, &count));
    return count;
  }
  void set_room(const std::string &name) { check(mimo_scene_set_room(get(), name.c_str())); }
  void add_model(const mimo_model_config &config) { check(mimo_scene_add_model(get(), &config)); }
  /// Fastens a body to another one, or to the world where other is "", as they start.
  void weld(const std::string &body, const std::string &other = "") {
    check(mimo_scene_weld(get(), body.c_str(), other.empty() ? nullptr : other.c_str(), nullptr));
  }
  /// The same in a pose in the other's frame: position, then quaternion.
  void weld(const std::string &body, const std::string &other, const double (&pose)[7]) {
    check(mimo_scene_weld(get(), body.c_str(), other.empty() ? nullptr : other.c_str(), pose));
  }
  void lock(const std::string &joint, double value) { check(mimo_scene_lock(get(), joint.c_str(), value)); }
  void set_pose(const std::string &joint, double value) { check(mimo_scene_set_pose(get(), joint.c_str(), value)); }
  void add_object(const mimo_object_config &config) { check(mimo_scene_add_object(get(), &config)); }
  void add_camera(const mimo_camera_config &config) { check(mimo_scene_add_camera(get(), &config)); }

  std::string xml() const {
    std::size_t length = 0;
    check(mimo_scene_xml(get(), nullptr, 0, &length));
    std::string text(length + 1, '\0');
    check(mimo_scene_xml(get(), &text[0], text.size(), &length));
    text.resize(length);
    return text;
  }

  void save(const std::string &folder) const { check(mimo_scene_save(get(), folder.c_str())); }

 private:
  static mimo_scene *create(const mimo_scene_config &config) {
    mimo_scene *scene = nullptr;
    check(mimo_scene_create(&config, &scene));
    return scene;
  }
};

/// What a step returns for one agent.
struct Result {
  double reward;
  bool terminated;
  bool truncated;
};

/// The same for all agents, in memory that is made once: Env::make_results.
struct Results {
  std::vector<double> reward;
  std::vector<std::uint8_t> terminated, truncated;
};

class Env : public Handle<mimo_env, detail::destroy_env> {
 public:
  explicit Env(mimo_env *env) : Handle(env) {}
  explicit Env(const Scene &scene, const mimo_env_config &config = env_config()) : Handle(create(scene, config)) {}

  std::size_t agent_count() const {
    std::size_t count = 0;
    check(mimo_env_agent_count(get(), &count));
    return count;
  }
  std::size_t action_size() const {
    std::size_t count = 0;
    check(mimo_env_action_size(get(), &count));
    return count;
  }

  Block make_block() const { return detail::block_of<mimo_env>(get(), mimo_env_observation_size); }
  Results make_results() const {
    const std::size_t count = agent_count();
    return Results{std::vector<double>(count), std::vector<std::uint8_t>(count), std::vector<std::uint8_t>(count)};
  }
  std::vector<mimo_field> fields() const {
    return detail::fields_of<mimo_env>(get(), mimo_env_observation_size, mimo_env_observation_field);
  }
  /// The field of that name; throws std::out_of_range when there is none.
  mimo_field field(const std::string &name) const { return detail::field_named(fields(), name); }

  void reset(std::uint64_t seed, Block &block) { check(mimo_env_reset(get(), &seed, block.data(), block.bytes())); }
  void reset(Block &block) { check(mimo_env_reset(get(), nullptr, block.data(), block.bytes())); }
  void observe(Block &block) { check(mimo_env_observe(get(), block.data(), block.bytes())); }

  /// One step of all agents; an empty vector of actions leaves the controls as they are. Allocates nothing.
  void step(const std::vector<float> &actions, Block &block, Results &results) {
    const std::size_t agents = results.reward.size();
    if (results.terminated.size() != agents || results.truncated.size() != agents) {
      throw std::invalid_argument("vectors of the results differ in length");
    }
    check(mimo_env_step(get(), actions.empty() ? nullptr : actions.data(), actions.size(), block.data(), block.bytes(),
                        results.reward.data(), results.terminated.data(), results.truncated.data(), agents));
  }
  /// The same with results of its own.
  std::vector<Result> step(const std::vector<float> &actions, Block &block) {
    Results all = make_results();
    step(actions, block, all);
    std::vector<Result> results;
    for (std::size_t i = 0; i < all.reward.size(); ++i) {
      results.push_back(Result{all.reward[i], all.terminated[i] != 0, all.truncated[i] != 0});
    }
    return results;
  }

  double time() const {
    double seconds = 0;
    check(mimo_env_time(get(), &seconds));
    return seconds;
  }

  std::int32_t find(std::int32_t kind, const std::string &name) const {
    std::int32_t id = 0;
    check(mimo_env_find(get(), kind, name.c_str(), &id));
    return id;
  }
  std::vector<double> get_values(std::int32_t quantity, const std::vector<std::int32_t> &ids) const {
    std::size_t count = 0;
    check(mimo_env_width(get(), quantity, ids.data(), ids.size(), &count));
    std::vector<double> values(count);
    check(mimo_env_get(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
    return values;
  }
  void set_values(std::int32_t quantity, const std::vector<std::int32_t> &ids, const std::vector<double> &values) {
    check(mimo_env_set(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
  }

  std::string face(std::size_t agent = 0) const {
    const char *name = nullptr;
    check(mimo_env_face(get(), agent, &name));
    return name;
  }
  void set_face(const std::string &name, std::size_t agent = 0) {
    check(mimo_env_set_face(get(), agent, name.c_str()));
  }

  mimo_gaze gaze(std::size_t agent = 0) const {
    mimo_gaze gaze;
    gaze.struct_size = sizeof gaze;
    check(mimo_env_gaze(get(), agent, &gaze));
    return gaze;
  }
  /// Turns the eyes, and the head with MIMO_LOOK_HEAD, to a point at once.
  void look_at(double x, double y, double z, std::int32_t how = MIMO_LOOK_EYES, std::size_t agent = 0) {
    const double point[3] = {x, y, z};
    check(mimo_env_look_at(get(), agent, point, how, nullptr));
  }

  /// Holds a joint at an angle, softly, from the next step on.
  void lock(std::int32_t joint, double angle) { check(mimo_env_lock(get(), joint, angle)); }
  void unlock(std::int32_t joint) { check(mimo_env_unlock(get(), joint)); }
  void set_gravity(double x, double y, double z) { check(mimo_env_set_gravity(get(), x, y, z)); }

  /// Everything that the future depends on; a world that loads it goes on exactly so.
  std::vector<std::uint8_t> save() const {
    std::size_t bytes = 0;
    check(mimo_env_state_size(get(), &bytes));
    std::vector<std::uint8_t> state(bytes);
    check(mimo_env_state_save(get(), state.data(), state.size()));
    return state;
  }
  void load(const std::vector<std::uint8_t> &state) { check(mimo_env_state_load(get(), state.data(), state.size())); }
  /// Another world in the same state.
  Env clone() const {
    mimo_env *twin = nullptr;
    check(mimo_env_clone(get(), &twin));
    return Env(twin);
  }

 private:
  static mimo_env *create(const Scene &scene, const mimo_env_config &config) {
    mimo_env *env = nullptr;
    check(mimo_env_create(scene.get(), &config, &env));
    return env;
  }
};

/// Senses on the program's own MuJoCo model, which outlives them:
///   mimo::Senses senses(scene, model, mj_version(), sizeof(mjModel), sizeof(mjData));
///   mj_step(model, data);
///   senses.observe(data, block);
class Senses : public Handle<mimo_senses, detail::destroy_senses> {
 public:
  Senses(const Scene &scene, const void *model, int mujoco_version, std::size_t model_size, std::size_t data_size,
         const mimo_env_config &config = env_config())
      : Handle(attach(scene, model, mujoco_version, model_size, data_size, config)) {}

  Block make_block() const { return detail::block_of<mimo_senses>(get(), mimo_senses_observation_size); }
  std::vector<mimo_field> fields() const {
    return detail::fields_of<mimo_senses>(get(), mimo_senses_observation_size, mimo_senses_observation_field);
  }
  /// The field of that name; throws std::out_of_range when there is none.
  mimo_field field(const std::string &name) const { return detail::field_named(fields(), name); }

  void observe(const void *data, Block &block) { check(mimo_senses_observe(get(), data, block.data(), block.bytes())); }

 private:
  static mimo_senses *attach(const Scene &scene, const void *model, int mujoco_version, std::size_t model_size,
                             std::size_t data_size, const mimo_env_config &config) {
    mimo_senses *senses = nullptr;
    check(mimo_senses_attach(scene.get(), &config, model, mujoco_version, model_size, data_size, &senses));
    return senses;
  }
};

/// The usual case: a built-in scene with its own infants.
inline Env make(const std::string &scene_name) {
  mimo_env *env = nullptr;
  check(mimo_env_make(scene_name.c_str(), &env));
  return Env(env);
}

/// Many worlds, stepped by a pool of threads. Arrays stack the worlds along their first axis.
class Batch : public Handle<mimo_batch, detail::destroy_batch> {
 public:
  Batch(const Scene &scene, std::size_t worlds, const mimo_env_config &env = env_config())
      : Batch(scene, env, sized(worlds)) {}
  Batch(const Scene &scene, const mimo_env_config &env, const mimo_batch_config &config)
      : Handle(create(scene, env, config)) {}

  std::size_t size() const {
    std::size_t worlds = 0;
    check(mimo_batch_size(get(), &worlds, nullptr));
    return worlds;
  }
  /// One world, which stays the batch's: for mimo_env_ functions, between the batch's own calls.
  mimo_env *world(std::size_t index) {
    mimo_env *env = nullptr;
    check(mimo_batch_world(get(), index, &env));
    return env;
  }
  /// Observations of all worlds; that of world i starts at i times the size of one.
  Block make_blocks() {
    std::size_t bytes = 0;
    check(mimo_env_observation_size(world(0), &bytes, nullptr));
    return Block(bytes * size());
  }

  /// One seed for each world; none: they go on with their own random numbers.
  void reset(const std::vector<std::uint64_t> &seeds, Block &blocks) {
    check(mimo_batch_reset(get(), seeds.empty() ? nullptr : seeds.data(), nullptr, seeds.size(), blocks.data(),
                           blocks.bytes()));
  }
  /// One step; worlds x actions, none leave the controls as they are. `results` says where else it goes, or nullptr.
  void step(const std::vector<float> &actions, Block &blocks, const mimo_batch_results *results = nullptr) {
    check(mimo_batch_step(get(), actions.empty() ? nullptr : actions.data(), actions.size(), blocks.data(),
                          blocks.bytes(), results));
  }

  /// The states of all worlds, one after the other. Loading takes as many, or one for all.
  std::vector<std::uint8_t> save() {
    std::size_t bytes = 0;
    check(mimo_env_state_size(world(0), &bytes));
    std::vector<std::uint8_t> states(bytes * size());
    check(mimo_batch_state_save(get(), nullptr, 0, states.data(), states.size()));
    return states;
  }
  void load(const std::vector<std::uint8_t> &states) {
    check(mimo_batch_state_load(get(), nullptr, 0, states.data(), states.size()));
  }

  void set_face(const std::string &name, std::size_t agent = 0) {
    check(mimo_batch_set_face(get(), agent, name.c_str(), nullptr, 0));
  }

 private:
  static mimo_batch_config sized(std::size_t worlds) {
    mimo_batch_config config;
    check(mimo_batch_config_init(&config, sizeof config));
    config.worlds = static_cast<std::uint32_t>(worlds);
    return config;
  }
  static mimo_batch *create(const Scene &scene, const mimo_env_config &env, const mimo_batch_config &config) {
    mimo_batch *batch = nullptr;
    check(mimo_batch_create(scene.get(), &env, &config, &batch));
    return batch;
  }
};

}  // namespace mimo

#endif
