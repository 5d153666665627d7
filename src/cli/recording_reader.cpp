#include <fstream>

#include "failure.h"
#include "recording_file.h"

namespace cli {
namespace {

hdf5::Id open_file(const hdf5::Library& h5, const std::string& path) {
  if (!std::ifstream(path)) throw Failure("cannot read " + path + ": there is no such file, or it may not be read");
  const hdf5::Id file = h5.OpenFile(path.c_str(), hdf5::kReadOnly, hdf5::kDefault);
  if (file >= 0) return file;
  // Of a run that goes on, or that was killed.
  const hdf5::Id growing = h5.OpenFile(path.c_str(), hdf5::kReadOnly | hdf5::kSwmrRead, hdf5::kDefault);
  if (growing < 0) throw Failure(path + " is not a recording, or was cut off: HDF5 cannot open it");
  return growing;
}

}  // namespace

RecordingReader::RecordingReader(std::string path)
    : h5_(hdf5::library()), path_(std::move(path)), file_(open_file(h5_, path_)) {
  const hdf5::Id format = h5_.OpenAttribute(file_, "format", hdf5::kDefault);
  if (format < 0) {
    h5_.CloseFile(file_);
    throw Failure(path_ + " is an HDF5 file, but not a recording: it has no attribute 'format'");
  }
  h5_.CloseAttribute(format);
  if (text("format") != kRecordingFormat)
    damaged("its attribute 'format' is not '" + std::string(kRecordingFormat) + "'");
  const std::int64_t version = integer("format_version");
  if (version > kRecordingVersion) {
    throw Failure(path_ + " has format version " + std::to_string(version) + ", and this program reads up to " +
                  std::to_string(kRecordingVersion));
  }
}

RecordingReader::~RecordingReader() {
  for (auto& [name, table] : tables_) {
    h5_.CloseType(table.type);
    h5_.CloseDataset(table.dataset);
  }
  h5_.CloseFile(file_);
}

void RecordingReader::damaged(const std::string& what) const {
  throw Failure(path_ + " is not a whole recording: " + what);
}

std::string RecordingReader::text(const std::string& name) const {
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
  return value.c_str();
}

std::int64_t RecordingReader::integer(const std::string& name) const {
  const hdf5::Id attribute = h5_.OpenAttribute(file_, name.c_str(), hdf5::kDefault);
  if (attribute < 0) damaged("it has no attribute '" + name + "'");
  std::int64_t value = 0;
  const int result = h5_.ReadAttribute(attribute, h5_.i64, &value);
  h5_.CloseAttribute(attribute);
  if (result < 0) damaged("its attribute '" + name + "' is not a number");
  return value;
}

bool RecordingReader::has(const std::string& table) const {
  for (std::size_t end = table.find('/'); end != std::string::npos; end = table.find('/', end + 1)) {
    if (h5_.HasLink(file_, table.substr(0, end).c_str(), hdf5::kDefault) <= 0) return false;
  }
  return h5_.HasLink(file_, table.c_str(), hdf5::kDefault) > 0;
}

const RecordingReader::Table& RecordingReader::open(const std::string& name) const {
  const auto found = tables_.find(name);
  if (found != tables_.end()) return found->second;
  Table table;
  table.dataset = has(name) ? h5_.OpenDataset(file_, name.c_str(), hdf5::kDefault) : -1;
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

std::size_t RecordingReader::rows(const std::string& table) const { return open(table).extents[0]; }

std::size_t RecordingReader::row_bytes(const std::string& table) const { return open(table).row_bytes; }

std::vector<std::uint8_t> RecordingReader::row(const std::string& name, std::size_t index) const {
  const Table& table = open(name);
  if (index >= table.extents[0]) damaged("'" + name + "' ends before row " + std::to_string(index));
  std::vector<std::uint8_t> bytes(table.row_bytes);
  const int result = hdf5::with_rows(table.dataset, table.extents, index, 1, [&](hdf5::Id memory, hdf5::Id place) {
    return h5_.Read(table.dataset, table.type, memory, place, hdf5::kDefault, bytes.data());
  });
  if (result < 0) damaged("row " + std::to_string(index) + " of '" + name + "' cannot be read");
  return bytes;
}

}  // namespace cli
