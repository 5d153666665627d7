#include "senses/hearing/soundscape.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "senses/hearing/struck.h"
#include "sound/air.h"

namespace mimo::senses {
namespace {

using hearing::Blow;

constexpr std::size_t kPairs = 64;      // that are remembered
constexpr std::size_t kMostBlows = 32;  // of a tick
constexpr double kSlowest = 0.02;       // m/s: what creeps and rests is slower
constexpr double kAgain = 0.05;         // s, before the same two bodies sound anew
// A touch that began within the tick is no deeper than it has come; a little more where it turned meanwhile.
constexpr double kDeeper = 1.5;
constexpr double kShortest = 60;   // Hz: what touches longer than a period of this is no click
constexpr double kLeast = 6.3e-4;  // Pa at 1 m, 30 dB: weaker blows are none

sound::Click click_of(const sound::Strike& blow, const sound::Struck& body) {
  const sound::Click made = sound::click(blow, body.inverse_mass, body.radius, sound::kMeanCosine);
  return made.peak() < kLeast || made.duration * kShortest > 1 ? sound::Click() : made;
}

sound::Ringing ringing_of(const sound::Strike& blow, const sound::Struck& body) {
  sound::Ringing made = sound::ringing(blow, body);
  double loudest = 0;
  for (std::size_t i = 0; i < made.count; ++i) loudest = std::max(loudest, made.modes[i].gain);
  if (loudest < kLeast) made.count = 0;
  return made;
}

}  // namespace

Soundscape::Soundscape(const mjModel& model, SolidsPtr solids, double tick, const PlayOptions& options)
    : Process("sounds"),
      bodies_(model.nbody),
      solids_(std::move(solids)),
      samples_(std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(tick * sound::kNominalRate)))),
      tick_(tick),
      rate_(static_cast<double>(samples_) / tick),
      pairs_(kPairs),
      blows_(kMostBlows),
      around_(options.sources) {
  const auto capacity = static_cast<std::size_t>(std::ceil(options.seconds * rate_));
  for (std::size_t i = 0; i < options.sources; ++i) playing_.push_back({-1, false, sound::Queue(capacity)});
}

void Soundscape::play(int body, Span<const float> samples, double rate) {
  require(std::abs(rate - rate_) <= 1e-6 * rate_, "rate is {}, expected {}: the samples a second that ears get here",
          rate, rate_);
  const auto same = [&](const Playing& one) { return one.body == body; };
  const auto idle = [](const Playing& one) { return one.body < 0; };
  auto found = std::find_if(playing_.begin(), playing_.end(), same);
  if (samples.empty()) {
    if (found != playing_.end()) found->queue.stop(now_);
    return;
  }
  const bool goes_on = found != playing_.end();
  if (!goes_on) found = std::find_if(playing_.begin(), playing_.end(), idle);
  require(found != playing_.end(), "body {} is one too many to play: {} do so at once", body, playing_.size());
  const std::size_t room = found->queue.room(now_);
  require(samples.size() <= room, "count is {}, expected up to {} samples: there is no room for more to wait",
          samples.size(), room);
  if (!goes_on) {
    found->queue.clear();
    found->body = body;
    found->fresh = true;
  }
  found->queue.add(samples, now_);
}

void Soundscape::rest(const mjModel&, const mjData&) {
  now_ = 0;
  std::fill(pairs_.begin(), pairs_.end(), Pair());
  blow_count_ = 0;
  for (Playing& one : playing_) {
    one.body = -1;
    one.queue.clear();
  }
}

void Soundscape::go_on(const mjModel& model, const mjData& data) {
  blow_count_ = 0;
  find_blows(model, data);
  find_sources(data);
  now_ += static_cast<std::int64_t>(samples_);
}

void Soundscape::find_blows(const mjModel& model, const mjData& data) {
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    const double overlap = contact.includemargin - contact.dist;
    if (overlap <= 0 || contact.exclude == 1) continue;
    const double speed = approach(model, data, contact);
    if (speed < kSlowest || overlap > kDeeper * speed * tick_) continue;
    // The tick ends now; it came together so much earlier.
    const double onset =
        static_cast<double>(now_) + static_cast<double>(samples_) - std::min(overlap / speed, tick_) * rate_;
    strike(model, contact, speed, onset);
  }
}

