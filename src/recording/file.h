// The HDF5 file of a recording: tables that grow by rows, and attributes. docs/guide/recordings.md has the layout.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/span.h"
#include "recording/hdf5.h"
#include "recording/place.h"

namespace mimo::recording {

constexpr char kFormat[] = "mimo recording";
// 1: of runs that nothing but actions changed; 2: without the world and the results of steps
constexpr std::int64_t kVersion = 3;

// Tables that every recording has, and those of states; a field's is "fields/<name>".
constexpr char kTime[] = "time", kActions[] = "actions", kRewards[] = "rewards", kJointPosition[] = "joints/position",
               kJointVelocity[] = "joints/velocity", kStates[] = "states/state", kStateSteps[] = "states/step",
               kStateGiven[] = "states/given", kStateBodies[] = "states/body", kBodies[] = "bodies/growth",
               kModels[] = "bodies/model_hash", kTerminated[] = "terminated", kTruncated[] = "truncated",
               kOutcome[] = "outcome", kTerms[] = "terms", kDocuments[] = "scene/document", kWorld[] = "world";
constexpr char kSceneFolder[] = "scene/";  // before the names of files that documents refer to

// What a row of states/given says of a state: a step led to it, something else changed the world, or the steps from
// there on follow a known movement, which only a replay by joints can.
enum StateMark : std::uint8_t { kReached, kGiven, kMoves };

// Written while a run goes on: what has been flushed stays readable, however the process ends. Both classes throw, and
// take their turn with HDF5 by themselves.
class Writer {
 public:
  // `content` is about how many bytes do not change.
  Writer(const std::string& path, bool replace, unsigned compression, std::size_t content);
  ~Writer();  // leaves the file as it is on the disk where it was not closed; one that was not started goes
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // All attributes and tables come before start().
  void attribute(const std::string& name, const std::string& text);
  void attribute(const std::string& name, std::int64_t value);
  void attribute(const std::string& name, double value);
  // Rows have this shape; unit and names (of a row's elements, a line each) may be "". Rows that may grow
  // are of one extent and of bytes; shorter ones have zeros behind them.
  enum class Rows { kFixed, kMayGrow };
  void table(const std::string& name, hdf5::Id type, const std::vector<std::size_t>& shape, const std::string& unit,
             const std::string& names = "", Rows rows = Rows::kFixed);
  // Bytes that do not change.
  void content(const std::string& name, Span<const std::uint8_t> bytes);
  void start();

  // Rows are kept until flush() or until there are many. While another thread uses HDF5, which may take as long as a
  // disk takes, there may be very many before it is waited for.
  void append(const std::string& table, const void* row);
  void append(const std::string& table, Span<const std::uint8_t> row);  // that may have grown
  void flush();
  bool flush_if_free();  // false, and nothing done, while another thread uses HDF5
  void close();

 private:
  struct Table {
    hdf5::Handle dataset;
    hdf5::Id type;
    std::vector<hdf5::Size> extents;  // of all rows written; the first is their number
    std::size_t row_bytes, chunk_rows;
    std::vector<std::uint8_t> waiting;
  };

  void check(std::int64_t result) const;
  void write_attribute(hdf5::Id object, const std::string& name, hdf5::Id type, const void* value) const;
  void write_text(hdf5::Id object, const std::string& name, const std::string& text) const;
  void append(Table& table, Span<const std::uint8_t> row);
  void write_waiting(Table& table);
  hdf5::Handle make_dataset(const std::string& name, hdf5::Id type, const hdf5::Handle& space,
                            const std::vector<hdf5::Size>& chunk, unsigned compression) const;
  int descriptor() const;  // of the system; negative where there is none

  const hdf5::Library& h5_;
  Place place_;
  unsigned compression_;
  hdf5::Handle file_;
  std::map<std::string, Table> tables_;
};

// Of files that anybody may have made: HDF5 is asked for nothing that was not looked at before. What is not as
// recordings are throws Status::kFile.
class Reader {
 public:
  explicit Reader(std::string path);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const std::string& path() const { return path_; }
  std::string text(const std::string& attribute) const;
  std::int64_t integer(const std::string& attribute) const;
  double real(const std::string& attribute) const;
  bool has(const std::string& table) const;         // of those that a recording has
  bool has_dataset(const std::string& name) const;  // of any, groups excluded
  // That it has numbers of this type, and rows of that many dimensions.
  void require_table(const std::string& table, hdf5::Id type, std::size_t dimensions) const;
  std::size_t rows(const std::string& table) const;
  std::size_t row_bytes(const std::string& table) const;  // rows() times this is a size_t
  // All of them must be there; `bytes` has room for them.
  void read(const std::string& table, std::size_t first, std::size_t count, Span<std::uint8_t> bytes) const;
  std::vector<std::uint8_t> row(const std::string& table, std::size_t index) const;
  std::string content(const std::string& name) const;  // of bytes in one dimension
  // Of a table with one number a row.
  template <typename T>
  std::vector<T> numbers(const std::string& table, std::size_t first, std::size_t count) const {
    if (row_bytes(table) != sizeof(T)) damaged("'" + table + "' has numbers of another length");
    std::vector<T> values(count);
    read(table, first, count, {reinterpret_cast<std::uint8_t*>(values.data()), count * sizeof(T)});
    return values;
  }
  std::uint64_t bytes() const;  // of the file
  [[noreturn]] void damaged(const std::string& what) const;

 private:
  struct Table {
    hdf5::Handle dataset, type;
    std::vector<hdf5::Size> extents;
    std::size_t row_bytes = 0;
  };
  enum class Link { kNone, kHere, kElsewhere };

  void check_format() const;
  Link find(const std::string& name) const;
  hdf5::Handle open_attribute(const std::string& name) const;
  void read_number(const std::string& name, int type_class, hdf5::Id type, void* value) const;
  const Table& open(const std::string& name) const;
  void open_type(const std::string& name, Table& table) const;
  void open_shape(const std::string& name, Table& table) const;
  void require_plain_storage(const std::string& name, const Table& table) const;

  const hdf5::Library& h5_;
  std::string path_;
  hdf5::Handle file_;
  mutable std::map<std::string, Table> tables_;
};

}  // namespace mimo::recording
