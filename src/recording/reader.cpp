#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/fail.h"
#include "recording/file.h"

namespace fs = std::filesystem;

namespace mimo::recording {
namespace {

// HDF5 reads what does not fit its checksum again and again while a file may be written by somebody, with waits that
// double: that many take a millisecond, its own hundred longer than the universe is old.
constexpr unsigned kReadAttempts = 20;
// The best that deflate can do.
constexpr std::uint64_t kMostInflated = 1032;
// Of what is read at once, while no other thread can use HDF5. A chunk is read as a whole.
constexpr std::size_t kPieceBytes = std::size_t{4} << 20;
constexpr hdf5::Size kMostChunkBytes = hdf5::Size{64} << 20;
constexpr std::size_t kMostDimensions = 32, kLargestNumber = 8;

// What waits for somebody else, as a pipe does, or never ends is no file.
void require_plain_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(fs::u8path(path), error);
  if (!fs::exists(status)) {
    fail(Status::kNotFound, "cannot read {}: the file does not exist, or you may not read it", path);
  }
  if (fs::is_directory(status)) fail(Status::kFile, "cannot read {}: it is a folder", path);
  if (!fs::is_regular_file(status)) fail(Status::kFile, "cannot read {}: it is not a plain file", path);
}

// Whether the file says that somebody writes it: in byte 11, the flags of HDF5's superblock. HDF5 1.14 reads any file
// as if it were growing, where no locks exist; the beginning of a whole recording would pass for one.
bool is_being_written(const std::string& path) {
  std::ifstream file(fs::u8path(path), std::ios::binary);
  std::array<char, 12> begin{};
  return file.read(begin.data(), begin.size()) && begin[11] != 0;
}

hdf5::Handle open_file(const hdf5::Library& h5, const std::string& path) {
  const hdf5::Turn turn;
  const hdf5::Id file = h5.OpenFile(path.c_str(), hdf5::kReadOnly, hdf5::kDefault);
  if (file >= 0) return hdf5::Handle(file, h5.CloseFile);
  if (hdf5::last_reason().no_memory) fail(Status::kOutOfMemory, "cannot read {}: HDF5 has no memory", path);
  if (is_being_written(path)) {  // by a run that goes on, or that was killed
    const hdf5::Handle access(h5.CreateProperties(h5.file_access), h5.CloseProperties);
    h5.SetReadAttempts(access.id(), kReadAttempts);
    const hdf5::Id growing = h5.OpenFile(path.c_str(), hdf5::kReadOnly | hdf5::kSwmrRead, access.id());
    if (growing >= 0) return hdf5::Handle(growing, h5.CloseFile);
  }
  fail(Status::kFile, "{} is not a recording, or is truncated: HDF5 cannot open it", path);
}

// A product that a size_t holds; 0 where it does not.
std::size_t product_of(const std::vector<hdf5::Size>& extents, std::size_t first, std::size_t bytes) {
  for (std::size_t i = first; i < extents.size(); ++i) {
    if (extents[i] == 0 || bytes > std::numeric_limits<std::size_t>::max() / extents[i]) return 0;
    bytes *= static_cast<std::size_t>(extents[i]);
  }
  return bytes;
}

}  // namespace

Reader::Reader(std::string path) : h5_(hdf5::library()), path_(std::move(path)) {
  require_plain_file(path_);
  const hdf5::Turn turn;
  file_ = open_file(h5_, path_);
  try {
    check_format();
  } catch (...) {
    file_.close();  // within the turn
    throw;
  }
}

Reader::~Reader() {
  const hdf5::Turn turn;
  tables_.clear();
  file_.close();
}

void Reader::check_format() const {
  const hdf5::Id format = h5_.OpenAttribute(file_.id(), "format", hdf5::kDefault);
  if (format < 0) fail(Status::kFile, "{} is an HDF5 file, but not a recording: it has no attribute 'format'", path_);
  h5_.CloseAttribute(format);
  if (text("format") != kFormat) damaged("its attribute 'format' is not '" + std::string(kFormat) + "'");
  const std::int64_t version = integer("format_version");
  if (version < 1) damaged("its attribute 'format_version' is " + std::to_string(version));
  if (version > kVersion) {
    fail(Status::kUnsupported, "{} has format version {}, and this library reads up to {}", path_, version, kVersion);
  }
}

void Reader::damaged(const std::string& what) const {
  fail(Status::kFile, "{} is not a complete recording: {}", path_, what);
}

std::uint64_t Reader::bytes() const {
  std::error_code unknown;
  return fs::file_size(fs::u8path(path_), unknown);
}

