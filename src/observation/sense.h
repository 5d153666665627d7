// A sense declares its fields and fills them. It never writes to the simulation.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "engine/physics.h"

namespace mimo::senses {

enum class Type : int { kU8 = 1, kI32 = 2, kF32 = 3, kF64 = 4 };
enum class Time : int { kEnd = 1, kLastStart = 2 };

std::size_t size_of(Type type);

struct Field {
  std::string name;  // path, "proprioception/position"
  Type type = Type::kF32;
  std::vector<std::size_t> shape;  // 1 to 4 entries
  std::string unit;
  std::string frame;
  Time time = Time::kLastStart;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::vector<std::string> labels;  // one per element of the flattened field; empty for pictures
  double pixels_per_degree = 0;     // in the middle of a picture; 0 for all else
  std::size_t offset = 0;           // in the block; set by the layout

  std::size_t count() const;
  std::size_t bytes() const { return count() * size_of(type); }
  // What element i of the flattened field is; "" where there are no labels.
  const char* label(std::size_t i) const;
};

// Which entry of a step's timing a sense counts for.
enum class Part { kTouch, kVision, kProprioception, kVestibular, kTask };

class Sense {
 public:
  virtual ~Sense() = default;
  std::vector<Field>& fields() { return fields_; }
  const std::vector<Field>& fields() const { return fields_; }
  virtual Part part() const = 0;
  // Fills its fields of the block from the current data.
  virtual void write(const mjModel& model, const mjData& data, std::uint8_t* block) = 0;

  // What it remembers from one step to the next: always the same number of bytes. A load that throws may leave it
  // half loaded; the world then loads what was there before.
  virtual void save(ByteWriter&) const {}
  virtual void load(ByteReader&) {}

 protected:
  // Where a field starts in the block.
  template <typename T>
  T* at(std::uint8_t* block, std::size_t field) const {
    return reinterpret_cast<T*>(block + fields_[field].offset);
  }

  std::vector<Field> fields_;
};

}  // namespace mimo::senses
