// All that is sensed of one model, laid out in one block: by a world of its own, or of somebody else's simulation.
#pragma once

#include <memory>
#include <vector>

#include "env/layout.h"
#include "env/options.h"
#include "env/timing.h"
#include "senses/sense.h"

namespace mimo::env {

class Observer {
 public:
  // The sense outlives the observer. Throws where a field of that name is there already.
  void add(senses::Sense& sense);
  // A camera that belongs to no agent; the renderer is null where there is none.
  void add_camera(const mjModel& model, const CameraOptions& options, render::Renderer* renderer);

  const Layout& layout() const { return layout_; }

  // Fills every byte of the block; `timing` learns how long each sense took, null: nobody wants to know.
  void observe(const mjModel& model, const mjData& data, std::uint8_t* block, Timing* timing) const;

 private:
  std::vector<senses::Sense*> senses_;
  std::vector<std::unique_ptr<senses::Sense>> cameras_;
  Layout layout_;
};

}  // namespace mimo::env
