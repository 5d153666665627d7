// The samples that reach the two ears of a head: impacts, and what is played around.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "hearing/heard_impact.h"
#include "sound/queue.h"
#include "sound/sphere.h"

namespace mimo::hearing {

constexpr std::size_t kVoices = 32;  // blows that are heard at once; further ones take the place of the weakest

// Something that plays, in the world.
struct Source {
  const sound::Queue* queue = nullptr;  // null: nothing
  Eigen::Vector3d place{0, 0, 0};
  bool fresh = false;  // it was not there a tick ago
  // At an angle to the axis (of length 1) it is 1 - directivity + directivity x cosine times as strong as along it.
  Eigen::Vector3d axis{0, 0, 0};
  double directivity = 0;
};

class Ears {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // `samples` of a tick, `rate` of them a second; `kept` can be looked at. Of the sources one may be the head's own
  // voice, which bone and air bring to both ears alike.
  Ears(std::size_t samples, double rate, std::size_t kept, std::size_t sources, std::size_t own = kNone);

  // Silence.
  void rest();
  // A blow within the tick that comes next. The head as it is at the end of it.
  void add(const Blow& blow, const Head& head, std::int64_t now);
  // A tick, whose first sample is number `now`. As many sources as were promised.
  void advance(const Head& head, Span<const Source> sources, std::int64_t now);

  // A tick of silence, where nothing else can come.
  bool at_rest(Span<const Source> sources, std::int64_t now) const;
  void pass();

  // The last out.size() samples, up to those that are kept.
  void latest(std::size_t ear, Span<float> out) const;
  // Of the last so many samples.
  bool silent(std::size_t samples) const { return quiet_ >= samples; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  // The way of a source, as it was at the end of the last tick, and the filters' memories.
  struct Path {
    std::array<double, kEars> delay{}, gain{};
    std::array<sound::Filter, kEars> filter{};
  };

  void hear(const Source& source, Path& path, const Ways& ways, std::int64_t now);
  // What comes to one ear at the end of the tick, before the head takes its part: into `one_`.
  struct Arrival {
    double delay, gain;
  };
  void read(const Source& source, Path& path, std::size_t ear, const Arrival& arrival, std::int64_t now);
  void keep();

  std::size_t samples_;
  double rate_;
  std::size_t own_;
  std::vector<Voice> voices_;
  std::vector<Path> paths_;
  std::array<std::vector<float>, kEars> kept_;  // rings
  std::size_t next_ = 0;                        // in the rings
  std::size_t quiet_;                           // so many samples were silent, up to those that are kept
  std::array<std::vector<float>, kEars> out_;   // of the tick
  std::vector<float> one_, other_;              // of a source
};

}  // namespace mimo::hearing