// One value, as HDF5 writes as many as there are into whatever room there is.
hdf5::Handle Reader::open_attribute(const std::string& name) const {
  hdf5::Handle attribute(h5_.OpenAttribute(file_.id(), name.c_str(), hdf5::kDefault), h5_.CloseAttribute);
  if (!attribute) damaged("it has no attribute '" + name + "'");
  const hdf5::Handle space(h5_.AttributeSpace(attribute.id()), h5_.CloseSpace);
  if (!space || h5_.Points(space.id()) != 1) damaged("its attribute '" + name + "' is not one value");
  return attribute;
}

std::string Reader::text(const std::string& name) const {
  const hdf5::Turn turn;
  const hdf5::Handle attribute = open_attribute(name);
  const hdf5::Handle stored(h5_.AttributeType(attribute.id()), h5_.CloseType);
  if (!stored || h5_.TypeClass(stored.id()) != hdf5::kText || h5_.IsVariableText(stored.id()) != 0) {
    damaged("its attribute '" + name + "' is not a text of fixed length");
  }
  const std::size_t size = h5_.TypeSize(stored.id());
  if (size > bytes()) damaged("its attribute '" + name + "' is longer than the file");
  const hdf5::Handle type(h5_.CopyType(h5_.string), h5_.CloseType);
  std::string value(size + 1, '\0');
  if (h5_.SetTypeSize(type.id(), size + 1) < 0 || h5_.ReadAttribute(attribute.id(), type.id(), value.data()) < 0) {
    damaged("its attribute '" + name + "' cannot be read");
  }
  return value.substr(0, value.find('\0'));
}

std::int64_t Reader::integer(const std::string& name) const {
  std::int64_t value = 0;
  read_number(name, hdf5::kInteger, h5_.i64, &value);
  return value;
}

double Reader::real(const std::string& name) const {
  double value = 0;
  read_number(name, hdf5::kFloat, h5_.f64, &value);
  return value;
}

void Reader::read_number(const std::string& name, int type_class, hdf5::Id type, void* value) const {
  const hdf5::Turn turn;
  const hdf5::Handle attribute = open_attribute(name);
  const hdf5::Handle stored(h5_.AttributeType(attribute.id()), h5_.CloseType);
  const bool number = stored && h5_.TypeClass(stored.id()) == type_class && h5_.TypeSize(stored.id()) <= kLargestNumber;
  if (!number) damaged("its attribute '" + name + "' is not a number of the right type");
  if (h5_.ReadAttribute(attribute.id(), type, value) < 0) damaged("its attribute '" + name + "' cannot be read");
}

// A link may lead elsewhere in the file, or into any other file, and so may each group on the way.
Reader::Link Reader::find(const std::string& name) const {
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    hdf5::LinkInfo link = {};
    if (h5_.HasLink(file_.id(), part.c_str(), hdf5::kDefault) <= 0) return Link::kNone;
    if (h5_.DescribeLink(file_.id(), part.c_str(), &link, hdf5::kDefault) < 0) return Link::kNone;
    if (link.kind != hdf5::kHardLink) return Link::kElsewhere;
    if (end == std::string::npos) return Link::kHere;
  }
}

bool Reader::has(const std::string& table) const {
  const hdf5::Turn turn;
  return tables_.count(table) != 0 || find(table) != Link::kNone;
}

bool Reader::has_dataset(const std::string& name) const {
  const hdf5::Turn turn;
  if (name.empty() || name.front() == '/' || name.back() == '/') return false;
  if (tables_.count(name) != 0) return true;
  const Link link = find(name);
  if (link != Link::kHere) return link == Link::kElsewhere;  // about which open() complains
  return static_cast<bool>(hdf5::Handle(h5_.OpenDataset(file_.id(), name.c_str(), hdf5::kDefault), h5_.CloseDataset));
}

const Reader::Table& Reader::open(const std::string& name) const {
  const hdf5::Turn turn;
  const auto found = tables_.find(name);
  if (found != tables_.end()) return found->second;
  const Link link = find(name);
  if (link == Link::kElsewhere) damaged("'" + name + "' is a link to somewhere else");
  Table table;
  if (link == Link::kHere) {
    table.dataset = hdf5::Handle(h5_.OpenDataset(file_.id(), name.c_str(), hdf5::kDefault), h5_.CloseDataset);
  }
  if (!table.dataset) damaged("it has no '" + name + "'");
  open_type(name, table);
  require_plain_storage(name, table);
  open_shape(name, table);
  return tables_.emplace(name, std::move(table)).first->second;
}

void Reader::open_type(const std::string& name, Table& table) const {
  table.type = hdf5::Handle(h5_.DatasetType(table.dataset.id()), h5_.CloseType);
  const int type_class = table.type ? h5_.TypeClass(table.type.id()) : -1;
  const std::size_t size = table.type ? h5_.TypeSize(table.type.id()) : 0;
  const bool number = type_class == hdf5::kInteger || type_class == hdf5::kFloat;
  if (!number || size == 0 || size > kLargestNumber) damaged("'" + name + "' has no numbers");
}

