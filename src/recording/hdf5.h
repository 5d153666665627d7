// The functions of the HDF5 library that recordings need, loaded when a recording is made or read: all else works
// without the library. Numbers and types are those of HDF5 1.10 and later, where handles have 64 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
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

struct Library {
  int (*Open)();
  int (*LibraryVersion)(unsigned*, unsigned*, unsigned*);
  int (*GetErrorPrinter)(Id, ErrorPrinter*, void**);
  int (*SetErrorPrinter)(Id, ErrorPrinter, void*);
  int (*ClearErrors)(Id);
  int (*WalkErrors)(Id, int, int (*)(unsigned, const Problem*, void*), void*);
  int (*FilterAvailable)(int);
  int (*GetPlugins)(unsigned*);
  int (*SetPlugins)(unsigned);
  Id (*CreateFile)(const char*, unsigned, Id, Id);
  Id (*OpenFile)(const char*, unsigned, Id);
  int (*CloseFile)(Id);
  int (*FileOfSystem)(Id, Id, void**);
  int (*Flush)(Id, int);
  int (*StartSwmrWrite)(Id);
  Id (*CreateProperties)(Id);
  int (*CloseProperties)(Id);
  int (*SetVersions)(Id, int, int);
  int (*SetReadAttempts)(Id, unsigned);
  int (*SetChunk)(Id, int, const Size*);
  int (*SetDeflate)(Id, unsigned);
  int (*SetShuffle)(Id);
  int (*SetCreateGroups)(Id, unsigned);
  int (*Layout)(Id);
  int (*Chunk)(Id, int, Size*);
  int (*ExternalFiles)(Id);
  int (*FilterCount)(Id);
  int (*Filter)(Id, unsigned, unsigned*, std::size_t*, unsigned*, std::size_t, char*, unsigned*);
  Id (*CreateSimpleSpace)(int, const Size*, const Size*);
  Id (*CreateSpace)(int);
  int (*CloseSpace)(Id);
  int (*SelectHyperslab)(Id, int, const Size*, const Size*, const Size*, const Size*);
  long long (*Points)(Id);
  int (*Dimensions)(Id);
  int (*Extents)(Id, Size*, Size*);
  Id (*CopyType)(Id);
  int (*SetTypeSize)(Id, std::size_t);
  std::size_t (*TypeSize)(Id);
  int (*TypeClass)(Id);
  int (*SameType)(Id, Id);
  int (*IsVariableText)(Id);
  int (*CloseType)(Id);
  Id (*CreateDataset)(Id, const char*, Id, Id, Id, Id, Id);
  Id (*OpenDataset)(Id, const char*, Id);
  int (*CloseDataset)(Id);
  int (*SetExtent)(Id, const Size*);
  Id (*DatasetSpace)(Id);
  Id (*DatasetType)(Id);
  Id (*DatasetProperties)(Id);
  int (*Write)(Id, Id, Id, Id, Id, const void*);
  int (*Read)(Id, Id, Id, Id, Id, void*);
  Id (*CreateAttribute)(Id, const char*, Id, Id, Id, Id);
  Id (*OpenAttribute)(Id, const char*, Id);
  int (*CloseAttribute)(Id);
  Id (*AttributeType)(Id);
  Id (*AttributeSpace)(Id);
  int (*WriteAttribute)(Id, Id, const void*);
  int (*ReadAttribute)(Id, Id, void*);
  int (*HasLink)(Id, const char*, Id);
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
