#include "recording/hdf5.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>

#include "base/fail.h"
#include "recording/system.h"

namespace mimo::recording::hdf5 {
namespace {

// HDF5 does not survive it when memory runs out while it starts. That this much is there makes it unlikely.
constexpr std::size_t kStartBytes = std::size_t{8} << 20;
constexpr unsigned kNoPlugins = 0;
constexpr int kUpward = 0;
constexpr char kSystemSays[] = "error message = '";

std::recursive_mutex& turns() {
  static std::recursive_mutex mutex;
  return mutex;
}

std::optional<Library>& place() {
  static std::optional<Library> loaded;
  return loaded;
}

// Damaged files leave something in HDF5 that it cannot close when the process ends, about which it would complain on
// the host's error stream. It is quiet then, where a call of ours has failed.
class Farewell {
 public:
  ~Farewell() {
    if (failed) library().SetErrorPrinter(0, nullptr, nullptr);
  }
  std::atomic<bool> failed{false};
};

// Made after HDF5 has started, so that it goes before HDF5 ends.
Farewell& farewell() {
  static Farewell made;
  return made;
}

void* open_named(const std::string& path, const char* source) {
  if (void* handle = open_library(path.c_str())) return handle;
  fail(Status::kUnsupported, "{} is {}, expected the path of the library HDF5: {}", source, path, why_not_opened());
}

void* open_first(const std::string& path) {
  if (!path.empty()) return open_named(path, "hdf5");
  const char* const chosen = has_elevated_rights() ? nullptr : std::getenv("MIMO_HDF5");
  if (chosen != nullptr && *chosen != '\0') return open_named(chosen, "the environment variable MIMO_HDF5");
  for (const char* name :
       {"libhdf5_serial.so.103", "libhdf5.so.103", "libhdf5_serial.so.310", "libhdf5.so.310", "libhdf5.so.200",
        "libhdf5.so.320", "libhdf5_serial.so", "libhdf5.so", "hdf5.dll", "libhdf5.dylib"}) {
    if (void* handle = open_library(name)) return handle;
  }
  fail(Status::kUnsupported,
       "recordings need the library HDF5 1.10 or later (Debian package libhdf5-103-1), which was not found; MIMO_HDF5 "
       "may hold its path");
}

void* address(void* handle, const char* name) {
  void* const found = symbol_of(handle, name);
  if (found == nullptr) fail(Status::kUnsupported, "the library HDF5 that was found has no {}", name);
  return found;
}

template <typename Function>
void find(void* handle, Function& function, const char* name) {
  void* const found = address(handle, name);
  std::memcpy(&function, &found, sizeof function);
}

void find_id(void* handle, Id& id, const char* name) { id = *static_cast<const Id*>(address(handle, name)); }

void find_files(void* handle, Library& h5) {
  find(handle, h5.FilterAvailable, "H5Zfilter_avail");
  find(handle, h5.GetPlugins, "H5PLget_loading_state");
  find(handle, h5.SetPlugins, "H5PLset_loading_state");
  find(handle, h5.CreateFile, "H5Fcreate");
  find(handle, h5.OpenFile, "H5Fopen");
  find(handle, h5.CloseFile, "H5Fclose");
  find(handle, h5.FileOfSystem, "H5Fget_vfd_handle");
  find(handle, h5.Flush, "H5Fflush");
  find(handle, h5.StartSwmrWrite, "H5Fstart_swmr_write");
  find(handle, h5.CreateProperties, "H5Pcreate");
  find(handle, h5.CloseProperties, "H5Pclose");
  find(handle, h5.SetVersions, "H5Pset_libver_bounds");
  find(handle, h5.SetReadAttempts, "H5Pset_metadata_read_attempts");
  find(handle, h5.SetChunk, "H5Pset_chunk");
  find(handle, h5.SetDeflate, "H5Pset_deflate");
  find(handle, h5.SetShuffle, "H5Pset_shuffle");
  find(handle, h5.SetCreateGroups, "H5Pset_create_intermediate_group");
  find(handle, h5.Layout, "H5Pget_layout");
  find(handle, h5.Chunk, "H5Pget_chunk");
  find(handle, h5.ExternalFiles, "H5Pget_external_count");
  find(handle, h5.FilterCount, "H5Pget_nfilters");
  find(handle, h5.Filter, "H5Pget_filter2");
}

void find_shapes(void* handle, Library& h5) {
  find(handle, h5.CreateSimpleSpace, "H5Screate_simple");
  find(handle, h5.CreateSpace, "H5Screate");
  find(handle, h5.CloseSpace, "H5Sclose");
  find(handle, h5.SelectHyperslab, "H5Sselect_hyperslab");
  find(handle, h5.Points, "H5Sget_simple_extent_npoints");
  find(handle, h5.Dimensions, "H5Sget_simple_extent_ndims");
  find(handle, h5.Extents, "H5Sget_simple_extent_dims");
  find(handle, h5.CopyType, "H5Tcopy");
  find(handle, h5.SetTypeSize, "H5Tset_size");
  find(handle, h5.TypeSize, "H5Tget_size");
  find(handle, h5.TypeClass, "H5Tget_class");
  find(handle, h5.SameType, "H5Tequal");
  find(handle, h5.IsVariableText, "H5Tis_variable_str");
  find(handle, h5.CloseType, "H5Tclose");
}

void find_contents(void* handle, Library& h5) {
  find(handle, h5.CreateDataset, "H5Dcreate2");
  find(handle, h5.OpenDataset, "H5Dopen2");
  find(handle, h5.CloseDataset, "H5Dclose");
  find(handle, h5.SetExtent, "H5Dset_extent");
  find(handle, h5.DatasetSpace, "H5Dget_space");
  find(handle, h5.DatasetType, "H5Dget_type");
  find(handle, h5.DatasetProperties, "H5Dget_create_plist");
  find(handle, h5.Write, "H5Dwrite");
  find(handle, h5.Read, "H5Dread");
  find(handle, h5.CreateAttribute, "H5Acreate2");
  find(handle, h5.OpenAttribute, "H5Aopen");
  find(handle, h5.CloseAttribute, "H5Aclose");
  find(handle, h5.AttributeType, "H5Aget_type");
  find(handle, h5.AttributeSpace, "H5Aget_space");
  find(handle, h5.WriteAttribute, "H5Awrite");
  find(handle, h5.ReadAttribute, "H5Aread");
  find(handle, h5.HasLink, "H5Lexists");
}

void find_constants(void* handle, Library& h5) {
  find_id(handle, h5.u8, "H5T_NATIVE_UINT8_g");
  find_id(handle, h5.i32, "H5T_NATIVE_INT32_g");
  find_id(handle, h5.i64, "H5T_NATIVE_INT64_g");
  find_id(handle, h5.u64, "H5T_NATIVE_UINT64_g");
  find_id(handle, h5.f32, "H5T_NATIVE_FLOAT_g");
  find_id(handle, h5.f64, "H5T_NATIVE_DOUBLE_g");
  find_id(handle, h5.string, "H5T_C_S1_g");
  find_id(handle, h5.no_space, "H5E_NOSPACE_g");
  find_id(handle, h5.cannot_allocate, "H5E_CANTALLOC_g");
  find_id(handle, h5.file_access, "H5P_CLS_FILE_ACCESS_ID_g");
  find_id(handle, h5.dataset_create, "H5P_CLS_DATASET_CREATE_ID_g");
  find_id(handle, h5.link_create, "H5P_CLS_LINK_CREATE_ID_g");
}

void find_link_info(void* handle, Library& h5) {
  const char* name = "H5Lget_info";
  for (const char* newer : {"H5Lget_info2", "H5Lget_info1"}) {
    if (symbol_of(handle, newer) == nullptr) continue;
    name = newer;
    break;
  }
  find(handle, h5.DescribeLink, name);
}

Library find_all(void* handle) {
  Library h5 = {};
  find(handle, h5.Open, "H5open");
  find(handle, h5.LibraryVersion, "H5get_libversion");
  find(handle, h5.GetErrorPrinter, "H5Eget_auto2");
  find(handle, h5.SetErrorPrinter, "H5Eset_auto2");
  find(handle, h5.ClearErrors, "H5Eclear2");
  find(handle, h5.WalkErrors, "H5Ewalk2");
  unsigned major = 0, minor = 0, release = 0;
  if (h5.Open() < 0 || h5.LibraryVersion(&major, &minor, &release) < 0 || (major == 1 && minor < 10)) {
    fail(Status::kUnsupported, "recordings need HDF5 1.10 or later, and {}.{} was found", major, minor);
  }
  find_files(handle, h5);
  find_shapes(handle, h5);
  find_contents(handle, h5);
  find_link_info(handle, h5);
  find_constants(handle, h5);
  h5.deflate = h5.FilterAvailable(kDeflate) > 0;
  return h5;
}

// Called by HDF5, from the first error to what came of it.
int note(unsigned, const Problem* problem, void* to) {
  auto& reason = *static_cast<Reason*>(to);
  const Library& h5 = library();
  reason.no_memory |= problem->minor == h5.no_space || problem->minor == h5.cannot_allocate;
  const char* const told = problem->text == nullptr ? nullptr : std::strstr(problem->text, kSystemSays);
  if (told == nullptr || reason.system[0] != '\0') return 0;
  const char* const words = told + std::strlen(kSystemSays);
  const std::size_t length = std::min(std::strcspn(words, "'\n"), sizeof reason.system - 1);
  std::memcpy(reason.system, words, length);
  reason.system[length] = '\0';
  return 0;
}

}  // namespace

void load(const std::string& path) {
  const std::lock_guard alone(turns());
  if (place()) return;
  // HDF5 itself loads what its environment names.
  if (has_elevated_rights() && environment_has("HDF5_")) {
    fail(Status::kUnsupported,
         "this program has elevated rights, and its environment has variables of HDF5 (HDF5_...), which can make that "
         "library load programs: recordings need an environment without them");
  }
  static_cast<void>(std::make_unique<char[]>(kStartBytes));
  place() = find_all(open_first(path));
  farewell();
}

const Library& library() {
  if (!place()) fail(Status::kInternal, "HDF5 is used before it was loaded");
  return *place();
}

Turn::Turn() : alone_(turns()) { begin(); }

Turn::Turn(std::try_to_lock_t how) : alone_(turns(), how) {
  if (mine()) begin();
}

void Turn::begin() {
  const Library& h5 = library();
  h5.GetErrorPrinter(0, &printer_, &data_);
  h5.SetErrorPrinter(0, nullptr, nullptr);
  h5.GetPlugins(&plugins_);
  h5.SetPlugins(kNoPlugins);
}

// What it remembers of errors belongs to this thread, and would outlive it.
Turn::~Turn() {
  if (!mine()) return;
  const Library& h5 = library();
  if (std::uncaught_exceptions() > 0) farewell().failed = true;
  h5.ClearErrors(0);
  h5.SetPlugins(plugins_);
  h5.SetErrorPrinter(0, printer_, data_);
}

Reason last_reason() {
  Reason reason;
  library().WalkErrors(0, kUpward, note, &reason);
  return reason;
}

}  // namespace mimo::recording::hdf5