// In this file, in chunks that can be read at once, made small by what recordings use.
void Reader::require_plain_storage(const std::string& name, const Table& table) const {
  const hdf5::Handle stored(h5_.DatasetProperties(table.dataset.id()), h5_.CloseProperties);
  const int layout = stored ? h5_.Layout(stored.id()) : -1;
  if (layout < hdf5::kCompact || layout > hdf5::kChunked || h5_.ExternalFiles(stored.id()) != 0) {
    damaged("'" + name + "' lies somewhere else");
  }
  const int filters = h5_.FilterCount(stored.id());
  if (filters < 0) damaged("'" + name + "' cannot be read");
  for (unsigned i = 0; i < static_cast<unsigned>(filters); ++i) {
    unsigned flags = 0, how = 0;
    std::size_t values = 0;
    const int filter = h5_.Filter(stored.id(), i, &flags, &values, nullptr, 0, nullptr, &how);
    if (filter < hdf5::kDeflate || filter > hdf5::kFletcher32)
      damaged("'" + name + "' is compressed in an unknown way");
  }
  if (layout != hdf5::kChunked) return;
  std::vector<hdf5::Size> chunk(kMostDimensions);
  const int dimensions = h5_.Chunk(stored.id(), static_cast<int>(chunk.size()), chunk.data());
  if (dimensions < 1 || static_cast<std::size_t>(dimensions) > chunk.size()) damaged("'" + name + "' has no chunks");
  chunk.resize(static_cast<std::size_t>(dimensions));
  const std::size_t size = h5_.TypeSize(table.type.id()), all = product_of(chunk, 0, size);
  const std::size_t row = product_of(chunk, 1, size);  // of which one is a chunk at least
  if (all == 0 || all > std::max<hdf5::Size>(kMostChunkBytes, row))
    damaged("'" + name + "' has chunks that are too large");
}

// What a file says to hold it must be able to hold.
void Reader::open_shape(const std::string& name, Table& table) const {
  const hdf5::Handle space(h5_.DatasetSpace(table.dataset.id()), h5_.CloseSpace);
  const int dimensions = space ? h5_.Dimensions(space.id()) : -1;
  if (dimensions < 1 || static_cast<std::size_t>(dimensions) > kMostDimensions) damaged("'" + name + "' has no rows");
  table.extents.resize(static_cast<std::size_t>(dimensions));
  h5_.Extents(space.id(), table.extents.data(), nullptr);
  table.row_bytes = product_of(table.extents, 1, h5_.TypeSize(table.type.id()));
  const std::uint64_t most = bytes() * kMostInflated;
  const bool fits = table.row_bytes != 0 && table.row_bytes <= most && table.extents[0] <= most / table.row_bytes;
  if (!fits) damaged("'" + name + "' has more, or longer, rows than the file can hold");
}

void Reader::require_table(const std::string& name, hdf5::Id type, std::size_t dimensions) const {
  const hdf5::Turn turn;
  const Table& table = open(name);
  if (h5_.SameType(table.type.id(), type) <= 0) damaged("'" + name + "' has numbers of another type");
  if (table.extents.size() != dimensions) damaged("'" + name + "' has rows of another shape");
}

std::size_t Reader::rows(const std::string& table) const { return static_cast<std::size_t>(open(table).extents[0]); }

std::size_t Reader::row_bytes(const std::string& table) const { return open(table).row_bytes; }

void Reader::read(const std::string& name, std::size_t first, std::size_t count, Span<std::uint8_t> bytes) const {
  const Table& table = open(name);
  if (first > table.extents[0] || count > table.extents[0] - first) {
    damaged("'" + name + "' ends before row " + std::to_string(first + count - 1));
  }
  const std::size_t piece = std::max<std::size_t>(1, kPieceBytes / table.row_bytes);
  for (std::size_t done = 0; done < count; done += piece) {
    const hdf5::Turn turn;
    const hdf5::Size rows = std::min(piece, count - done);
    std::uint8_t* const to = bytes.data() + done * table.row_bytes;
    const auto transfer = [&](hdf5::Id memory, hdf5::Id place) {
      return h5_.Read(table.dataset.id(), table.type.id(), memory, place, hdf5::kDefault, to);
    };
    if (hdf5::with_rows(table.dataset.id(), table.extents, first + done, rows, transfer) < 0) {
      damaged("row " + std::to_string(first + done) + " of '" + name + "' cannot be read");
    }
  }
}

std::vector<std::uint8_t> Reader::row(const std::string& name, std::size_t index) const {
  std::vector<std::uint8_t> bytes(row_bytes(name));
  read(name, index, 1, bytes);
  return bytes;
}

std::string Reader::content(const std::string& name) const {
  require_table(name, h5_.u8, 1);
  std::string bytes(rows(name), '\0');
  read(name, 0, bytes.size(), {reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size()});
  return bytes;
}

}  // namespace mimo::recording
