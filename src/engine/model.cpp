#include "engine/model.h"

#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstring>
#include <locale>
#include <string_view>
#include <type_traits>

#include "base/bytes.h"
#include "base/fail.h"
#include "base/format.h"
#include "base/process.h"
#include "base/processor.h"
#include "compat/mujoco.h"
#include "engine/guard.h"
#include "engine/hooks.h"

namespace mimo::engine {
namespace {

// MuJoCo's virtual file system: 2 MB, so on the heap.
class VirtualFiles {
 public:
  VirtualFiles() : vfs_(std::make_unique<mjVFS>()) { mj_defaultVFS(vfs_.get()); }
  ~VirtualFiles() { mj_deleteVFS(vfs_.get()); }
  VirtualFiles(const VirtualFiles&) = delete;
  VirtualFiles& operator=(const VirtualFiles&) = delete;

  void add(const char* name, const void* bytes, std::size_t size) {
    int result = 0;
    const Complaint complaint = guarded([&] { compat::add_file(*vfs_, name, bytes, size, result); });
    if (complaint.failed) fail(Status::kOutOfMemory, "file {} of {} bytes: {}", name, size, complaint.error.data());
    if (result != 0) fail(Status::kModel, "file {} cannot be passed to MuJoCo (code {})", name, result);
  }

  const mjVFS* get() const { return vfs_.get(); }

 private:
  std::unique_ptr<mjVFS> vfs_;
};

// C++ streams, by which MuJoCo reads numbers, have a locale that belongs to the whole process. Where it has a decimal
// comma, "0.125" would be read as 125: better no model than a wrong one.
void require_plain_streams() {
  const std::locale locale;
  if (std::use_facet<std::numpunct<char>>(locale).decimal_point() == '.') return;
  fail(Status::kUnsupported,
       "the program's C++ locale \"{}\" (set by std::locale::global) does not write decimal points, and MuJoCo's XML "
       "reader follows it; before making worlds, set a locale whose std::locale::numeric has a point",
       locale.name());
}

// A MuJoCo in the host's global scope, or in the place of its file, comes before the one that we were linked with; its
// structs may be others.
void require_our_mujoco() {
  const int found = mj_version();
  if (found == mjVERSION_HEADER) return;
  fail(Status::kUnsupported,
       "libmimo was built for MuJoCo {}, but found MuJoCo {}: either that version has replaced the one in libmimo's "
       "folder, or the program has loaded it globally, which takes precedence; load it with RTLD_LOCAL, or libmimo "
       "with RTLD_DEEPBIND",
       compiled_version(), mj_versionString());
}

// MuJoCo's own builds for x86-64 are compiled for AVX, and would end the process by an illegal instruction.
void require_processor() {
#ifdef MIMO_MUJOCO_HAS_AVX
  if (has_avx()) return;
  fail(Status::kUnsupported,
       "this processor has no AVX, which the build of MuJoCo beside libmimo needs; Debian's build of MuJoCo does not");
#endif
}

// MuJoCo's message may have several lines; ours have one.
std::string one_line(const char* text) {
  std::string line(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

// MuJoCo has one way to say that a model is wrong and that memory is out.
[[noreturn]] void fail_compile(const char* text) {
  const auto says = [text](const char* words) { return std::strstr(text, words) != nullptr; };
  const bool memory = says("ould not allocate") || says("memory allocation failed");
  fail(memory ? Status::kOutOfMemory : Status::kModel, "{}", one_line(text));
}

std::vector<std::string> names_of(const mjModel& model, Kind kind) {
  std::vector<std::string> names;
  for (int id = 0; id < count(model, kind); ++id) {
    const char* text = name(model, kind, id);
    if (*text != '\0') names.emplace_back(text);
  }
  return names;
}

std::vector<std::string> names_of(const mjModel& model, mjtObj type, int count) {
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id) {
    const char* name = mj_id2name(&model, type, id);
    names.emplace_back(name == nullptr ? "" : name);
  }
  return names;
}

std::uint64_t rounded(double number) {
  constexpr double kNoise = 1e-9;  // what is left of a zero after other sums elsewhere
  const float single = std::abs(number) < kNoise ? 0.0f : static_cast<float>(number);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof bits);
  return bits;
}

template <typename T>
void add(Hash& hash, const T* values, std::size_t count) {
  if constexpr (std::is_floating_point_v<T>) {
    for (std::size_t i = 0; i < count; ++i) hash.add(rounded(static_cast<double>(values[i])));
  } else {
    hash.add(Span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(values), count * sizeof(T)));
  }
}

void add_options(Hash& hash, const mjOption& opt) {
#if MIMO_MUJOCO_4
#define X(type, name, count) add(hash, &opt.name, 1);
#define XVEC(type, name, count) add(hash, opt.name, count);
  MJOPTION_FIELDS
#undef XVEC
#undef X
#else
#define X(type, name) add(hash, &opt.name, 1);
  MJOPTION_SCALARS
#undef X
#define X(name, count) add(hash, opt.name, count);
  MJOPTION_VECTORS
#undef X
#endif
}

}  // namespace

