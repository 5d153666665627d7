// What of a sense goes on by itself between looks: receptors that adapt, skin that cools. It goes on with every physics
// step, whether anybody looks or not, so that what is sensed depends on neither.
#pragma once

#include <string>
#include <utility>

#include "base/section.h"

typedef struct mjModel_ mjModel;
typedef struct mjData_ mjData;

namespace mimo::observation {

class Process {
 public:
  // The name is that of its memory in states; the agent's name goes before it.
  explicit Process(std::string name) : name_(std::move(name)) {}
  virtual ~Process() = default;
  void belong_to(const std::string& prefix) { name_ = prefix + name_; }

  // An episode starts: all has been as it is now for ever.
  void begin(const mjModel& model, const mjData& data);
  // A tick later. Who was never told of a beginning begins here.
  void advance(const mjModel& model, const mjData& data);

  // What it remembers. This object outlives it and stays where it is.
  Section section();

 private:
  virtual void rest(const mjModel& model, const mjData& data) = 0;
  virtual void go_on(const mjModel& model, const mjData& data) = 0;
  // Always the same number of bytes. A load that throws may leave it half loaded.
  virtual void save(ByteWriter& to) const = 0;
  virtual void load(ByteReader& from) = 0;

  std::string name_;
  bool begun_ = false;
};

}  // namespace mimo::observation
