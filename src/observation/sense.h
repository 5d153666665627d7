// A sense declares its fields and fills them. It never writes to the simulation.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "base/header.h"
#include "observation/field.h"

typedef struct mjModel_ mjModel;
typedef struct mjData_ mjData;

namespace mimo::observation {

// What a sense does between observations: receptors that adapt, skin that cools. It goes on with every physics
// step, whether anybody looks or not, so that what is sensed depends on neither.
class Process {
 public:
  // The name is that of its memory in states; the agent's name goes before it. Bytes of another version are none that
  // it can load.
  explicit Process(std::string name, std::uint32_t version = 0) : name_(std::move(name)), version_(version) {}
  virtual ~Process() = default;
  void belong_to(const std::string& prefix) { name_ = prefix + name_; }

  // An episode starts: all has been as it is now for ever.
  void begin(const mjModel& model, const mjData& data);
  // A tick later. Who was never told of a beginning begins here.
  void advance(const mjModel& model, const mjData& data);

  // What it remembers. This object outlives it and stays where it is.
  Section section();

 protected:
  // False from when its memory was lost until the next tick, with which it begins anew.
  bool begun() const { return begun_; }

 private:
  virtual void rest(const mjModel& model, const mjData& data) = 0;
  virtual void go_on(const mjModel& model, const mjData& data) = 0;
  // Always the same number of bytes. A load that throws may leave it half loaded.
  virtual void save(ByteWriter& to) const = 0;
  virtual void load(ByteReader& from) = 0;

  std::string name_;
  std::uint32_t version_;
  bool begun_ = false;
};

// The share of a step's time that a sense counts for.
using header::kShares;
using header::Share;

// Adds the seconds of its own life to a sum; does nothing when switched off.
class Stopwatch {
 public:
  Stopwatch(bool on, double& sum) : sum_(on ? &sum : nullptr) {
    if (sum_ != nullptr) start_ = std::chrono::steady_clock::now();
  }
  ~Stopwatch() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double* sum_;
  std::chrono::steady_clock::time_point start_;
};

class Sense {
 public:
  virtual ~Sense() = default;
  std::vector<Field>& fields() { return fields_; }
  const std::vector<Field>& fields() const { return fields_; }
  bool has(const Field& field) const { return &field >= fields_.data() && &field < fields_.data() + fields_.size(); }
  virtual Share share() const = 0;
  // Fills its fields of the block from the current data, and from what has become of its processes.
  virtual void write(const mjModel& model, const mjData& data, std::uint8_t* block) = 0;

  // Throws what went wrong in it since the last time, where that could not be said at once.
  virtual void complain() {}
  // Whether its processes look at MuJoCo's sensors.
  virtual bool follows_sensors() const { return false; }

  // Its processes between observations.
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

// Senses made of signals: fields of numbers, each with the function that fills it.

struct Signal {
  Field field;  // of float
  // Fills all of the field.
  std::function<void(const mjModel& model, const mjData& data, float* out)> write;
};

class Signals : public Sense {
 public:
  // A signal without any numbers is left out.
  Signals(Share share, std::vector<Signal> signals);
  Share share() const override { return share_; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  Share share_;
  std::vector<decltype(Signal::write)> writers_;  // one per field
};

}  // namespace mimo::observation