// 222, and since 3.5 4000001.
std::string compiled_version() {
  constexpr int kVersion = mjVERSION_HEADER, kBase = kVersion < 1000 ? 10 : 1000;
  return format("{}.{}.{}", kVersion / (kBase * kBase), kVersion / kBase % kBase, kVersion % kBase);
}

ModelPtr compile(const std::string& xml, const std::vector<Asset>& assets, const LogSink& log) {
  constexpr const char* kDocument = "mimo_scene.xml";
  require_processor();
  require_our_mujoco();
  refuse_callbacks(nullptr);
  require_plain_streams();
  VirtualFiles files;
  files.add(kDocument, xml.data(), xml.size());
  for (const Asset& asset : assets) files.add(asset.name.c_str(), asset.bytes.data(), asset.bytes.size());

  const PlainNumbers plain_numbers;
  std::array<char, 1024> text{};
  mjModel* model = nullptr;
  Complaint complaint;
  const auto load = [&] {
    const CompileLock lock;
    complaint =
        guarded([&] { model = compat::load(kDocument, files.get(), text.data(), static_cast<int>(text.size())); });
  };
  load();
  // The streams by which MuJoCo reads numbers take missing memory for a wrong number. What is wrong is so twice.
  if (model == nullptr && std::strstr(text.data(), "problem reading attribute") != nullptr) load();
  if (complaint.failed) fail_compile(complaint.error.data());
  if (model == nullptr) fail_compile(text.data());
  ModelPtr owned(model, [](const mjModel* m) { mj_deleteModel(const_cast<mjModel*>(m)); });
  if (const char* size = compat::too_large(*model)) {
    fail(Status::kUnsupported, "the model's {} is more than {}", size, INT_MAX);
  }
  if (text[0] != '\0') log(LogLevel::kWarning, one_line(text.data()));
  if (complaint.warnings > 0) log(LogLevel::kWarning, one_line(complaint.warning.data()));
  return owned;
}

void enable_contacts(const mjModel& model) { const_cast<mjModel&>(model).opt.disableflags &= ~mjDSBL_CONTACT; }

mjtObj object_type(Kind kind) {
  switch (kind) {
    case Kind::kBody: return mjOBJ_BODY;
    case Kind::kJoint: return mjOBJ_JOINT;
    case Kind::kGeom: return mjOBJ_GEOM;
    case Kind::kSite: return mjOBJ_SITE;
    case Kind::kCamera: return mjOBJ_CAMERA;
    case Kind::kActuator: return mjOBJ_ACTUATOR;
    case Kind::kSensor: return mjOBJ_SENSOR;
    case Kind::kLight: return mjOBJ_LIGHT;
  }
  return mjOBJ_UNKNOWN;
}

int count(const mjModel& model, Kind kind) {
  switch (kind) {
    case Kind::kBody: return model.nbody;
    case Kind::kJoint: return model.njnt;
    case Kind::kGeom: return model.ngeom;
    case Kind::kSite: return model.nsite;
    case Kind::kCamera: return model.ncam;
    case Kind::kActuator: return model.nu;
    case Kind::kSensor: return model.nsensor;
    case Kind::kLight: return model.nlight;
  }
  return 0;
}

