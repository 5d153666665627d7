#include "env/state.h"

#include <algorithm>
#include <cstring>

#include "base/bytes.h"
#include "base/fail.h"

namespace mimo::env {
namespace {

constexpr std::uint64_t kMagic = 0x54415453'4f4d494d;  // "MIMOSTAT" where bytes lie as on x86-64
constexpr std::uint64_t kVersion = 2;                  // of the header and of what follows it; 1 was before 1.0
constexpr std::size_t kChecksumAt = kStateHeaderBytes - sizeof(std::uint64_t);
constexpr std::uint32_t kEssential = 1;

// Of everything but itself.
std::uint64_t checksum(Span<const std::uint8_t> state) {
  Hash hash;
  hash.add(state.part(0, kChecksumAt));
  hash.add(state.part(kStateHeaderBytes, state.size() - kStateHeaderBytes));
  return hash.value();
}

struct Header {
  std::uint64_t bytes, model, sections, checksum;
};

// A newer header may differ from ours in everything but these two numbers.
ByteReader after_version(Span<const std::uint8_t> state) {
  if (state.size() < kStateHeaderBytes) fail(Status::kFile, "state: {} bytes are too few for a state", state.size());
  ByteReader from(state);
  if (from.take<std::uint64_t>() != kMagic) fail(Status::kFile, "state: these bytes are not a state of a world");
  const auto version = from.take<std::uint64_t>();
  if (version > kVersion) {
    fail(Status::kUnsupported, "state: its version {} needs a newer library, this one reads up to {}", version,
         kVersion);
  }
  if (version != kVersion) fail(Status::kFile, "state: its version is {}, expected {}", version, kVersion);
  return from;
}

Header read_header(Span<const std::uint8_t> state) {
  ByteReader from = after_version(state);
  Header header{};
  header.bytes = from.take<std::uint64_t>();
  header.model = from.take<std::uint64_t>();
  header.sections = from.take<std::uint64_t>();
  header.checksum = from.take<std::uint64_t>();
  return header;
}

// A section as it lies in a state.
struct Stored {
  std::string_view name;
  std::uint32_t version = 0;
  std::uint32_t flags = 0;
  std::uint64_t kind = 0;
  Span<const std::uint8_t> bytes;
};

Stored read_section(ByteReader& from) {
  Stored section;
  const auto name_bytes = from.take<std::uint32_t>();
  section.version = from.take<std::uint32_t>();
  section.flags = from.take<std::uint32_t>();
  section.kind = from.take<std::uint64_t>();
  const auto bytes = from.take<std::uint64_t>();
  const Span<const std::uint8_t> name = from.skip(name_bytes);
  section.name = {reinterpret_cast<const char*>(name.data()), name.size()};
  section.bytes = from.skip(bytes);
  return section;
}

void write_section(const Section& section, std::uint64_t bytes, ByteWriter& to) {
  to.put(static_cast<std::uint32_t>(section.name.size()));
  to.put(section.version);
  to.put(section.essential ? kEssential : std::uint32_t{0});
  to.put(section.kind);
  to.put(bytes);
  to.put(Span<const char>(section.name.data(), section.name.size()));
  section.save(to);
}

std::uint64_t size_of(const Section& section) {
  ByteWriter counter;
  section.save(counter);
  return counter.size();
}

// Everything behind the header, which is whole.
Span<const std::uint8_t> open_state(std::uint64_t model, Span<const std::uint8_t> state) {
  const Header header = read_header(state);
  const bool as_long = state.size() == header.bytes, sound = as_long && header.checksum == checksum(state);
  if (header.model != model && (sound || !as_long)) {  // else that number itself may be damaged
    fail(Status::kMismatch, "state: it was saved from another model, or from infants of another age");
  }
  require(as_long, "state: it has {} bytes, expected {}", state.size(), header.bytes);
  require(sound, "state: it is damaged, its checksum is wrong");
  const Span<const std::uint8_t> body = state.part(kStateHeaderBytes, state.size() - kStateHeaderBytes);
  ByteReader from(body);
  for (std::uint64_t i = 0; i < header.sections; ++i) read_section(from);
  require(from.left() == 0, "state: {} bytes are left after its last section", from.left());
  return body;
}

void note(std::string_view name, std::size_t& count, std::string& names) {
  if (count++ > 0) names += ", ";
  names += name;
}

template <typename Visit>
void for_each_section(Span<const std::uint8_t> body, Visit&& visit) {
  for (ByteReader from(body); from.left() > 0;) visit(read_section(from));
}

}  // namespace

Span<const std::uint8_t> state_in(Span<const std::uint8_t> bytes) {
  const auto length = static_cast<std::size_t>(std::min<std::uint64_t>(read_header(bytes).bytes, bytes.size()));
  const bool alone = std::all_of(bytes.begin() + length, bytes.end(), [](std::uint8_t byte) { return byte == 0; });
  if (!alone) fail(Status::kFile, "state: it has {} bytes, and those that follow are not zero", length);
  return bytes.part(0, length);
}

void check_version(Span<const std::uint8_t> bytes) { after_version(bytes); }

bool is_one_state(Span<const std::uint8_t> bytes) {
  if (bytes.size() < kStateHeaderBytes) return false;
  ByteReader from(bytes);
  if (from.take<std::uint64_t>() != kMagic) return false;
  from.take<std::uint64_t>();  // its version, for the section's own check
  return from.take<std::uint64_t>() == bytes.size();
}

void seal_state(Span<std::uint8_t> state) {
  const std::uint64_t sum = checksum({state.data(), state.size()});
  std::memcpy(state.data() + kChecksumAt, &sum, sizeof sum);
}

Archive::Archive(std::uint64_t model, std::vector<Section> sections) : model_(model), sections_(std::move(sections)) {
  ByteWriter counter, undone;
  for (const Section& section : sections_) {
    sizes_.push_back(size_of(section));
    write_section(section, sizes_.back(), counter);
    if (!section.check) section.save(undone);
  }
  bytes_ = kStateHeaderBytes + counter.size();
  backup_.resize(undone.size());
  found_.resize(sections_.size());
}

void Archive::save(Span<std::uint8_t> state) const {
  ByteWriter to(state);
  to.put(kMagic);
  to.put(kVersion);
  to.put(std::uint64_t{bytes_});
  to.put(model_);
  to.put(std::uint64_t{sections_.size()});
  to.put(std::uint64_t{0});  // the checksum's place
  for (std::size_t i = 0; i < sections_.size(); ++i) write_section(sections_[i], sizes_[i], to);
  seal_state(state);
}

bool Archive::knows(std::string_view name) const {
  return std::any_of(sections_.begin(), sections_.end(), [&](const Section& own) { return own.name == name; });
}

Span<const std::uint8_t> Archive::fitting(const Section& section, Span<const std::uint8_t> stored) const {
  Stored match;
  for_each_section(stored, [&](const Stored& candidate) {
    if (candidate.name == section.name) match = candidate;
  });
  const bool there = match.name.data() != nullptr;
  if (there && match.version <= section.version && match.kind == section.kind) return match.bytes;
  if (!section.essential) return {};
  if (there && match.version > section.version) {
    fail(Status::kUnsupported, "state: version {} of its section \"{}\" needs a newer library, this one reads up to {}",
         match.version, section.name, section.version);
  }
  fail(Status::kMismatch, "state: it was saved from a world with another task, actuation or other agents: {} \"{}\"",
       there ? "another kind of" : "it has no section", section.name);
}

LoadReport Archive::load(Span<const std::uint8_t> state) {
  LoadReport report = begin_load(state);
  finish_load();
  return report;
}

// Only the sections without a check can refuse their bytes while they load them: they come first, and go back.
LoadReport Archive::begin_load(Span<const std::uint8_t> state) {
  try {
    LoadReport report = match(state);
    save_backup();
    loading_ = true;
    load_sections(false);
    return report;
  } catch (const Error& error) {
    take_back_load();
    // What its parts refuse is no argument of anybody's.
    if (error.status() != Status::kInvalidArgument) throw;
    throw Error(Status::kFile, error.message());
  } catch (...) {
    take_back_load();
    throw;
  }
}

void Archive::finish_load() {
  try {
    load_sections(true);
  } catch (...) {
    take_back_load();
    throw;
  }
  loading_ = false;
}

void Archive::take_back_load() {
  if (loading_) load_backup();
  loading_ = false;
}

// Finds all sections in a sound state, and checks those that can be checked.
LoadReport Archive::match(Span<const std::uint8_t> state) {
  const Span<const std::uint8_t> stored = open_state(model_, state);
  LoadReport report;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    found_[i] = fitting(sections_[i], stored);
    if (found_[i].data() == nullptr) note(sections_[i].name, report.fresh, report.fresh_names);
  }
  for_each_section(stored, [&](const Stored& section) {
    if (knows(section.name)) return;
    if ((section.flags & kEssential) != 0) {
      fail(Status::kMismatch,
           "state: it was saved from a world with another task, actuation or other agents: its section \"{}\" has no "
           "use here",
           section.name);
    }
    note(section.name, report.ignored, report.ignored_names);
  });
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    if (!sections_[i].check) continue;
    ByteReader from(found_[i]);
    sections_[i].check(from);
    require(from.left() == 0, "state: its section \"{}\" is {} bytes too long", sections_[i].name, from.left());
  }
  return report;
}

void Archive::load_sections(bool checked) {
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    if ((sections_[i].check != nullptr) != checked) continue;
    if (found_[i].data() == nullptr) {
      sections_[i].forget();
      continue;
    }
    ByteReader from(found_[i]);
    sections_[i].load(from);
    require(from.left() == 0, "state: its section \"{}\" is {} bytes too long", sections_[i].name, from.left());
  }
}

void Archive::save_backup() {
  ByteWriter to{Span<std::uint8_t>(backup_)};
  for (const Section& section : sections_) {
    if (!section.check) section.save(to);
  }
}

void Archive::load_backup() {
  ByteReader from{Span<const std::uint8_t>(backup_)};
  for (const Section& section : sections_) {
    if (!section.check) section.load(from);
  }
}

}  // namespace mimo::env
