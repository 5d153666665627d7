// A sense declares its fields and fills them. It never writes to the simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "observation/field.h"
#include "observation/process.h"

namespace mimo::observation {

// The share of a step's time that a sense counts for.
enum class Share { kTouch, kVision, kProprioception, kVestibular, kHearing, kTask, kRequest };
constexpr std::size_t kShares = 7;

class Sense {
 public:
  virtual ~Sense() = default;
  std::vector<Field>& fields() { return fields_; }
  const std::vector<Field>& fields() const { return fields_; }
  bool has(const Field& field) const { return &field >= fields_.data() && &field < fields_.data() + fields_.size(); }
  virtual Share share() const = 0;
  // Fills its fields of the block from the current data, and from what has become of its processes.
  virtual void write(const mjModel& model, const mjData& data, std::uint8_t* block) = 0;

  // What of it goes on by itself.
  void keep(std::unique_ptr<Process> process) { processes_.push_back(std::move(process)); }
  const std::vector<std::unique_ptr<Process>>& processes() const { return processes_; }

 protected:
  // Where a field starts in the block.
  template <typename T>
  T* at(std::uint8_t* block, std::size_t field) const {
    return reinterpret_cast<T*>(block + fields_[field].offset);
  }

  std::vector<Field> fields_;

 private:
  std::vector<std::unique_ptr<Process>> processes_;
};

}  // namespace mimo::observation