const char* name(const mjModel& model, Kind kind, int id) {
  const char* text = mj_id2name(&model, object_type(kind), id);
  return text == nullptr ? "" : text;
}

int find(const mjModel& model, Kind kind, const char* name) {
  return *name == '\0' ? -1 : mj_name2id(&model, object_type(kind), name);
}

int find_or_fail(const mjModel& model, Kind kind, const std::string& name) {
  const int id = find(model, kind, name.c_str());
  if (id < 0) {
    fail(Status::kNotFound, "no {} named \"{}\"; {}", word(kind), name, choice_of(name, names_of(model, kind)));
  }
  return id;
}

const char* word(Kind kind) {
  switch (kind) {
    case Kind::kBody: return "body";
    case Kind::kJoint: return "joint";
    case Kind::kGeom: return "geom";
    case Kind::kSite: return "site";
    case Kind::kCamera: return "camera";
    case Kind::kActuator: return "actuator";
    case Kind::kSensor: return "sensor";
    case Kind::kLight: return "light";
  }
  return "element";
}

std::string custom_text(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_TEXT, name.c_str());
  return id < 0 ? "" : model.text_data + model.text_adr[id];
}

std::vector<std::string> custom_number_names(const mjModel& model) {
  return names_of(model, mjOBJ_NUMERIC, static_cast<int>(model.nnumeric));
}

std::vector<std::string> custom_tuple_names(const mjModel& model) {
  return names_of(model, mjOBJ_TUPLE, static_cast<int>(model.ntuple));
}

Span<const double> custom_numbers(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_NUMERIC, name.c_str());
  if (id < 0) return {};
  return {model.numeric_data + model.numeric_adr[id], static_cast<std::size_t>(model.numeric_size[id])};
}

std::vector<TupleEntry> custom_tuple(const mjModel& model, const std::string& name, Kind kind) {
  const int id = mj_name2id(&model, mjOBJ_TUPLE, name.c_str());
  std::vector<TupleEntry> entries;
  for (int i = 0; id >= 0 && i < model.tuple_size[id]; ++i) {
    const int at = model.tuple_adr[id] + i;
    if (model.tuple_objtype[at] == object_type(kind))
      entries.push_back({model.tuple_objid[at], model.tuple_objprm[at]});
  }
  return entries;
}

bool has_one_axis(const mjModel& model, int joint) {
  return model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE;
}

int position_count(int joint_type) { return joint_type == mjJNT_FREE ? 7 : joint_type == mjJNT_BALL ? 4 : 1; }

int velocity_count(int joint_type) { return joint_type == mjJNT_FREE ? 6 : joint_type == mjJNT_BALL ? 3 : 1; }

int quaternion_place(int joint_type) { return joint_type == mjJNT_FREE ? 3 : joint_type == mjJNT_BALL ? 0 : -1; }

int free_joint_address(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body];
  if (joint < 0 || model.jnt_type[joint] != mjJNT_FREE) {
    fail(Status::kModel, "body {} has no free joint", name(model, Kind::kBody, body));
  }
  return model.jnt_qposadr[joint];
}

void normalize_quaternion(double* quaternion) { mju_normalize4(quaternion); }

std::uint64_t shape(const mjModel& model) {
  Hash hash;
#define X(name) hash.add(static_cast<std::uint64_t>(model.name));
  MIMO_MODEL_SIZES
#undef X
  hash.add({reinterpret_cast<const std::uint8_t*>(model.names), static_cast<std::size_t>(model.nnames)});
  return hash.value();
}

std::uint64_t fingerprint(const mjModel& model) {
  Hash hash;
#define X(name) hash.add(static_cast<std::uint64_t>(model.name));
  MIMO_MODEL_SIZES
#undef X
  add_options(hash, model.opt);
  MJMODEL_POINTERS_PREAMBLE((&model))
#define X(type, name, rows, columns)                            \
  if constexpr (std::string_view(#name) != compat::kPixelsName) \
    add(hash, model.name, static_cast<std::size_t>(model.rows) * static_cast<std::size_t>(columns));
  MJMODEL_POINTERS
#undef X
  return hash.value();
}

}  // namespace mimo::engine
