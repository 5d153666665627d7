// The functions of the HDF5 library that recordings need, loaded when a recording is made or read: all else works
// without the library. Numbers and types are those of HDF5 1.10 and later, where handles have 64 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mimo::recording::hdf5 {

using Id = std::int64_t;
using Size = unsigned long long;  // hsize_t
using ErrorPrinter = int (*)(Id, void*);

constexpr unsigned kReadOnly = 0, kMustBeNew = 4, kSwmrRead = 0x40;
constexpr int kVersion110 = 2, kScalar = 0, kSelectSet = 0, kGlobalScope = 1;
constexpr int kInteger = 0, kFloat = 1, kText = 3;          // classes of types
constexpr int kHardLink = 0, kCompact = 0, kChunked = 2;    // kinds of links, of layouts
constexpr int kDeflate = 1, kShuffle = 2, kFletcher32 = 3;  // filters
constexpr Id kDefault = 0, kAll = 0;
constexpr Size kUnlimited = ~Size{0};

// H5E_error2_t.
struct Problem {
  Id library, major, minor;
  unsigned line;
  const char *function, *file, *text;
};

// The beginning of H5L_info_t, of which versions differ in what follows.
struct LinkInfo {
  int kind;
  unsigned char rest[124];
};

// Functions, as our name, HDF5's, and what it returns and takes. The first ones are those of all versions.
#define MIMO_HDF5_FIRST(ROW)                                                      \
  ROW(Open, "H5open", int, ())                                                    \
  ROW(LibraryVersion, "H5get_libversion", int, (unsigned*, unsigned*, unsigned*)) \
  ROW(GetErrorPrinter, "H5Eget_auto2", int, (Id, ErrorPrinter*, void**))          \
  ROW(SetErrorPrinter, "H5Eset_auto2", int, (Id, ErrorPrinter, void*))            \
  ROW(ClearErrors, "H5Eclear2", int, (Id))                                        \
  ROW(WalkErrors, "H5Ewalk2", int, (Id, int, int (*)(unsigned, const Problem*, void*), void*))

#define MIMO_HDF5_FUNCTIONS(ROW)                                                                                  \
  ROW(FilterAvailable, "H5Zfilter_avail", int, (int))                                                             \
  ROW(GetPlugins, "H5PLget_loading_state", int, (unsigned*))                                                      \
  ROW(SetPlugins, "H5PLset_loading_state", int, (unsigned))                                                       \
  ROW(CreateFile, "H5Fcreate", Id, (const char*, unsigned, Id, Id))                                               \
  ROW(OpenFile, "H5Fopen", Id, (const char*, unsigned, Id))                                                       \
  ROW(CloseFile, "H5Fclose", int, (Id))                                                                           \
  ROW(FileOfSystem, "H5Fget_vfd_handle", int, (Id, Id, void**))                                                   \
  ROW(Flush, "H5Fflush", int, (Id, int))                                                                          \
  ROW(StartSwmrWrite, "H5Fstart_swmr_write", int, (Id))                                                           \
  ROW(CreateProperties, "H5Pcreate", Id, (Id))                                                                    \
  ROW(CloseProperties, "H5Pclose", int, (Id))                                                                     \
  ROW(SetVersions, "H5Pset_libver_bounds", int, (Id, int, int))                                                   \
  ROW(SetReadAttempts, "H5Pset_metadata_read_attempts", int, (Id, unsigned))                                      \
  ROW(SetChunk, "H5Pset_chunk", int, (Id, int, const Size*))                                                      \
  ROW(SetDeflate, "H5Pset_deflate", int, (Id, unsigned))                                                          \
  ROW(SetShuffle, "H5Pset_shuffle", int, (Id))                                                                    \
  ROW(SetCreateGroups, "H5Pset_create_intermediate_group", int, (Id, unsigned))                                   \
  ROW(Layout, "H5Pget_layout", int, (Id))                                                                         \
  ROW(Chunk, "H5Pget_chunk", int, (Id, int, Size*))                                                               \
  ROW(ExternalFiles, "H5Pget_external_count", int, (Id))                                                          \
  ROW(FilterCount, "H5Pget_nfilters", int, (Id))                                                                  \
  ROW(Filter, "H5Pget_filter2", int,                                                                              \
      (Id, unsigned, unsigned*, std::size_t*, unsigned*, std::size_t, char*, unsigned*))                          \
  ROW(CreateSimpleSpace, "H5Screate_simple", Id, (int, const Size*, const Size*))                                 \
  ROW(CreateSpace, "H5Screate", Id, (int))                                                                        \
  ROW(CloseSpace, "H5Sclose", int, (Id))                                                                          \
  ROW(SelectHyperslab, "H5Sselect_hyperslab", int, (Id, int, const Size*, const Size*, const Size*, const Size*)) \
  ROW(Points, "H5Sget_simple_extent_npoints", long long, (Id))                                                    \
  ROW(Dimensions, "H5Sget_simple_extent_ndims", int, (Id))                                                        \
  ROW(Extents, "H5Sget_simple_extent_dims", int, (Id, Size*, Size*))                                              \
  ROW(CopyType, "H5Tcopy", Id, (Id))                                                                              \
  ROW(SetTypeSize, "H5Tset_size", int, (Id, std::size_t))                                                         \
  ROW(TypeSize, "H5Tget_size", std::size_t, (Id))                                                                 \
  ROW(TypeClass, "H5Tget_class", int, (Id))                                                                       \
  ROW(SameType, "H5Tequal", int, (Id, Id))                                                                        \
  ROW(IsVariableText, "H5Tis_variable_str", int, (Id))                                                            \
  ROW(CloseType, "H5Tclose", int, (Id))                                                                           \
  ROW(CreateDataset, "H5Dcreate2", Id, (Id, const char*, Id, Id, Id, Id, Id))                                     \
  ROW(OpenDataset, "H5Dopen2", Id, (Id, const char*, Id))                                                         \
  ROW(CloseDataset, "H5Dclose", int, (Id))                                                                        \
  ROW(SetExtent, "H5Dset_extent", int, (Id, const Size*))                                                         \
  ROW(DatasetSpace, "H5Dget_space", Id, (Id))                                                                     \
  ROW(DatasetType, "H5Dget_type", Id, (Id))                                                                       \
  ROW(DatasetProperties, "H5Dget_create_plist", Id, (Id))                                                         \
  ROW(Write, "H5Dwrite", int, (Id, Id, Id, Id, Id, const void*))                                                  \
  ROW(Read, "H5Dread", int, (Id, Id, Id, Id, Id, void*))                                                          \
  ROW(CreateAttribute, "H5Acreate2", Id, (Id, const char*, Id, Id, Id, Id))                                       \
  ROW(OpenAttribute, "H5Aopen", Id, (Id, const char*, Id))                                                        \
  ROW(CloseAttribute, "H5Aclose", int, (Id))                                                                      \
  ROW(AttributeType, "H5Aget_type", Id, (Id))                                                                     \
  ROW(AttributeSpace, "H5Aget_space", Id, (Id))                                                                   \
  ROW(WriteAttribute, "H5Awrite", int, (Id, Id, const void*))                                                     \
  ROW(ReadAttribute, "H5Aread", int, (Id, Id, void*))                                                             \
  ROW(HasLink, "H5Lexists", int, (Id, const char*, Id))

