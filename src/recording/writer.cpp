#include <algorithm>

#include "base/fail.h"
#include "recording/file.h"
#include "recording/system.h"

namespace mimo::recording {
namespace {

constexpr std::size_t kChunkBytes = 256 * 1024, kMostRows = 1024;

}  // namespace

Writer::Writer(std::string path, unsigned compression)
    : h5_(hdf5::library()), path_(std::move(path)), compression_(compression) {
  const hdf5::Turn turn;
  // What is needed for a file that stays whole while it grows ("single writer, multiple readers").
  const hdf5::Id access = h5_.CreateProperties(h5_.file_access);
  h5_.SetVersions(access, hdf5::kVersion110, hdf5::kVersion110);
  file_ = h5_.CreateFile(path_.c_str(), hdf5::kTruncate, hdf5::kDefault, access);
  h5_.CloseProperties(access);
  check(file_);
}

Writer::~Writer() {
  const hdf5::Turn turn;
  for (auto& [name, table] : tables_) h5_.CloseDataset(table.dataset);
  if (file_ >= 0) h5_.CloseFile(file_);
}

void Writer::check(std::int64_t result) const {
  if (result < 0) {
    fail(Status::kFile, "cannot write {}: HDF5 refused; is there room, and the right to write?", path_);
  }
}

void Writer::write_attribute(hdf5::Id object, const std::string& name, hdf5::Id type, const void* value) const {
  const hdf5::Turn turn;
  const hdf5::Id space = h5_.CreateSpace(hdf5::kScalar);
  const hdf5::Id attribute = h5_.CreateAttribute(object, name.c_str(), type, space, hdf5::kDefault, hdf5::kDefault);
  h5_.CloseSpace(space);
  check(attribute);
  check(h5_.WriteAttribute(attribute, type, value));
  h5_.CloseAttribute(attribute);
}

void Writer::write_text(hdf5::Id object, const std::string& name, const std::string& text) const {
  const hdf5::Turn turn;
  const hdf5::Id type = h5_.CopyType(h5_.string);
  h5_.SetTypeSize(type, text.size() + 1);
  write_attribute(object, name, type, text.c_str());
  h5_.CloseType(type);
}

void Writer::attribute(const std::string& name, const std::string& text) { write_text(file_, name, text); }

void Writer::attribute(const std::string& name, std::int64_t value) { write_attribute(file_, name, h5_.i64, &value); }

void Writer::attribute(const std::string& name, double value) { write_attribute(file_, name, h5_.f64, &value); }

void Writer::table(const std::string& name, hdf5::Id type, const std::vector<std::size_t>& shape,
                   const std::string& unit, const std::string& names, Rows rows) {
  const hdf5::Turn turn;
  Table table{-1, type, {0}, h5_.TypeSize(type), 1, {}};
  for (const std::size_t extent : shape) {
    table.extents.push_back(extent);
    table.row_bytes *= extent;
  }
  if (table.row_bytes == 0) return;  // no joints, no actions: nothing to keep
  table.chunk_rows = std::clamp<std::size_t>(kChunkBytes / table.row_bytes, 1, kMostRows);
  auto most = table.extents, chunk = table.extents;
  most[0] = hdf5::kUnlimited;
  if (rows == Rows::kMayGrow) most[1] = hdf5::kUnlimited;
  chunk[0] = table.chunk_rows;
  const int rank = static_cast<int>(chunk.size());
  const hdf5::Id space = h5_.CreateSimpleSpace(rank, table.extents.data(), most.data());
  const hdf5::Id layout = h5_.CreateProperties(h5_.dataset_create), groups = h5_.CreateProperties(h5_.link_create);
  h5_.SetCreateGroups(groups, 1);
  h5_.SetChunk(layout, rank, chunk.data());
  if (compression_ != 0 && h5_.deflate) {
    h5_.SetShuffle(layout);
    h5_.SetDeflate(layout, compression_);
  }
  table.dataset = h5_.CreateDataset(file_, name.c_str(), type, space, groups, layout, hdf5::kDefault);
  h5_.CloseProperties(groups);
  h5_.CloseProperties(layout);
  h5_.CloseSpace(space);
  check(table.dataset);
  if (!unit.empty()) write_text(table.dataset, "unit", unit);
  if (!names.empty()) write_text(table.dataset, "names", names);
  tables_.emplace(name, std::move(table));
}

void Writer::start() {
  const hdf5::Turn turn;
  check(h5_.StartSwmrWrite(file_));
  check(h5_.Flush(file_, hdf5::kGlobalScope));
}

void Writer::append(const std::string& name, const void* row) {
  const auto found = tables_.find(name);
  if (found == tables_.end()) return;  // rows of no bytes
  append(found->second, {static_cast<const std::uint8_t*>(row), found->second.row_bytes});
}

void Writer::append(const std::string& name, Span<const std::uint8_t> row) { append(tables_.at(name), row); }

void Writer::append(Table& table, Span<const std::uint8_t> row) const {
  if (row.size() > table.row_bytes) lengthen(table, row.size());
  table.waiting.insert(table.waiting.end(), row.begin(), row.end());
  table.waiting.resize(table.waiting.size() + table.row_bytes - row.size());
  if (table.waiting.size() >= table.chunk_rows * table.row_bytes) write_waiting(table);
}

void Writer::lengthen(Table& table, std::size_t row_bytes) const {
  write_waiting(table);
  table.extents.back() = table.row_bytes = row_bytes;
  const hdf5::Turn turn;
  check(h5_.SetExtent(table.dataset, table.extents.data()));
}

void Writer::write_waiting(Table& table) const {
  if (table.waiting.empty()) return;
  const hdf5::Turn turn;
  const hdf5::Size first = table.extents[0], count = table.waiting.size() / table.row_bytes;
  table.extents[0] += count;
  check(h5_.SetExtent(table.dataset, table.extents.data()));
  check(hdf5::with_rows(table.dataset, table.extents, first, count, [&](hdf5::Id memory, hdf5::Id place) {
    return h5_.Write(table.dataset, table.type, memory, place, hdf5::kDefault, table.waiting.data());
  }));
  table.waiting.clear();
}

void Writer::flush() {
  const hdf5::Turn turn;
  for (auto& [name, table] : tables_) write_waiting(table);
  check(h5_.Flush(file_, hdf5::kGlobalScope));
}

// What HDF5 could not write it would try again when the process ends, and complain on the error stream. So it writes
// the rest to nowhere.
void Writer::abandon() noexcept {
  if (file_ < 0) return;
  const hdf5::Turn turn;
  void* descriptor = nullptr;
  if (h5_.FileOfSystem(file_, hdf5::kDefault, &descriptor) < 0 || descriptor == nullptr) return;
  write_to_nowhere(*static_cast<const int*>(descriptor));
}

void Writer::close() {
  const hdf5::Turn turn;
  flush();
  for (auto& [name, table] : tables_) check(h5_.CloseDataset(table.dataset));
  tables_.clear();
  const hdf5::Id file = file_;
  file_ = -1;
  check(h5_.CloseFile(file));
}

}  // namespace mimo::recording
