#include "recorder.h"

#include <fstream>

#include "facts.h"
#include "failure.h"
#include "libraries.h"
#include "text.h"
#include "world.h"

namespace cli {
namespace {

constexpr std::size_t kMostNamed = 1000;  // elements of a field that are listed by name

// FNV-1a of the library's file: two builds of one version are two builds.
std::uint64_t fingerprint() {
  const auto function = &mimo_version;
  std::uint64_t hash = 14695981039346656037u;
  const std::string path = library_of(reinterpret_cast<const void*>(function));
  if (path.empty()) return 0;
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(1 << 16);
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())), file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash = (hash ^ static_cast<unsigned char>(piece[static_cast<std::size_t>(i)])) * 1099511628211u;
    }
  }
  return hash;
}

// "proprioception" fits "proprioception/position" and "anna/proprioception/position".
bool fits(const std::string& name, const std::string& word) {
  const std::string inside = "/" + name + "/";
  return inside.find("/" + word + "/") != std::string::npos;
}

std::vector<mimo_field> choose(const mimo::Env& env, const std::string& list) {
  const auto fields = env.layout().fields();
  if (list == "all") return fields;
  std::vector<mimo_field> chosen;
  if (list == "none") return chosen;
  std::vector<bool> taken(fields.size());
  for (const std::string& word : parts_of(list)) {
    bool any = false;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!fits(fields[i].name, word)) continue;
      taken[i] = any = true;
    }
    if (!any && list != RecorderOptions().keep)
      throw Failure("--keep: this world has no sense or field '" + word + "'");
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (taken[i]) chosen.push_back(fields[i]);
  }
  return chosen;
}

hdf5::Id type_of(const mimo_field& field) {
  const hdf5::Library& h5 = hdf5::library();
  switch (field.dtype) {
    case MIMO_U8: return h5.u8;
    case MIMO_I32: return h5.i32;
    case MIMO_F32: return h5.f32;
    case MIMO_F64: return h5.f64;
    default: throw Failure(std::string("a recording cannot hold the type of ") + field.name);
  }
}

std::size_t elements(const mimo_field& field) {
  std::size_t count = 1;
  for (const std::size_t extent : shape(field)) count *= extent;
  return count;
}

std::string labels(const mimo::Layout& layout, const mimo_field& field) {
  const std::size_t count = elements(field);
  std::string names;
  for (std::size_t i = 0; i < count && count <= kMostNamed; ++i) names += layout.label(field.name, i) + "\n";
  return names.size() == count ? "" : names;  // no element has a name
}

std::string action_names(const mimo::Env& env) {
  std::string names;
  for (const mimo_action& action : env.layout().actions()) names += std::string(action.name) + "\n";
  return names;
}

// A line for each column: a free joint has seven positions and six velocities.
std::string joint_columns(const mimo::Env& env, std::int32_t quantity) {
  std::string names;
  for (const std::int32_t joint : env.ids(MIMO_JOINT)) {
    for (std::size_t i = env.width(quantity, {joint}); i > 0; --i) names += env.name(MIMO_JOINT, joint) + "\n";
  }
  return names;
}

}  // namespace

std::string build_name() {
  return text("libmimo %s, MuJoCo %s, build %016llx", mimo_version(), mimo_mujoco_version(),
              static_cast<unsigned long long>(fingerprint()));
}

std::string joint_names(const mimo::Env& env) {
  std::string names;
  for (const std::int32_t joint : env.ids(MIMO_JOINT)) names += env.name(MIMO_JOINT, joint) + "\n";
  return names;
}

std::string field_table(const mimo_field& field) { return std::string("fields/") + field.name; }

Recorder::Recorder(const RecorderOptions& options, const mimo::Env& env, const std::string& configuration,
                   std::uint64_t seed)
    : step_seconds_(env.timestep() * env.frame_skip()),
      state_every_(steps_in(options.state_every, step_seconds_)),
      flush_every_(options.flush_every),
      fields_(choose(env, options.keep)),
      joints_(env.ids(MIMO_JOINT)),
      file_(options.out, options.compression) {
  describe(env, configuration, seed);
  file_.start();
}

void Recorder::describe(const mimo::Env& env, const std::string& configuration, std::uint64_t seed) {
  const hdf5::Library& h5 = hdf5::library();
  file_.attribute("format", std::string(kRecordingFormat));
  file_.attribute("format_version", kRecordingVersion);
  file_.attribute("build", build_name());
  file_.attribute("configuration", configuration);
  file_.attribute("seed", std::to_string(seed));  // has 64 bits without a sign, which not all readers know
  file_.attribute("step_seconds", step_seconds_);
  file_.attribute("joint_names", joint_names(env));
  file_.table(kTime, h5.f64, {}, "s");
  file_.table(kActions, h5.f32, {env.layout().actions().size()}, "", action_names(env));
  file_.table(kRewards, h5.f64, {env.make_results().reward.size()}, "");
  file_.table(kJointPosition, h5.f64, {env.get_values(MIMO_JOINT_POSITION, joints_).size()}, "m or rad",
              joint_columns(env, MIMO_JOINT_POSITION));
  file_.table(kJointVelocity, h5.f64, {env.get_values(MIMO_JOINT_VELOCITY, joints_).size()}, "m/s or rad/s",
              joint_columns(env, MIMO_JOINT_VELOCITY));
  file_.table(kStates, h5.u8, {env.save().size()}, "");
  file_.table(kStateSteps, h5.i64, {}, "");
  for (const mimo_field& field : fields_) {
    file_.table(field_table(field), type_of(field), shape(field), field.unit, labels(env.layout(), field));
  }
}

void Recorder::keep_state(const mimo::Env& env) {
  file_.append(kStates, env.save().data());
  file_.append(kStateSteps, &steps_);
}

void Recorder::before_step(const mimo::Env& env) {
  if (static_cast<std::size_t>(steps_) % state_every_ == 0) keep_state(env);
  if (steps_ == 0) file_.flush();  // from here on a run that is killed can be replayed
}

void Recorder::after_step(const mimo::Env& env, const std::vector<float>& actions, const mimo::Block& block,
                          const mimo::Results& results) {
  const double time = step_seconds_ * static_cast<double>(++steps_);
  file_.append(kTime, &time);
  file_.append(kActions, actions.data());
  file_.append(kRewards, results.reward.data());
  file_.append(kJointPosition, env.get_values(MIMO_JOINT_POSITION, joints_).data());
  file_.append(kJointVelocity, env.get_values(MIMO_JOINT_VELOCITY, joints_).data());
  for (const mimo_field& field : fields_) file_.append(field_table(field), block.data() + field.offset);
  if (seconds_since(flushed_) < flush_every_) return;
  file_.flush();
  flushed_ = Clock::now();
}

void Recorder::finish(const mimo::Env& env) {
  keep_state(env);
  file_.close();
}

}  // namespace cli
