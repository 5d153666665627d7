// The bytes of a saved world, or of what attached senses remember: a header that says what they are, then sections,
// each with its name, version and length. Within version 1 of the interface sections are only added, and newer
// libraries read all older ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"

namespace mimo::env {

constexpr std::size_t kStateHeaderBytes = 48;

// The state that these bytes begin with; zeros may follow. Throws where they begin with none, or anything else follows.
Span<const std::uint8_t> state_in(Span<const std::uint8_t> bytes);

// Throws where these bytes begin with no state, or with one of another version than states have now.
void check_version(Span<const std::uint8_t> bytes);

// Whether these bytes are a state and nothing else, as far as its header says.
bool is_one_state(Span<const std::uint8_t> bytes);

// Puts the right checksum into a header.
void seal_state(Span<std::uint8_t> state);

// What a state did not hold of what loaded it.
struct LoadReport {
  std::size_t fresh = 0;      // sections that started afresh
  std::size_t ignored = 0;    // sections of the state that this world does not use
  std::string fresh_names;    // with ", " between them
  std::string ignored_names;  // the same
};

class Archive {
 public:
  Archive() = default;
  // `model` tells models apart. Sections with `check` stand behind all others.
  Archive(std::uint64_t model, std::vector<Section> sections);

  std::size_t bytes() const { return bytes_; }
  std::uint64_t model() const { return model_; }
  void save(Span<std::uint8_t> state) const;  // exactly bytes()
  // Throws, with nothing changed, for anything that is no whole and sound state of the same model, agents, tasks and
  // actuations.
  LoadReport load(Span<const std::uint8_t> state);
  // The same in two parts, so that of many worlds all load or none: what can be refused is refused by the first. The
  // state stays where it is until the second part, or until it is taken back.
  LoadReport begin_load(Span<const std::uint8_t> state);
  void finish_load();
  void take_back_load();  // nothing where none has begun

 private:
  // What the state has for a section; null bytes where there is nothing that fits.
  Span<const std::uint8_t> fitting(const Section& section, Span<const std::uint8_t> stored) const;
  bool knows(std::string_view name) const;
  LoadReport match(Span<const std::uint8_t> state);
  void load_sections(bool checked);
  void save_backup();
  void load_backup();

  std::uint64_t model_ = 0;
  std::vector<Section> sections_;
  std::vector<std::uint64_t> sizes_;  // of their bytes
  std::size_t bytes_ = 0;
  std::vector<Span<const std::uint8_t>> found_;  // by section, of the state that is being loaded
  std::vector<std::uint8_t> backup_;             // room to keep what load may have to put back
  bool loading_ = false;                         // one has begun
};

}  // namespace mimo::env
