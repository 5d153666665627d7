// Recordings of any content: a file that the library wrote, in which attributes and datasets are of other kinds, lie
// elsewhere or claim to be huge, and bytes are damaged. Such a file is refused, or it is read and played.
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

extern "C" {
#include "fuzz/input.h"
}

namespace {

using Id = std::int64_t;
using Size = unsigned long long;

constexpr const char* kLibraries[] = {"libhdf5_serial.so.103", "libhdf5.so.103", "libhdf5_serial.so.310",
                                      "libhdf5.so.310"};
constexpr const char* kAttributes[] = {"format",       "format_version", "build",   "configuration", "seed",
                                       "step_seconds", "joint_names",    "library", "mujoco",        "byte_order"};
constexpr const char* kDatasets[] = {"time",
                                     "actions",
                                     "rewards",
                                     "joints/position",
                                     "joints/velocity",
                                     "states/state",
                                     "states/step",
                                     "states/given",
                                     "states/body",
                                     "bodies/growth",
                                     "bodies/model_hash",
                                     "terminated",
                                     "truncated",
                                     "outcome",
                                     "terms",
                                     "world",
                                     "scene/document",
                                     "scene/assets/floor.png",
                                     "fields/vestibular/acceleration"};
constexpr const char* kNumbers[] = {"H5T_NATIVE_INT8_g",   "H5T_NATIVE_UINT8_g",  "H5T_NATIVE_INT32_g",
                                    "H5T_NATIVE_INT64_g",  "H5T_STD_I64BE_g",     "H5T_NATIVE_FLOAT_g",
                                    "H5T_NATIVE_DOUBLE_g", "H5T_NATIVE_LDOUBLE_g"};
constexpr std::size_t kMostRead = std::size_t{1} << 26;
constexpr double kMostSeconds = 10;  // generous: with sanitizers, on a busy machine

void* hdf5;
const char* hdf5_name;
mimo_env* env;
std::string folder, path, base;  // what the library recorded, as bytes

// Calls a function of HDF5, whose arguments have just these types.
template <typename Result = Id, typename... Arguments>
Result h5(const char* name, Arguments... arguments) {
  const auto function = reinterpret_cast<Result (*)(Arguments...)>(dlsym(hdf5, name));
  PROMISE(function != nullptr);
  return function(arguments...);
}

Id constant(const char* name) { return *static_cast<Id*>(dlsym(hdf5, name)); }

template <std::size_t n>
const char* one_of(input& in, const char* const (&names)[n]) {
  return names[take_byte(&in) % n];
}

// Types that are numbers, and types that are not.
Id take_type(input& in) {
  const std::uint8_t kind = take_byte(&in);
  const Id number = constant(one_of(in, kNumbers));
  switch (kind % 10) {
    case 0:
    case 1:
    case 2: return h5("H5Tcopy", number);
    case 3:
    case 4: {
      const Id text = h5("H5Tcopy", constant("H5T_C_S1_g"));
      const std::size_t variable = static_cast<std::size_t>(-1), bytes = take_byte(&in) + std::size_t{1};
      h5<int>("H5Tset_size", text, kind % 10 == 3 ? variable : bytes * bytes);
      return text;
    }
    case 5: return h5("H5Tvlen_create", number);
    case 6: {
      const Size extents[] = {take_byte(&in) * Size{64} + 1};
      return h5("H5Tarray_create2", number, 1U, static_cast<const Size*>(extents));
    }
    case 7: {
      const Id pair = h5("H5Tcreate", 6, std::size_t{16});
      h5<int>("H5Tinsert", pair, static_cast<const char*>("a"), std::size_t{0}, number);
      return pair;
    }
    case 8: return h5("H5Tcreate", 5, std::size_t{40});  // opaque
    default: return h5("H5Tcopy", constant("H5T_STD_REF_OBJ_g"));
  }
}

Size take_extent(input& in) {
  const std::uint8_t byte = take_byte(&in);
  return byte < 192 ? byte % 16 : Size{1} << byte % 62;
}

std::vector<Size> take_extents(input& in) {
  std::vector<Size> extents(take_byte(&in) % 5);
  for (Size& extent : extents) extent = take_extent(in);
  return extents;
}

Id space_of(const std::vector<Size>& extents) {
  if (extents.empty()) return h5("H5Screate", 0);
  return h5("H5Screate_simple", static_cast<int>(extents.size()), extents.data(), static_cast<const Size*>(nullptr));
}

void change_attribute(Id file, input& in) {
  const char* const name = one_of(in, kAttributes);
  const std::uint8_t how = take_byte(&in);
  h5<int>("H5Adelete", file, name);
  if (how % 16 == 0) return;
  const Id type = take_type(in);
  const std::vector<Size> extents = how % 2 == 0 ? std::vector<Size>{} : take_extents(in);
  std::size_t bytes = h5<std::size_t>("H5Tget_size", type);
  for (const Size extent : extents) bytes = bytes * extent > kMostRead ? kMostRead : bytes * extent;
  const bool fits = bytes < kMostRead;                                      // HDF5 makes room for all of it
  const Id space = how % 16 == 1 ? h5("H5Screate", 2) : space_of(extents);  // 2: none
  const Id attribute = fits ? h5("H5Acreate2", file, name, type, space, Id{0}, Id{0}) : -1;
  // Of numbers, and of texts whose length is fixed: others hold pointers.
  const bool plain = h5<int>("H5Tget_class", type) < 4 && h5<int>("H5Tis_variable_str", type) <= 0;
  if (attribute >= 0 && plain) {
    std::vector<std::uint8_t> value(bytes + 1);
    take(&in, value.data(), std::min<std::size_t>(bytes, 8));
    for (std::size_t i = 8; i < bytes; ++i) value[i] = value[i % 8];
    h5<int>("H5Awrite", attribute, type, static_cast<const void*>(value.data()));
  }
  if (attribute >= 0) h5<int>("H5Aclose", attribute);
  h5<int>("H5Sclose", space);
  h5<int>("H5Tclose", type);
}

void make_dataset(Id file, const char* name, input& in) {
  const std::uint8_t how = take_byte(&in);
  const Id type = take_type(in), layout = h5("H5Pcreate", constant("H5P_CLS_DATASET_CREATE_ID_g"));
  std::vector<Size> extents = take_extents(in);
  const Id space = space_of(extents);
  if (how % 4 == 1) h5<int>("H5Pset_external", layout, "/etc/passwd", std::int64_t{0}, ~Size{0});
  if (how % 4 >= 2) {
    for (Size& extent : extents) extent = std::clamp<Size>(take_extent(in), 1, std::max<Size>(extent, 1));
    h5<int>("H5Pset_chunk", layout, static_cast<int>(extents.size()), static_cast<const Size*>(extents.data()));
    if (how % 4 == 3) h5<int>("H5Pset_deflate", layout, 1U);
    if (how % 32 == 3) h5<int>("H5Pset_scaleoffset", layout, 2, 0);
  }
  const Id dataset = h5("H5Dcreate2", file, name, type, space, Id{0}, layout, Id{0});
  if (dataset >= 0) h5<int>("H5Dclose", dataset);
  h5<int>("H5Pclose", layout);
  h5<int>("H5Sclose", space);
  h5<int>("H5Tclose", type);
}

void change_dataset(Id file, input& in) {
  const std::string name = one_of(in, kDatasets), group = name.substr(0, name.find('/'));
  const std::uint8_t how = take_byte(&in);
  const char* const place = how % 8 == 5 ? group.c_str() : name.c_str();
  if (h5<int>("H5Ldelete", file, place, Id{0}) < 0) return;
  switch (how % 8) {
    case 0: return;
    case 1: h5<int>("H5Lcreate_soft", one_of(in, kDatasets), file, place, Id{0}, Id{0}); return;
    case 2: h5<int>("H5Lcreate_external", path.c_str(), one_of(in, kDatasets), file, place, Id{0}, Id{0}); return;
    case 3: {
      const Id made = h5("H5Gcreate2", file, place, Id{0}, Id{0}, Id{0});
      if (made >= 0) h5<int>("H5Gclose", made);
      return;
    }
    case 4: h5<int>("H5Lcreate_hard", file, one_of(in, kDatasets), file, place, Id{0}, Id{0}); return;
    case 5: h5<int>("H5Lcreate_external", path.c_str(), group.c_str(), file, place, Id{0}, Id{0}); return;
    default: make_dataset(file, place, in);
  }
}

void make_base() {
  for (const char* name : kLibraries) {
    if (hdf5 != nullptr) break;
    hdf5 = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    hdf5_name = name;
  }
  if (hdf5 == nullptr) return;
  char name[] = "/tmp/mimo_fuzz_XXXXXX";
  PROMISE(mkdtemp(name) != nullptr);
  folder = name;
  path = folder + "/run.h5";
  std::atexit([] {
    unlink(path.c_str());
    rmdir(folder.c_str());
  });
  PROMISE(mimo_env_make("reach", &env) == MIMO_OK);
  mimo_recorder_config config{};
  PROMISE(mimo_recorder_config_init(&config, sizeof config) == MIMO_OK);
  config.state_seconds = 0.02;
  config.configuration = "{}";
  config.hdf5 = hdf5_name;
  mimo_recorder* recorder = nullptr;
  PROMISE(mimo_recorder_open(env, path.c_str(), &config, &recorder) == MIMO_OK);
  for (int i = 0; i < 5; ++i) PROMISE(mimo_env_step(env, nullptr, 0, nullptr, 0, nullptr) == MIMO_OK);
  PROMISE(mimo_recorder_close(recorder) == MIMO_OK);
  std::ifstream file(path, std::ios::binary);
  base.assign(std::istreambuf_iterator<char>(file), {});
  h5<int>("H5Eset_auto2", Id{0}, static_cast<void*>(nullptr), static_cast<void*>(nullptr));
}

void put(const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void change_contents(input& in, int changes) {
  put(base);
  const Id file = h5("H5Fopen", path.c_str(), 1U, Id{0});
  PROMISE(file >= 0);
  for (int i = 0; i < changes; ++i) take_byte(&in) % 2 == 0 ? change_attribute(file, in) : change_dataset(file, in);
  h5<int>("H5Fclose", file);
}

void damage_bytes(input& in, std::size_t changes) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  for (std::size_t i = 0; i < changes; ++i) {
    const bool head = take_byte(&in) % 4 == 0;
    const auto size = static_cast<std::uint32_t>(head ? std::min<std::size_t>(bytes.size(), 96) : bytes.size());
    bytes[take_below(&in, size)] = static_cast<char>(take_byte(&in));
  }
  if (take_byte(&in) % 8 == 1) bytes.resize(take_below(&in, static_cast<std::uint32_t>(bytes.size())));
  put(bytes);
}

void read(const mimo_recording* recording, const char* dataset) {
  std::size_t rows = 0, row_bytes = 0;
  if (CALL(mimo_recording_size(recording, dataset, &rows, &row_bytes)) != MIMO_OK) return;
  PROMISE(row_bytes > 0);
  rows = std::min(rows, kMostRead / row_bytes);
  std::vector<std::uint8_t> values(rows * row_bytes);
  CALL(mimo_recording_read(recording, dataset, 0, rows, values.data(), values.size()));
}

void look_at_it(bool makes_worlds) {
  mimo_recording* recording = nullptr;
  if (CALL(mimo_recording_open(path.c_str(), hdf5_name, &recording)) != MIMO_OK) return;
  mimo_recording_info info{};
  info.struct_size = sizeof info;
  PROMISE(mimo_recording_describe(recording, &info) == MIMO_OK);
  for (const char* dataset : kDatasets) read(recording, dataset);
  mimo_env* made = nullptr;
  if (makes_worlds) CALL(mimo_recording_env(recording, nullptr, nullptr, &made));
  mimo_env_destroy(made);
  for (const std::uint32_t compare : {1U, 0U}) {
    if (CALL(mimo_recording_seek(recording, env, info.steps / 2, compare, nullptr)) != MIMO_OK) continue;
    for (int i = 0; i < 3; ++i) CALL(mimo_recording_step(recording, env, nullptr, 0, nullptr));
  }
  mimo_replay_report report{};
  report.struct_size = sizeof report;
  PROMISE(mimo_recording_report(recording, &report) == MIMO_OK);
  mimo_recording_close(recording);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  input in = {data, size};
  if (base.empty()) make_base();
  if (hdf5 == nullptr) {
    std::puts("HDF5 is not installed");
    return 0;
  }
  const std::uint8_t how = take_byte(&in);
  change_contents(in, how % 4);
  if (how >= 192 || how % 4 == 0) damage_bytes(in, 1 + how % 8);
  const auto begin = std::chrono::steady_clock::now();
  look_at_it(take_byte(&in) % 8 == 0);  // a compiler's work
  PROMISE(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < kMostSeconds);
  return 0;
}
