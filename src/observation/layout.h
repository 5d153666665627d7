// The observation block: fields of all agents, one after the other, each at a multiple of 64 bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "observation/field.h"

namespace mimo::observation {

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

}  // namespace mimo::observation
