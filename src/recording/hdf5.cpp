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

std::atomic<bool> failed{false};

// Damaged files leave something in HDF5 that it cannot close when the process ends, about which it would complain on
// the host's error stream. It is quiet when a call of the library fails.
void be_quiet_at_the_end() {
  if (failed) library().SetErrorPrinter(0, nullptr, nullptr);
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
#define MIMO_FOUND(name, symbol, returned, taken) find(handle, h5.name, symbol);
  MIMO_HDF5_FIRST(MIMO_FOUND)
  unsigned major = 0, minor = 0, release = 0;
  if (h5.Open() < 0 || h5.LibraryVersion(&major, &minor, &release) < 0 || (major == 1 && minor < 10)) {
    fail(Status::kUnsupported, "recordings need HDF5 1.10 or later, and {}.{} was found", major, minor);
  }
  MIMO_HDF5_FUNCTIONS(MIMO_FOUND)
#undef MIMO_FOUND
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
  std::atexit(be_quiet_at_the_end);  // now that HDF5 has started, so that it runs before HDF5 ends
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
  if (std::uncaught_exceptions() > 0) failed = true;
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
