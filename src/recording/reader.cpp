#include <fstream>

#include "base/fail.h"
#include "recording/file.h"

namespace mimo::recording {
namespace {

hdf5::Id open_file(const hdf5::Library& h5, const std::string& path) {
  if (!std::ifstream(path)) {
    fail(Status::kNotFound, "cannot read {}: there is no such file, or it may not be read", path);
  }
  const hdf5::Turn turn;
  const hdf5::Id file = h5.OpenFile(path.c_str(), hdf5::kReadOnly, hdf5::kDefault);
  if (file >= 0) return file;
  // Of a run that goes on, or that was killed.
  const hdf5::Id growing = h5.OpenFile(path.c_str(), hdf5::kReadOnly | hdf5::kSwmrRead, hdf5::kDefault);
  if (growing < 0) fail(Status::kFile, "{} is not a recording, or was cut off: HDF5 cannot open it", path);
  return growing;
}

}  // namespace

Reader::Reader(std::string path) : h5_(hdf5::library()), path_(std::move(path)), file_(open_file(h5_, path_)) {
  const hdf5::Turn turn;
  try {
    check_format();
  } catch (...) {
    h5_.CloseFile(file_);
    throw;
  }
}

void Reader::check_format() const {
  const hdf5::Id format = h5_.OpenAttribute(file_, "format", hdf5::kDefault);
  if (format < 0) fail(Status::kFile, "{} is an HDF5 file, but not a recording: it has no attribute 'format'", path_);
  h5_.CloseAttribute(format);
  if (text("format") != kFormat) damaged("its attribute 'format' is not '" + std::string(kFormat) + "'");
  const std::int64_t version = integer("format_version");
  if (version > kVersion) {
    fail(Status::kUnsupported, "{} has format version {}, and this library reads up to {}", path_, version, kVersion);
  }
}

Reader::~Reader() {
  const hdf5::Turn turn;
  for (auto& [name, table] : tables_) {
    h5_.CloseType(table.type);
    h5_.CloseDataset(table.dataset);
  }
  h5_.CloseFile(file_);
}

void Reader::damaged(const std::string& what) const {
  fail(Status::kFile, "{} is not a whole recording: {}", path_, what);
}

std::string Reader::text(const std::string& name) const {
  const hdf5::Turn turn;
  const hdf5::Id attribute = h5_.OpenAttribute(file_, name.c_str(), hdf5::kDefault);
  if (attribute < 0) damaged("it has no attribute '" + name + "'");
  const hdf5::Id stored = h5_.AttributeType(attribute), type = h5_.CopyType(h5_.string);
  const std::size_t size = h5_.TypeSize(stored);
  std::string value(size + 1, '\0');
  h5_.SetTypeSize(type, size + 1);
  const int result = h5_.ReadAttribute(attribute, type, value.data());
  h5_.CloseType(type);
  h5_.CloseType(stored);
  h5_.CloseAttribute(attribute);
  if (result < 0) damaged("its attribute '" + name + "' is not a text");
  return value.substr(0, value.find('\0'));
}

std::int64_t Reader::integer(const std::string& name) const {
  std::int64_t value = 0;
  read_number(name, h5_.i64, &value);
  return value;
}

double Reader::real(const std::string& name) const {
  double value = 0;
  read_number(name, h5_.f64, &value);
  return value;
}

void Reader::read_number(const std::string& name, hdf5::Id type, void* value) const {
  const hdf5::Turn turn;
  const hdf5::Id attribute = h5_.OpenAttribute(file_, name.c_str(), hdf5::kDefault);
  if (attribute < 0) damaged("it has no attribute '" + name + "'");
  const int result = h5_.ReadAttribute(attribute, type, value);
  h5_.CloseAttribute(attribute);
  if (result < 0) damaged("its attribute '" + name + "' is not a number");
}

bool Reader::has(const std::string& table) const {
  const hdf5::Turn turn;
  return tables_.count(table) != 0 || has_link(table);
}

bool Reader::has_dataset(const std::string& name) const {
  const hdf5::Turn turn;
  if (name.empty() || name.front() == '/' || name.back() == '/' || !has(name)) return false;
  if (tables_.count(name) != 0) return true;
  const hdf5::Id dataset = h5_.OpenDataset(file_, name.c_str(), hdf5::kDefault);
  if (dataset >= 0) h5_.CloseDataset(dataset);
  return dataset >= 0;
}

bool Reader::has_link(const std::string& table) const {
  for (std::size_t end = table.find('/'); end != std::string::npos; end = table.find('/', end + 1)) {
    if (h5_.HasLink(file_, table.substr(0, end).c_str(), hdf5::kDefault) <= 0) return false;
  }
  return h5_.HasLink(file_, table.c_str(), hdf5::kDefault) > 0;
}

const Reader::Table& Reader::open(const std::string& name) const {
  const hdf5::Turn turn;
  const auto found = tables_.find(name);
  if (found != tables_.end()) return found->second;
  Table table;
  table.dataset = has_link(name) ? h5_.OpenDataset(file_, name.c_str(), hdf5::kDefault) : -1;
  if (table.dataset < 0) damaged("it has no '" + name + "'");
  table.type = h5_.DatasetType(table.dataset);
  const hdf5::Id space = h5_.DatasetSpace(table.dataset);
  const int rank = h5_.Dimensions(space);
  table.extents.resize(rank < 1 ? 1 : static_cast<std::size_t>(rank));
  if (rank >= 1) h5_.Extents(space, table.extents.data(), nullptr);
  h5_.CloseSpace(space);
  table.row_bytes = h5_.TypeSize(table.type);
  for (std::size_t i = 1; i < table.extents.size(); ++i) table.row_bytes *= table.extents[i];
  return tables_.emplace(name, std::move(table)).first->second;
}

std::size_t Reader::rows(const std::string& table) const { return open(table).extents[0]; }

std::size_t Reader::row_bytes(const std::string& table) const { return open(table).row_bytes; }

void Reader::read(const std::string& name, std::size_t first, std::size_t count, Span<std::uint8_t> bytes) const {
  const hdf5::Turn turn;
  const Table& table = open(name);
  if (first > table.extents[0] || count > table.extents[0] - first) {
    damaged("'" + name + "' ends before row " + std::to_string(first + count - 1));
  }
  if (count == 0) return;
  const int result = hdf5::with_rows(table.dataset, table.extents, first, count, [&](hdf5::Id memory, hdf5::Id place) {
    return h5_.Read(table.dataset, table.type, memory, place, hdf5::kDefault, bytes.data());
  });
  if (result < 0) damaged("row " + std::to_string(first) + " of '" + name + "' cannot be read");
}

std::vector<std::uint8_t> Reader::row(const std::string& name, std::size_t index) const {
  std::vector<std::uint8_t> bytes(row_bytes(name));
  read(name, index, 1, bytes);
  return bytes;
}

}  // namespace mimo::recording
