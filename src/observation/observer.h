// Everything that is sensed of one model, laid out in one block: for a world, or for senses attached to a host's
// simulation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "observation/field.h"
#include "observation/sense.h"

namespace mimo::observation {

// The observation block: fields of all agents, one after the other, each at a multiple of 64 bytes.

class Layout {
 public:
  // Places a field; its offset is set. The sense that owns it must outlive the layout.
  void add(Field& field);

  std::size_t bytes() const { return bytes_; }
  std::size_t size() const { return fields_.size(); }
  const Field& operator[](std::size_t i) const { return *fields_[i]; }
  // Fills the gaps between the fields, so that every byte of a block is written.
  void clear_gaps(std::uint8_t* block) const;

 private:
  std::vector<const Field*> fields_;
  std::size_t bytes_ = 0;
};

// All that is sensed of one model, laid out in one block: by a world of its own, or of somebody else's simulation.

using ShareTimes = std::array<double, kShares>;  // seconds, by Share

class Observer {
 public:
  // Both throw where a field of that name is there already. The sense outlives the observer.
  void add(Sense& sense);
  // A process that no sense owns.
  void add(std::unique_ptr<Sense> sense);

  const Layout& layout() const { return layout_; }

  std::size_t senses() const { return senses_.size(); }
  const Sense& sense(std::size_t i) const { return *senses_[i]; }

  // Fills the fields of one sense, and adds the time to `times`, unless that is null.
  void write(std::size_t sense, const mjModel& model, const mjData& data, std::uint8_t* block, ShareTimes* times) const;
  // An episode starts, and a tick is over, for all processes of senses.
  void begin(const mjModel& model, const mjData& data) const;
  void advance(const mjModel& model, const mjData& data, ShareTimes* times) const;
  // What that remembers, for a state. This object outlives it.
  void list(std::vector<Section>& sections) const;

  // Fills the fields of one share only.
  void observe_share(Share share, const mjModel& model, const mjData& data, std::uint8_t* block) const;

 private:
  std::vector<Sense*> senses_;
  std::vector<std::unique_ptr<Sense>> own_;
  Layout layout_;
};

}  // namespace mimo::observation
