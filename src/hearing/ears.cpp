#include "hearing/ears.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::hearing {
namespace {

bool zero(const std::vector<float>& samples) {
  return std::all_of(samples.begin(), samples.end(), [](float sample) { return sample == 0; });
}

constexpr double kOwnVoice = 7.08;  // 17 dB above its level at 1 m, by air and bone together: an estimate

// Without a filter: what the head takes from the air's way bone brings.
Ways own_ways() {
  Ways ways;
  for (sound::Way& way : ways) way.gain = kOwnVoice;
  return ways;
}

Ways ways_from(const Source& source, const Head& head) {
  Ways ways = ways_to(head, source.place);
  if (source.directivity <= 0) return ways;
  const Eigen::Vector3d to = head.middle - source.place;
  const double distance = to.norm(), cosine = distance > 0 ? source.axis.dot(to) / distance : 1;
  for (sound::Way& way : ways) way.gain *= 1 - source.directivity + source.directivity * cosine;
  return ways;
}

}  // namespace

Ears::Ears(std::size_t samples, double rate, std::size_t kept, std::size_t sources, std::size_t own)
    : samples_(samples), rate_(rate), own_(own), voices_(kVoices), paths_(sources), one_(samples), other_(samples) {
  const std::size_t ticks = (kept + samples - 1) / samples;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    kept_[ear].assign(ticks * samples, 0.0F);
    out_[ear].assign(samples, 0.0F);
  }
  quiet_ = kept_[0].size();
}

void Ears::rest() {
  std::fill(voices_.begin(), voices_.end(), Voice());
  std::fill(paths_.begin(), paths_.end(), Path());
  for (std::vector<float>& ring : kept_) std::fill(ring.begin(), ring.end(), 0.0F);
  next_ = 0;
  quiet_ = kept_[0].size();
}

void Ears::add(const Blow& blow, const Head& head, std::int64_t now) {
  const Voice voice(blow, ways_to(head, blow.place), rate_);
  if (!voice.alive(now)) return;
  const auto free = std::find_if(voices_.begin(), voices_.end(), [now](const Voice& of) { return !of.alive(now); });
  if (free != voices_.end()) {
    *free = voice;
    return;
  }
  const auto value = [now](const Voice& of) { return of.remains(now); };
  const auto weaker = [&](const Voice& a, const Voice& b) { return value(a) < value(b); };
  const auto least = std::min_element(voices_.begin(), voices_.end(), weaker);
  if (value(*least) < value(voice)) *least = voice;
}

void Ears::advance(const Head& head, Span<const Source> sources, std::int64_t now) {
  for (std::vector<float>& out : out_) std::fill(out.begin(), out.end(), 0.0F);
  for (Voice& voice : voices_) {
    if (!voice.alive(now)) continue;
    for (std::size_t ear = 0; ear < kEars; ++ear) voice.add(ear, now, out_[ear]);
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (sources[i].queue != nullptr)
      hear(sources[i], paths_[i], i == own_ ? own_ways() : ways_from(sources[i], head), now);
  }
  keep();
}

void Ears::hear(const Source& source, Path& path, const Ways& ways, std::int64_t now) {
  if (source.fresh) path = Path();
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    const sound::Coefficients filter = sound::coefficients(ways[ear], rate_);
    const double delay = std::max(0.0, ways[ear].delay + filter.late / rate_);
    if (source.fresh) {
      path.delay[ear] = delay;
      path.gain[ear] = ways[ear].gain;
    }
    read(source, path, ear, {delay, ways[ear].gain}, now);
    for (std::size_t i = 0; i < samples_; ++i) out_[ear][i] += path.filter[ear].next(filter, one_[i]);
  }
}

// A delay that changes is two that do not, faded from one to the other.
void Ears::read(const Source& source, Path& path, std::size_t ear, const Arrival& arrival, std::int64_t now) {
  const auto fill = [&](double delay, std::vector<float>& to) {
    std::fill(to.begin(), to.end(), 0.0F);
    source.queue->read(static_cast<double>(now) - delay * rate_, to, static_cast<float>(path.gain[ear]),
                       static_cast<float>(arrival.gain));
  };
  fill(path.delay[ear], one_);
  if (path.delay[ear] != arrival.delay) {
    fill(arrival.delay, other_);
    const float step = 1 / static_cast<float>(samples_);
    for (std::size_t i = 0; i < samples_; ++i) {
      one_[i] += (other_[i] - one_[i]) * step * static_cast<float>(i + 1);
    }
  }
  path.delay[ear] = arrival.delay;
  path.gain[ear] = arrival.gain;
}

void Ears::keep() {
  const bool quiet = zero(out_[0]) && zero(out_[1]);
  const std::size_t size = kept_[0].size();
  if (!quiet || quiet_ < size) {
    for (std::size_t ear = 0; ear < kEars; ++ear) {
      std::copy(out_[ear].begin(), out_[ear].end(), kept_[ear].begin() + static_cast<std::ptrdiff_t>(next_));
    }
  }
  next_ = (next_ + samples_) % size;
  quiet_ = quiet ? std::min(quiet_ + samples_, size) : 0;
}

bool Ears::at_rest(Span<const Source> sources, std::int64_t now) const {
  return silent(kept_[0].size()) &&
         std::none_of(sources.begin(), sources.end(), [](const Source& source) { return source.queue != nullptr; }) &&
         std::none_of(voices_.begin(), voices_.end(), [now](const Voice& voice) { return voice.alive(now); });
}

void Ears::pass() { next_ = (next_ + samples_) % kept_[0].size(); }

void Ears::latest(std::size_t ear, Span<float> out) const {
  const std::vector<float>& ring = kept_[ear];
  std::size_t from = (next_ + ring.size() - out.size() % ring.size()) % ring.size();
  for (float& sample : out) {
    sample = ring[from];
    if (++from == ring.size()) from = 0;
  }
}

void Ears::save(ByteWriter& to) const {
  for (const Voice& voice : voices_) voice.save(to);
  for (const Path& path : paths_) {
    to.put(Span<const double>(path.delay.data(), kEars));
    to.put(Span<const double>(path.gain.data(), kEars));
    for (const sound::Filter& filter : path.filter) filter.save(to);
  }
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    std::size_t from = next_;
    for (std::size_t i = 0; i < kept_[ear].size(); ++i) {  // the oldest first
      to.put(kept_[ear][from]);
      if (++from == kept_[ear].size()) from = 0;
    }
  }
}

void Ears::load(ByteReader& from) {
  for (Voice& voice : voices_) voice.load(from);
  const auto finite = [&](Span<float> values) {
    from.take(values);
    for (const float value : values) require(std::isfinite(value), "the state holds a sound that is not finite");
  };
  for (Path& path : paths_) {
    for (double& delay : path.delay) delay = from.take_finite("the way of a sound");
    for (double& gain : path.gain) gain = from.take_finite("the way of a sound");
    for (sound::Filter& filter : path.filter) filter.load(from);
  }
  for (std::vector<float>& ring : kept_) finite(ring);
  next_ = 0;
  quiet_ = 0;
  const std::size_t size = kept_[0].size();
  while (quiet_ < size && kept_[0][size - 1 - quiet_] == 0 && kept_[1][size - 1 - quiet_] == 0) ++quiet_;
}

}  // namespace mimo::hearing
