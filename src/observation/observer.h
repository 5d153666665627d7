// All that is sensed of one model, laid out in one block: by a world of its own, or of somebody else's simulation.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "observation/layout.h"
#include "observation/sense.h"

namespace mimo::observation {

using PartTimes = std::array<double, kParts>;  // seconds, by Part

class Observer {
 public:
  // Both throw where a field of that name is there already. The sense outlives the observer.
  void add(Sense& sense);
  // One that belongs to nobody else.
  void add(std::unique_ptr<Sense> sense);

  const Layout& layout() const { return layout_; }

  // Fills every byte of the block, and adds what each part took to `times`; null: nobody wants to know.
  void observe(const mjModel& model, const mjData& data, std::uint8_t* block, PartTimes* times) const;
  // Fills the fields of one part only.
  void observe_part(Part part, const mjModel& model, const mjData& data, std::uint8_t* block) const;

 private:
  std::vector<Sense*> senses_;
  std::vector<std::unique_ptr<Sense>> own_;
  Layout layout_;
};

}  // namespace mimo::observation
