// In a module of WebAssembly HDF5 is a part of the module, and files are what its host keeps in memory: nobody else
// uses them.
#include <cstring>
#include <filesystem>

#include "recording/hdf5.h"
#include "recording/system.h"

namespace fs = std::filesystem;

// clang-format off
#define MIMO_HDF5_LINKED(ROW)  \
  MIMO_HDF5_FIRST(ROW)         \
  MIMO_HDF5_FUNCTIONS(ROW)     \
  ROW(DescribeLink, "H5Lget_info2", int, (Id, const char*, LinkInfo*, Id))
#define MIMO_HDF5_VARIABLES(ROW)                     \
  ROW(u8, "H5T_NATIVE_UINT8_g")                      \
  ROW(i32, "H5T_NATIVE_INT32_g")                     \
  ROW(i64, "H5T_NATIVE_INT64_g")                     \
  ROW(u64, "H5T_NATIVE_UINT64_g")                    \
  ROW(f32, "H5T_NATIVE_FLOAT_g")                     \
  ROW(f64, "H5T_NATIVE_DOUBLE_g")                    \
  ROW(string, "H5T_C_S1_g")                          \
  ROW(no_space, "H5E_NOSPACE_g")                     \
  ROW(cannot_allocate, "H5E_CANTALLOC_g")            \
  ROW(file_access, "H5P_CLS_FILE_ACCESS_ID_g")       \
  ROW(dataset_create, "H5P_CLS_DATASET_CREATE_ID_g") \
  ROW(link_create, "H5P_CLS_LINK_CREATE_ID_g")
// clang-format on

// HDF5's functions and variables, by names of our own.
namespace mimo::recording::hdf5 {
extern "C" {
#define MIMO_DECLARED(name, symbol, returned, taken) returned linked_##name taken __asm__(symbol);
MIMO_HDF5_LINKED(MIMO_DECLARED)
#undef MIMO_DECLARED
#define MIMO_DECLARED(name, symbol) extern Id linked_##name __asm__(symbol);
MIMO_HDF5_VARIABLES(MIMO_DECLARED)
#undef MIMO_DECLARED
}
}  // namespace mimo::recording::hdf5

namespace mimo::recording {

void* open_library(const char*) { return &hdf5::linked_u8; }
void close_library(void*) {}
std::string why_not_opened() { return ""; }

void* symbol_of(void*, const char* name) {
#define MIMO_SAME(ours, symbol) \
  if (std::strcmp(name, symbol) == 0) return reinterpret_cast<void*>(&hdf5::linked_##ours);
#define MIMO_SAME_FUNCTION(ours, symbol, returned, taken) MIMO_SAME(ours, symbol)
  MIMO_HDF5_LINKED(MIMO_SAME_FUNCTION)
  MIMO_HDF5_VARIABLES(MIMO_SAME)
#undef MIMO_SAME_FUNCTION
#undef MIMO_SAME
  return nullptr;
}

std::string path_of_this_library() { return ""; }
bool has_elevated_rights() { return false; }
bool environment_has(const std::string&) { return false; }
void write_to_nowhere(int) {}

Claim::Claim(const std::string&) : file_(0), granted_(file_ == 0) {}
Claim::~Claim() = default;
void claim_for_writing(int) {}
void end_claim(int) {}

bool stands(int, const std::string&, std::uint64_t) { return true; }
std::uint64_t size_of(int) { return 0; }

const bool kNamesOpenFiles = false;
std::string name_file(const std::string& file, const std::string& name, bool) {
  std::error_code error;
  fs::rename(file, name, error);
  return error ? error.message() : "";
}

}  // namespace mimo::recording
