#include <algorithm>

#include "base/fail.h"
#include "recording/file.h"
#include "recording/system.h"

namespace mimo::recording {
namespace {

constexpr std::size_t kChunkBytes = 256 * 1024, kMostRows = 1024;
constexpr std::size_t kPatience = 64;  // chunks that wait until HDF5 is waited for

// Of a few hundred measured numbers only the exponents repeat. Deflate saves a quarter of them, and takes ten times as
// long as everything else that a recorder does: that is for those who ask for small files.
constexpr unsigned kSmallFiles = 5;
constexpr std::size_t kFewBytes = 4096;

// Zeros come behind the rows that wait. The file follows when they are written.
template <typename Table>
void widen(Table& table, std::size_t row_bytes) {
  const std::size_t rows = table.waiting.size() / table.row_bytes;
  std::vector<std::uint8_t> wider(rows * row_bytes);
  for (std::size_t i = 0; i < rows; ++i) {
    std::copy_n(table.waiting.data() + i * table.row_bytes, table.row_bytes, wider.data() + i * row_bytes);
  }
  table.waiting = std::move(wider);
  table.extents.back() = table.row_bytes = row_bytes;
}

}  // namespace

Writer::Writer(const std::string& path, bool replace, unsigned compression, std::size_t content)
    : h5_(hdf5::library()), place_(path, replace), compression_(compression) {
  place_.require_room(content);
  const hdf5::Turn turn;
  // What is needed for a file that stays whole while it grows ("single writer, multiple readers").
  const hdf5::Handle access(h5_.CreateProperties(h5_.file_access), h5_.CloseProperties);
  h5_.SetVersions(access.id(), hdf5::kVersion110, hdf5::kVersion110);
  file_ = hdf5::Handle(h5_.CreateFile(place_.file().c_str(), hdf5::kMustBeNew, hdf5::kDefault, access.id()),  //
                       h5_.CloseFile);
  check(file_.id());
  place_.made();
}

// What HDF5 could not write it would try again now, and when the process ends, and complain on the error stream. So it
// writes the rest to nowhere.
Writer::~Writer() {
  const hdf5::Turn turn;
  const int open = descriptor();
  if (open >= 0) {
    end_claim(open);
    write_to_nowhere(open);
  }
  tables_.clear();
  file_.close();
}

int Writer::descriptor() const {
  void* descriptor = nullptr;
  if (!file_ || h5_.FileOfSystem(file_.id(), hdf5::kDefault, &descriptor) < 0 || descriptor == nullptr) return -1;
  return *static_cast<const int*>(descriptor);
}

// Of what HDF5 was asked for last.
void Writer::check(std::int64_t result) const {
  if (result >= 0) return;
  const hdf5::Reason reason = hdf5::last_reason();
  if (reason.no_memory) fail(Status::kOutOfMemory, "cannot write {}: HDF5 has no memory", place_.path());
  const char* const why = reason.system[0] != '\0' ? reason.system : "HDF5 refused";
  fail(Status::kFile, "cannot write {}: {}; check the free space and the permissions", place_.path(), why);
}

void Writer::write_attribute(hdf5::Id object, const std::string& name, hdf5::Id type, const void* value) const {
  const hdf5::Turn turn;
  const hdf5::Handle space(h5_.CreateSpace(hdf5::kScalar), h5_.CloseSpace);
  check(space.id());
  const hdf5::Id created = h5_.CreateAttribute(object, name.c_str(), type, space.id(), hdf5::kDefault, hdf5::kDefault);
  const hdf5::Handle attribute(created, h5_.CloseAttribute);
  check(created);
  check(h5_.WriteAttribute(created, type, value));
}

void Writer::write_text(hdf5::Id object, const std::string& name, const std::string& text) const {
  const hdf5::Turn turn;
  const hdf5::Handle type(h5_.CopyType(h5_.string), h5_.CloseType);
  check(type.id());
  h5_.SetTypeSize(type.id(), text.size() + 1);
  write_attribute(object, name, type.id(), text.c_str());
}

void Writer::attribute(const std::string& name, const std::string& text) { write_text(file_.id(), name, text); }

void Writer::attribute(const std::string& name, std::int64_t value) {
  write_attribute(file_.id(), name, h5_.i64, &value);
}

void Writer::attribute(const std::string& name, double value) { write_attribute(file_.id(), name, h5_.f64, &value); }

void Writer::table(const std::string& name, hdf5::Id type, const std::vector<std::size_t>& shape,
                   const std::string& unit, const std::string& names, Rows rows) {
  const hdf5::Turn turn;
  Table table{{}, type, {0}, h5_.TypeSize(type), 1, {}};
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
  const hdf5::Handle space(h5_.CreateSimpleSpace(rank, table.extents.data(), most.data()), h5_.CloseSpace);
  const bool few_floats = (type == h5_.f32 || type == h5_.f64) && table.row_bytes <= kFewBytes;
  table.dataset = make_dataset(name, type, space, chunk, few_floats && compression_ < kSmallFiles ? 0 : compression_);
  if (!unit.empty()) write_text(table.dataset.id(), "unit", unit);
  if (!names.empty()) write_text(table.dataset.id(), "names", names);
  tables_.emplace(name, std::move(table));
}

hdf5::Handle Writer::make_dataset(const std::string& name, hdf5::Id type, const hdf5::Handle& space,
                                  const std::vector<hdf5::Size>& chunk, unsigned compression) const {
  const hdf5::Handle layout(h5_.CreateProperties(h5_.dataset_create), h5_.CloseProperties);
  const hdf5::Handle groups(h5_.CreateProperties(h5_.link_create), h5_.CloseProperties);
  h5_.SetCreateGroups(groups.id(), 1);
  h5_.SetChunk(layout.id(), static_cast<int>(chunk.size()), chunk.data());
  if (compression != 0 && h5_.deflate) {
    h5_.SetShuffle(layout.id());
    h5_.SetDeflate(layout.id(), compression);
  }
  hdf5::Handle dataset(
      h5_.CreateDataset(file_.id(), name.c_str(), type, space.id(), groups.id(), layout.id(), hdf5::kDefault),
      h5_.CloseDataset);
  check(dataset.id());
  return dataset;
}

void Writer::content(const std::string& name, Span<const std::uint8_t> bytes) {
  if (bytes.size() == 0) return;
  const hdf5::Turn turn;
  const std::vector<hdf5::Size> extent{bytes.size()}, chunk{std::min(bytes.size(), kChunkBytes)};
  const hdf5::Handle space(h5_.CreateSimpleSpace(1, extent.data(), nullptr), h5_.CloseSpace);
  const hdf5::Handle dataset = make_dataset(name, h5_.u8, space, chunk, compression_);
  check(hdf5::with_rows(dataset.id(), extent, 0, extent[0], [&](hdf5::Id memory, hdf5::Id place) {
    return h5_.Write(dataset.id(), h5_.u8, memory, place, hdf5::kDefault, bytes.data());
  }));
}

void Writer::start() {
  const hdf5::Turn turn;
  check(h5_.Flush(file_.id(), hdf5::kGlobalScope));
  check(h5_.StartSwmrWrite(file_.id()));
  check(h5_.Flush(file_.id(), hdf5::kGlobalScope));
  place_.settle(descriptor());
}

void Writer::append(const std::string& name, const void* row) {
  const auto found = tables_.find(name);
  if (found == tables_.end()) return;  // rows of no bytes
  append(found->second, {static_cast<const std::uint8_t*>(row), found->second.row_bytes});
}

void Writer::append(const std::string& name, Span<const std::uint8_t> row) { append(tables_.at(name), row); }

void Writer::append(Table& table, Span<const std::uint8_t> row) {
  if (row.size() > table.row_bytes) widen(table, row.size());
  table.waiting.insert(table.waiting.end(), row.begin(), row.end());
  table.waiting.resize(table.waiting.size() + table.row_bytes - row.size());
  const std::size_t chunk = table.chunk_rows * table.row_bytes;
  if (table.waiting.size() < chunk) return;
  if (table.waiting.size() >= kPatience * chunk) return write_waiting(table);
  const hdf5::Turn turn(std::try_to_lock);
  if (turn.mine()) write_waiting(table);
}

void Writer::write_waiting(Table& table) {
  if (table.waiting.empty()) return;
  const hdf5::Turn turn;
  place_.require_untouched(descriptor());
  const hdf5::Id dataset = table.dataset.id();
  const hdf5::Size first = table.extents[0], count = table.waiting.size() / table.row_bytes;
  table.extents[0] += count;
  check(h5_.SetExtent(dataset, table.extents.data()));
  check(hdf5::with_rows(dataset, table.extents, first, count, [&](hdf5::Id memory, hdf5::Id place) {
    return h5_.Write(dataset, table.type, memory, place, hdf5::kDefault, table.waiting.data());
  }));
  table.waiting.clear();
  place_.written(descriptor());
}

void Writer::flush() {
  const hdf5::Turn turn;
  place_.require_untouched(descriptor());
  for (auto& [name, table] : tables_) write_waiting(table);
  check(h5_.Flush(file_.id(), hdf5::kGlobalScope));
  place_.written(descriptor());
}

bool Writer::flush_if_free() {
  const hdf5::Turn turn(std::try_to_lock);
  if (turn.mine()) flush();
  return turn.mine();
}

void Writer::close() {
  const hdf5::Turn turn;
  flush();
  for (auto& [name, table] : tables_) check(table.dataset.close());
  tables_.clear();
  end_claim(descriptor());
  check(file_.close());
}

}  // namespace mimo::recording