struct Library {
#define MIMO_DECLARED(name, symbol, returned, taken) std::add_pointer_t<returned taken> name;
  MIMO_HDF5_FIRST(MIMO_DECLARED)
  MIMO_HDF5_FUNCTIONS(MIMO_DECLARED)
#undef MIMO_DECLARED
  int (*DescribeLink)(Id, const char*, LinkInfo*, Id);
  // Types, kinds of errors and classes of properties, which are variables of the library.
  Id u8, i32, i64, u64, f32, f64, string, no_space, cannot_allocate, file_access, dataset_create, link_create;
  bool deflate;  // can compress
};

// Loads the library, once a process: that of a path, or where it is "" that of the environment variable MIMO_HDF5, or
// the system's. Throws Status::kUnsupported in one line where there is none. In programs with elevated rights the
// environment does not count.
void load(const std::string& path);
// Throws where none is loaded.
const Library& library();

// HDF5 is not for several threads: a thread holds this while it uses the library, and may hold several. What goes wrong
// is said by us in one line; the host may be using the same library, and gets its own printer of errors back. No file
// makes HDF5 load plugins meanwhile, which are programs.
class Turn {
 public:
  Turn();
  explicit Turn(std::try_to_lock_t);  // does not wait
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  bool mine() const { return alone_.owns_lock(); }

 private:
  void begin();

  std::unique_lock<std::recursive_mutex> alone_;
  ErrorPrinter printer_ = nullptr;
  void* data_ = nullptr;
  unsigned plugins_ = 0;
};

// Why HDF5 did not do the last thing that it was asked for in this turn.
struct Reason {
  bool no_memory = false;
  char system[128] = "";  // the system's words, where it was the system
};
Reason last_reason();

// What HDF5 gave, closed when it goes; it goes within a turn.
class Handle {
 public:
  Handle() = default;
  Handle(Id id, int (*closes)(Id)) : id_(id), close_(closes) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Id id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  // Closes it now; negative where HDF5 could not, which must not be asked again.
  int close() { return id_ < 0 ? 0 : close_(std::exchange(id_, -1)); }

 private:
  Id id_ = -1;
  int (*close_)(Id) = nullptr;
};

// Calls transfer(memory, place) with the spaces of `count` rows of a dataset from `first` on; `extents` are its sizes.
// Returns what that returns.
template <typename Transfer>
int with_rows(Id dataset, std::vector<Size> extents, Size first, Size count, Transfer&& transfer) {
  const Library& h5 = library();
  std::vector<Size> start(extents.size());
  start[0] = first;
  extents[0] = count;
  const Handle memory(h5.CreateSimpleSpace(static_cast<int>(extents.size()), extents.data(), nullptr), h5.CloseSpace);
  const Handle place(h5.DatasetSpace(dataset), h5.CloseSpace);
  if (!memory || !place) return -1;
  if (h5.SelectHyperslab(place.id(), kSelectSet, start.data(), nullptr, extents.data(), nullptr) < 0) return -1;
  return transfer(memory.id(), place.id());
}

}  // namespace mimo::recording::hdf5