Soundscape::Pair* Soundscape::meet(int first, int second, std::int64_t at) {
  Pair* oldest = &pairs_[0];
  for (Pair& pair : pairs_) {
    if (pair.first == first && pair.second == second) {
      return static_cast<double>(at - pair.last) < kAgain * rate_ ? nullptr : &pair;
    }
    const bool older = pair.first < 0 ? oldest->first >= 0 : oldest->first >= 0 && pair.last < oldest->last;
    if (older) oldest = &pair;
  }
  return oldest;
}

void Soundscape::strike(const mjModel& model, const mjContact& contact, double approach, double onset) {
  const int bodies[2] = {model.body_weldid[model.geom_bodyid[contact.geom1]],
                         model.body_weldid[model.geom_bodyid[contact.geom2]]};
  if (bodies[0] == bodies[1]) return;
  const auto at = static_cast<std::int64_t>(onset);
  Pair* pair = meet(std::min(bodies[0], bodies[1]), std::max(bodies[0], bodies[1]), at);
  if (pair == nullptr) return;
  const sound::Struck sides[2] = {struck(model, contact.geom1, (*solids_)[static_cast<std::size_t>(contact.geom1)]),
                                  struck(model, contact.geom2, (*solids_)[static_cast<std::size_t>(contact.geom2)])};
  const sound::Strike blow = sound::strike(sides[0], sides[1], approach);
  if (blow.mass <= 0) return;
  // Of the clicks the louder one: the two bodies' are opposite.
  const sound::Click clicks[2] = {click_of(blow, sides[0]), click_of(blow, sides[1])};
  const bool second = clicks[1].peak() > clicks[0].peak();
  bool sounds = false;
  for (int side = 0; side < 2; ++side) {
    Blow made;
    made.place = Eigen::Vector3d(contact.pos);
    made.onset = onset;
    if ((side == 1) == second) made.click = clicks[side];
    made.ringing = ringing_of(blow, sides[side]);
    if (made.click.scale <= 0 && made.ringing.count == 0) continue;
    add_blow(made);
    sounds = true;
  }
  if (sounds) *pair = {std::min(bodies[0], bodies[1]), std::max(bodies[0], bodies[1]), at};
}

void Soundscape::add_blow(const Blow& blow) {
  if (blow_count_ < blows_.size()) blows_[blow_count_++] = blow;
}

void Soundscape::find_sources(const mjData& data) {
  for (std::size_t i = 0; i < playing_.size(); ++i) {
    Playing& one = playing_[i];
    if (one.body >= 0 && one.queue.over(now_)) one.body = -1;
    around_[i].queue = one.body < 0 ? nullptr : &one.queue;
    if (one.body < 0) continue;
    around_[i].place = Eigen::Vector3d(data.xipos + 3 * one.body);
    around_[i].fresh = one.fresh;
    one.fresh = false;
  }
}

void Soundscape::save(ByteWriter& to) const {
  to.put(now_);
  for (const Pair& pair : pairs_) {
    to.put(pair.first);
    to.put(pair.second);
    to.put(pair.last);
  }
  for (const Playing& one : playing_) {
    to.put(std::int32_t{one.body});
    to.put(one.fresh);
    one.queue.save(to);
  }
}

void Soundscape::load(ByteReader& from) {
  now_ = from.take<std::int64_t>();
  require(now_ >= 0 && now_ < (std::int64_t{1} << 60), "the state holds the sample {}", now_);
  for (Pair& pair : pairs_) {
    pair.first = from.take<std::int32_t>();
    pair.second = from.take<std::int32_t>();
    pair.last = from.take<std::int64_t>();
  }
  for (Playing& one : playing_) {
    one.body = from.take<std::int32_t>();
    one.fresh = from.take_flag();
    one.queue.load(from);
    require(one.body >= -1 && one.body < bodies_, "the state holds a sound of body {}", one.body);
  }
  blow_count_ = 0;
}

}  // namespace mimo::senses
