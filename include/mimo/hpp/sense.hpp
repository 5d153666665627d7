/**
 * @file mimo/hpp/sense.hpp
 * Senses of your own, which run in each physics step and observation. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_SENSE
#define MIMO_HPP_SENSE

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "recording.hpp"
#include "task.hpp"

namespace mimo {
inline namespace v1_0 {

/// A field that a sense fills. Each agent has its own.
struct SenseField {
  /// "" : the field has the sense's name. Without a shape it is one number.
  explicit SenseField(std::string name_ = "", std::vector<std::size_t> shape_ = {}, std::string unit_ = "",
                      std::string frame_ = "")
      : name(std::move(name_)), shape(std::move(shape_)), unit(std::move(unit_)), frame(std::move(frame_)) {}

  std::string name;
  std::vector<std::size_t> shape;
  std::string unit, frame;
  /// MIMO_F32, MIMO_U8, MIMO_I32 or MIMO_F64.
  std::int32_t dtype = MIMO_F32;
  /// Bounds of the values.
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  /// A name for each number; empty: none.
  std::vector<std::string> labels;
  /// A field of touch whose receptors the first axis counts; "": none. `receptors` chooses among them; empty: all.
  std::string skin;
  std::vector<std::int32_t> receptors;
  /// How fast the nerves of a skin field conduct, m/s; 0: as fast as large fibres.
  double nerve_speed = 0;
};

/// What a function of a sense is told: the world, to be read, and the moment.
class SenseMoment {
 public:
  SenseMoment(const Env &world_, const mimo_sense_moment &told_) : world(world_), told(told_) {}

  /// Its const functions work; everything else fails with MIMO_E_BUSY.
  const Env &world;
  const mimo_sense_moment &told;

  /// What the sense remembers. In write it may only be read.
  template <typename T>
  T &memory() const {
    return *static_cast<T *>(told.memory);
  }
  /// In write: the values of the index-th field, all zero.
  template <typename T = float>
  T *field(std::size_t index) const {
    return static_cast<T *>(told.fields[index]);
  }
  /// A field (Layout::find) as its own sense has it now.
  template <typename T = float>
  const T *feel(std::size_t field) const {
    const void *values = nullptr;
    check(mimo_sense_feel(world.get(), field, &values));
    return static_cast<const T *>(values);
  }
  /// A normal number that follows from the seed, the tick and this number.
  double noise(std::uint64_t number) const { return mimo_sense_noise(told.seed, told.tick, number); }
};

/// What the constructor of a sense is given, for one agent of one world.
class SenseOpening : public SenseMoment {
 public:
  SenseOpening(const Env &world_, const mimo_sense_moment &told_) : SenseMoment(world_, told_) {}

  /// Declares a field.
  void add(const SenseField &field) const {
    mimo_sense_field raw = detail::defaults(mimo_sense_field_init);
    std::vector<const char *> labels;
    for (const std::string &label : field.labels) labels.push_back(label.c_str());
    raw.dtype = field.dtype;
    raw.name = field.name.empty() ? nullptr : field.name.c_str();
    raw.unit = field.unit.c_str();
    raw.frame = field.frame.c_str();
    raw.shape = field.shape.data();
    raw.ndim = field.shape.size();
    raw.low = field.low;
    raw.high = field.high;
    raw.labels = labels.empty() ? nullptr : labels.data();
    raw.label_count = labels.size();
    raw.skin = field.skin.empty() ? nullptr : field.skin.c_str();
    raw.receptors = field.receptors.empty() ? nullptr : field.receptors.data();
    raw.receptor_count = field.receptors.size();
    raw.nerve_speed = field.nerve_speed;
    check(mimo_sense_add_field(world.get(), &raw));
  }
  /// A name of this agent's: a field, or a part of an infant in the model.
  std::string own(const std::string &name) const { return told.prefix + name; }

  /// Bytes of memory.
  std::size_t memory_bytes = 0;
  /// Whether advance looks at MuJoCo's sensors: see mimo_sense_needs.
  bool sensors = false;
};

/// A sense of your own, of one agent in one world. Its constructor takes a SenseOpening, looks up what it needs and
/// declares its fields. What changes belongs into the memory: its functions are const. What they throw fails the call
/// that runs them.
class Sense {
 public:
  Sense() = default;
  virtual ~Sense() = default;
  Sense(const Sense &) = delete;
  Sense &operator=(const Sense &) = delete;

  /// Its parameters, in the order of moment.told.parameters; a class with some hides this with a function of its own.
  static std::vector<mimo_parameter> parameters() { return {}; }

  /// An episode starts; the memory is zero.
  virtual void reset(const SenseMoment &) const {}
  /// After each physics step.
  virtual void advance(const SenseMoment &) const {}
  /// Fills the fields. It runs as often as somebody looks, and changes nothing else.
  virtual void write(const SenseMoment &) const = 0;
};

/// A parameter of a sense.
inline mimo_parameter sense_parameter(const char *name, const char *description, double standard, double low,
                                      double high) {
  mimo_parameter parameter = {};
  parameter.struct_size = sizeof parameter;
  parameter.name = name;
  parameter.description = description;
  parameter.standard = standard;
  parameter.low = low;
  parameter.high = high;
  return parameter;
}

namespace detail {
template <typename Mine>
mimo_status open_sense(void *, const mimo_env *world, const mimo_sense_moment *moment, mimo_sense_needs *needs) {
  Borrowed borrowed(const_cast<mimo_env *>(world));
  return task_status([&] {
    SenseOpening opening(borrowed.env, *moment);
    Sense *sense = new Mine(opening);
    needs->own = sense;
    needs->memory_bytes = opening.memory_bytes;
    needs->sensors = opening.sensors ? 1 : 0;
  });
}
inline void close_sense(void *, void *own) { delete static_cast<Sense *>(own); }
template <void (Sense::*function)(const SenseMoment &) const>
mimo_status run_sense(void *, const mimo_env *world, const mimo_sense_moment *moment) {
  Borrowed borrowed(const_cast<mimo_env *>(world));
  return task_status([&] {
    const SenseMoment now(borrowed.env, *moment);
    (static_cast<const Sense *>(moment->own)->*function)(now);
  });
}
}  // namespace detail

/// The table of a class that derives from Sense, for Scene::add_sense and MIMO_SENSE. The name lives as long as the
/// table. Raise the version when the memory changes its meaning.
template <typename Mine>
mimo_sense sense(const char *name, std::uint32_t version = 0) {
  static const std::vector<mimo_parameter> parameters = Mine::parameters();
  mimo_sense table = detail::defaults(mimo_sense_init);
  table.interface_version = MIMO_SENSE_INTERFACE;
  table.name = name;
  table.version = version;
  table.parameters = parameters.data();
  table.parameter_count = parameters.size();
  table.open = detail::open_sense<Mine>;
  table.close = detail::close_sense;
  table.reset = detail::run_sense<&Sense::reset>;
  table.advance = detail::run_sense<&Sense::advance>;
  table.write = detail::run_sense<&Sense::write>;
  return table;
}

inline void Scene::add_sense(const mimo_sense &sense, std::size_t agent) {
  check(mimo_scene_add_sense(get(), agent, &sense));
}
inline void Scene::load_sense(const std::string &path, std::size_t agent) {
  check(mimo_scene_load_sense(get(), agent, path.c_str()));
}
inline std::vector<mimo_parameter> Scene::sense_parameters() const {
  std::vector<mimo_parameter> all;
  for (mimo_parameter one = detail::described<mimo_parameter>();; all.push_back(one)) {
    const mimo_status status = mimo_scene_sense_parameter(get(), all.size(), &one);
    if (status == MIMO_E_NOT_FOUND) return all;
    check(status);
  }
}
inline void Recording::add_sense(const mimo_sense &sense) { check(mimo_recording_add_sense(get(), &sense)); }
inline void Recording::load_sense(const std::string &path) { check(mimo_recording_load_sense(get(), path.c_str())); }

}  // namespace v1_0
}  // namespace mimo

/// Makes a shared library of a file with a sense: MIMO_SENSE(mimo::sense<Mine>("mine")).
#define MIMO_SENSE(...)                                                         \
  extern "C" MIMO_PLUGIN mimo_status mimo_sense_entry(mimo_sense *made) {       \
    if (made->struct_size < sizeof *made)                                       \
      return mimo_fail(MIMO_E_UNSUPPORTED, "this sense needs a newer libmimo"); \
    return mimo::detail::task_status([&] { *made = __VA_ARGS__; });             \
  }

#endif
