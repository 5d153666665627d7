// A stage: its parts, and pictures of them from many views and in many poses, on several threads.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "base/pool.h"
#include "base/span.h"
#include "rays/painter.h"
#include "stage/parts.h"
#include "stage/poses.h"

namespace mimo::stage {

mimo_stage_view default_view();

class Stage {
 public:
  Stage(const Given& given, std::size_t threads, LogSink log);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Throws for what does not fit, and then stays as it is.
  void update(const Given& given);

  // All views, or none: what is wrong with any of them is told before one is drawn.
  void draw(Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views);

 private:
  class Hand;
  class Pictures;

  void tell_omissions();
  Hand& hand(std::size_t thread);

  std::unique_ptr<const Parts> parts_;
  LogSink log_;
  std::vector<std::string> told_;
  rays::Painter painter_;
  std::unique_ptr<Pool> pool_;                // null: the calling thread does it all
  std::vector<std::unique_ptr<Hand>> hands_;  // one for each thread; null until it draws
};

}  // namespace mimo::stage
