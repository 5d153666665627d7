// The HDF5 file of a recording: tables that grow by rows, and attributes. docs/guide/recordings.md has the layout.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hdf5.h"

namespace cli {

constexpr char kRecordingFormat[] = "mimo recording";
constexpr std::int64_t kRecordingVersion = 1;

// Written while a run goes on: what has been flushed stays readable, however the process ends.
class RecordingWriter {
 public:
  RecordingWriter(std::string path, unsigned compression);
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  // All attributes and tables come before start().
  void attribute(const std::string& name, const std::string& text);
  void attribute(const std::string& name, std::int64_t value);
  void attribute(const std::string& name, double value);
  // Rows have this shape; unit and names (of a row's elements, a line each) may be "".
  void table(const std::string& name, hdf5::Id type, const std::vector<std::size_t>& shape, const std::string& unit,
             const std::string& names = "");
  void start();

  void append(const std::string& table, const void* row);  // kept until flush() or until there are many
  void flush();
  void close();

 private:
  struct Table {
    hdf5::Id dataset, type;
    std::vector<hdf5::Size> extents;  // of all rows written; the first is their number
    std::size_t row_bytes, chunk_rows;
    std::vector<std::uint8_t> waiting;
  };

  void check(std::int64_t result) const;
  void write_attribute(hdf5::Id object, const std::string& name, hdf5::Id type, const void* value) const;
  void write_text(hdf5::Id object, const std::string& name, const std::string& text) const;
  void write_waiting(Table& table) const;

  const hdf5::Library& h5_;
  std::string path_;
  unsigned compression_;
  hdf5::Id file_ = -1;
  std::map<std::string, Table> tables_;
};

class RecordingReader {
 public:
  // Throws a Failure for what is no recording, is damaged, or comes from a newer version.
  explicit RecordingReader(std::string path);
  ~RecordingReader();
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;

  const std::string& path() const { return path_; }
  std::string text(const std::string& attribute) const;
  std::int64_t integer(const std::string& attribute) const;
  bool has(const std::string& table) const;
  std::size_t rows(const std::string& table) const;
  std::size_t row_bytes(const std::string& table) const;
  std::vector<std::uint8_t> row(const std::string& table, std::size_t index) const;

 private:
  struct Table {
    hdf5::Id dataset = -1, type = -1;
    std::vector<hdf5::Size> extents;
    std::size_t row_bytes = 0;
  };

  [[noreturn]] void damaged(const std::string& what) const;
  const Table& open(const std::string& name) const;

  const hdf5::Library& h5_;
  std::string path_;
  hdf5::Id file_ = -1;
  mutable std::map<std::string, Table> tables_;
};

}  // namespace cli
