// The functions of the HDF5 library that recordings need, loaded when a recording is made or read: all else works
// without the library. Numbers and types are those of HDF5 1.10 and later, where handles have 64 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace mimo::recording::hdf5 {

using Id = std::int64_t;
using Size = unsigned long long;  // hsize_t
using ErrorPrinter = int (*)(Id, void*);

constexpr unsigned kReadOnly = 0, kTruncate = 2, kSwmrRead = 0x40;
constexpr int kVersion110 = 2, kScalar = 0, kSelectSet = 0, kGlobalScope = 1;
constexpr Id kDefault = 0, kAll = 0;
constexpr Size kUnlimited = ~Size{0};

struct Library {
  int (*Open)();
  int (*LibraryVersion)(unsigned*, unsigned*, unsigned*);
  int (*GetErrorPrinter)(Id, ErrorPrinter*, void**);
  int (*SetErrorPrinter)(Id, ErrorPrinter, void*);
  int (*ClearErrors)(Id);
  int (*FilterAvailable)(int);
  Id (*CreateFile)(const char*, unsigned, Id, Id);
  Id (*OpenFile)(const char*, unsigned, Id);
  int (*CloseFile)(Id);
  int (*FileOfSystem)(Id, Id, void**);
  int (*Flush)(Id, int);
  int (*StartSwmrWrite)(Id);
  Id (*CreateProperties)(Id);
  int (*CloseProperties)(Id);
  int (*SetVersions)(Id, int, int);
  int (*SetChunk)(Id, int, const Size*);
  int (*SetDeflate)(Id, unsigned);
  int (*SetShuffle)(Id);
  int (*SetCreateGroups)(Id, unsigned);
  Id (*CreateSimpleSpace)(int, const Size*, const Size*);
  Id (*CreateSpace)(int);
  int (*CloseSpace)(Id);
  int (*SelectHyperslab)(Id, int, const Size*, const Size*, const Size*, const Size*);
  int (*Dimensions)(Id);
  int (*Extents)(Id, Size*, Size*);
  Id (*CopyType)(Id);
  int (*SetTypeSize)(Id, std::size_t);
  std::size_t (*TypeSize)(Id);
  int (*CloseType)(Id);
  Id (*CreateDataset)(Id, const char*, Id, Id, Id, Id, Id);
  Id (*OpenDataset)(Id, const char*, Id);
  int (*CloseDataset)(Id);
  int (*SetExtent)(Id, const Size*);
  Id (*DatasetSpace)(Id);
  Id (*DatasetType)(Id);
  int (*Write)(Id, Id, Id, Id, Id, const void*);
  int (*Read)(Id, Id, Id, Id, Id, void*);
  Id (*CreateAttribute)(Id, const char*, Id, Id, Id, Id);
  Id (*OpenAttribute)(Id, const char*, Id);
  int (*CloseAttribute)(Id);
  Id (*AttributeType)(Id);
  int (*WriteAttribute)(Id, Id, const void*);
  int (*ReadAttribute)(Id, Id, void*);
  int (*HasLink)(Id, const char*, Id);
  // Types and classes of properties, which are variables of the library.
  Id u8, i32, i64, f32, f64, string, file_access, dataset_create, link_create;
  bool deflate;  // can compress
};

// Loads the library, once a process: that of a path, or where it is "" that of the environment variable MIMO_HDF5, or
// the system's. Throws Status::kUnsupported in one line where there is none.
void load(const std::string& path);
// Throws where none is loaded.
const Library& library();

// HDF5 is not for several threads: a thread holds this while it uses the library, and may hold several. What goes wrong
// is said by us in one line; the host may be using the same library, and gets its own printer of errors back.
class Turn {
 public:
  Turn();
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  std::lock_guard<std::recursive_mutex> alone_;
  ErrorPrinter printer_ = nullptr;
  void* data_ = nullptr;
};

// Calls transfer(memory, place) with the spaces of `count` rows of a dataset from `first` on; `extents` are its sizes.
// Returns what that returns.
template <typename Transfer>
int with_rows(Id dataset, std::vector<Size> extents, Size first, Size count, Transfer&& transfer) {
  const Library& h5 = library();
  std::vector<Size> start(extents.size());
  start[0] = first;
  extents[0] = count;
  const Id memory = h5.CreateSimpleSpace(static_cast<int>(extents.size()), extents.data(), nullptr);
  const Id place = h5.DatasetSpace(dataset);
  h5.SelectHyperslab(place, kSelectSet, start.data(), nullptr, extents.data(), nullptr);
  const int result = transfer(memory, place);
  h5.CloseSpace(place);
  h5.CloseSpace(memory);
  return result;
}

}  // namespace mimo::recording::hdf5
