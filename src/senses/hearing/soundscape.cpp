#include "senses/hearing/soundscape.h"

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "engine/contacts.h"
#include "engine/model.h"
#include "engine/physics.h"
#include "sound/air.h"

namespace mimo::senses {
namespace {

using Vec3 = Eigen::Vector3d;

constexpr double kLongest = 3;  // m: what stands still and is longer in all is a floor or a wall, and does not ring

double ball_of(double volume) { return fixed::cbrt(3 * volume / (4 * kPi)); }

Vec3 velocity(const mjModel& model, const mjData& data, int body, const Vec3& point) {
  const Vec3 spin(data.cvel + 6 * body), speed(data.cvel + 6 * body + 3);
  return speed + spin.cross(point - Vec3(data.subtree_com + 3 * model.body_rootid[body]));
}

// What rolls: 1/m; 0 for what has sides.
double roundness(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER: return 1 / size[0];
    case mjGEOM_ELLIPSOID: return 1 / fixed::cbrt(size[0] * size[1] * size[2]);
    default: return 0;
  }
}

using hearing::Blow;
using hearing::Source;

constexpr std::size_t kPairs = 64;      // that are remembered
constexpr std::size_t kMostBlows = 32;  // of a tick
constexpr double kSlowest = 0.02;       // m/s: what creeps and rests is slower
constexpr double kAgain = 0.05;         // s, before the same two bodies sound anew
// A touch that began within the tick is no deeper than it has come; a little more where it turned meanwhile.
constexpr double kDeeper = 1.5;
constexpr double kShortest = 60;     // Hz: what touches longer than a period of this is no click
constexpr std::size_t kScrapes = 4;  // pairs of bodies that slide at once
constexpr std::size_t kRubs = 64;    // pairs that are asked whether they are among these
constexpr double kMouth = 0.25;      // directivity of a mouth: half behind; an estimate
constexpr double kLeast = 6.3e-4;    // Pa at 1 m, 30 dB: weaker blows are none

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

// The two that meet, the smaller number first; what is welded together is one. The same twice where that is all.
std::array<int, 2> bodies_of(const mjModel& model, const engine::Meeting& met) {
  const int one = model.body_weldid[met.bodies[0]], other = model.body_weldid[met.bodies[1]];
  return {std::min(one, other), std::max(one, other)};
}

std::array<sound::Struck, 2> sides_of(const mjModel& model, const Solids& solids, const engine::Meeting& met) {
  return {struck(model, met.geoms[0], solids[static_cast<std::size_t>(met.geoms[0])]),
          struck(model, met.geoms[1], solids[static_cast<std::size_t>(met.geoms[1])])};
}

void direct(Source& source, const mjData& data, int body, const Direction& direction) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(data.xmat + 9 * body);
  source.place = Eigen::Vector3d(data.xpos + 3 * body) + frame * direction.place;
  source.axis = frame * direction.axis;
  source.directivity = direction.directivity;
}

}  // namespace

sound::Struck struck(const mjModel& model, int geom, const sound::Solid& solid) {
  sound::Struck made;
  made.solid = solid;
  made.inverse_mass = model.body_invweight0[2 * model.geom_bodyid[geom]];
  const mjtNum* size = model.geom_size + 3 * geom;
  const double a = size[0], b = size[1], c = size[2];
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      made.curvature = 1 / a;
      made.radius = a;
      made.length = 6 * a;
      break;
    case mjGEOM_CAPSULE:
      made.curvature = 1 / a;
      made.radius = ball_of(kPi * a * a * (2 * b + 4 * a / 3));
      made.length = 6 * a + 2 * b;
      break;
    case mjGEOM_CYLINDER:
      made.curvature = 1 / a;
      made.radius = ball_of(2 * kPi * a * a * b);
      made.length = 4 * a + 2 * b;
      break;
    case mjGEOM_ELLIPSOID:
      made.curvature = 1 / fixed::cbrt(a * b * c);
      made.radius = fixed::cbrt(a * b * c);
      made.length = 2 * (a + b + c);
      break;
    case mjGEOM_BOX:
    case mjGEOM_MESH:  // its size is that of its box
      // What moves meets others with its corners, about as round as it is small; tables and walls with their sides.
      made.curvature = made.inverse_mass > 0 ? 1 / std::max(1e-4, std::min({a, b, c})) : 0;
      made.radius = ball_of(8 * a * b * c);
      made.length = 2 * (a + b + c);
      break;
    default:  // ground
      made.solid.efficiency = 0;
  }
  if (made.inverse_mass <= 0 && made.length > kLongest) made.solid.efficiency = 0;
  return made;
}

double approach(const mjModel& model, const mjData& data, const engine::Meeting& met) {
  const mjContact& contact = data.contact[met.number];
  const Vec3 point(contact.pos), normal(contact.frame);  // from the first geom to the second
  const Vec3 first = velocity(model, data, met.bodies[0], point);
  const Vec3 second = velocity(model, data, met.bodies[1], point);
  return (first - second).dot(normal);
}

sound::Sliding sliding(const mjModel& model, const mjData& data, const engine::Meeting& met) {
  const mjContact& contact = data.contact[met.number];
  const auto [first, second] = met.bodies;
  const Vec3 point(contact.pos), normal(contact.frame);
  const Vec3 slip = velocity(model, data, first, point) - velocity(model, data, second, point);
  sound::Sliding made;
  made.speed = (slip - slip.dot(normal) * normal).norm();
  if (made.speed <= sound::kSlowestScrape) {
    const Vec3 spin = Vec3(data.cvel + 6 * first) - Vec3(data.cvel + 6 * second);
    const double curvature = roundness(model, met.geoms[0]) + roundness(model, met.geoms[1]);
    made.speed = curvature > 0 ? (spin - spin.dot(normal) * normal).norm() / curvature : 0;
    made.rolls = true;
  }
  if (made.speed <= sound::kSlowestScrape) return {};
  made.force = engine::contact_force(model, data, met.number)[0];
  return made;
}

Soundscape::Soundscape(const mjModel& model, SolidsPtr solids, double tick, const PlayOptions& options,
                       std::size_t mouths)
    : Process("sounds"),
      bodies_(model.nbody),
      solids_(std::move(solids)),
      samples_(std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(tick * sound::kNominalRate)))),
      tick_(tick),
      rate_(static_cast<double>(samples_) / tick),
      pairs_(kPairs),
      given_(options.directions),
      rubs_(kRubs),
      made_(samples_),
      blows_(kMostBlows),
      around_(options.sources + mouths + kScrapes) {
  const auto capacity = static_cast<std::size_t>(std::ceil(options.seconds * rate_));
  for (std::size_t i = 0; i < options.sources; ++i) playing_.push_back({-1, false, sound::Queue(capacity)});
  scrapes_.resize(kScrapes, Scrape{-1, -1, false, Eigen::Vector3d::Zero(), {}, made_queue(), {}, 0});
  voices_.reserve(mouths);
  directions_.resize(static_cast<std::size_t>(bodies_), nullptr);
  for (Direction& direction : given_) {
    direction.axis.normalize();
    const int body = engine::find_or_fail(model, engine::Kind::kBody, direction.body);
    directions_[static_cast<std::size_t>(body)] = &direction;
  }
}

// Of what is made as it is heard: a tick, and what reading it ahead takes.
sound::Queue Soundscape::made_queue() const { return sound::Queue(samples_ + sound::kAhead); }

std::size_t Soundscape::add(const Mouth& mouth) {
  const std::size_t number = voices_.size();
  voices_.push_back(
      {mouth, sound::Vocal(mouth.pitch, mouth.formants, rate_, samples_, number), false, false, made_queue()});
  return playing_.size() + number;
}

void Soundscape::play(int body, Span<const float> samples, double rate) {
  require(std::abs(rate - rate_) <= 1e-6 * rate_, "rate is {}, expected {}: the sample rate of ears in this world",
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
  require(found != playing_.end(), "body {} cannot play: {} bodies already do", body, playing_.size());
  const std::size_t room = found->queue.room(now_);
  require(samples.size() <= room, "count is {}, expected up to {} samples: no more can wait to be played",
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
  for (Voice& voice : voices_) {
    *voice.mouth.told = {};
    voice.vocal.rest();
    voice.queue.clear();
    voice.sounds = false;
  }
  for (Scrape& scrape : scrapes_) {
    scrape.first = scrape.second = -1;
    scrape.queue.clear();
  }
}

void Soundscape::go_on(const mjModel& model, const mjData& data) {
  blow_count_ = 0;
  find_blows(model, data);
  find_sources(data);
  find_voices(data);
  find_scrapes();
  now_ += static_cast<std::int64_t>(samples_);
}

void Soundscape::find_blows(const mjModel& model, const mjData& data) {
  rub_count_ = 0;
  for (const engine::Meeting& met : engine::Contacts(model, data)) {
    if (!met.is_of_geoms()) continue;  // a flex is soft, and silent
    const mjContact& contact = data.contact[met.number];
    if (contact.dist >= contact.includemargin || contact.exclude == 1) continue;
    slide(model, data, met);
    const double speed = approach(model, data, met);
    if (speed < kSlowest) continue;
    const double deep = contact.includemargin + engine::overlap_of(model, data, met);
    if (deep > kDeeper * speed * tick_) continue;
    // The tick ends now; it came together so much earlier.
    const double onset =
        static_cast<double>(now_) + static_cast<double>(samples_) - std::min(deep / speed, tick_) * rate_;
    strike(model, data, met, speed, onset);
  }
  scrape();
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

void Soundscape::strike(const mjModel& model, const mjData& data, const engine::Meeting& met, double approach,
                        double onset) {
  const auto [first, second] = bodies_of(model, met);
  if (first == second) return;
  const auto at = static_cast<std::int64_t>(onset);
  Pair* pair = meet(first, second, at);
  if (pair == nullptr) return;
  const auto sides = sides_of(model, *solids_, met);
  const sound::Strike blow = sound::strike(sides[0], sides[1], approach);
  if (blow.mass <= 0) return;
  // Of the clicks the louder one: the two bodies' are opposite.
  const sound::Click clicks[2] = {click_of(blow, sides[0]), click_of(blow, sides[1])};
  const bool of_second = clicks[1].peak() > clicks[0].peak();
  bool sounds = false;
  for (int side = 0; side < 2; ++side) {
    Blow made;
    made.place = Eigen::Vector3d(data.contact[met.number].pos);
    made.onset = onset;
    if ((side == 1) == of_second) made.click = clicks[side];
    made.ringing = ringing_of(blow, sides[side]);
    if (made.click.scale <= 0 && made.ringing.count == 0) continue;
    add_blow(made);
    sounds = true;
  }
  if (sounds) *pair = {first, second, at};
}

void Soundscape::add_blow(const Blow& blow) {
  if (blow_count_ < blows_.size()) blows_[blow_count_++] = blow;
}

void Soundscape::find_sources(const mjData& data) {
  for (std::size_t i = 0; i < playing_.size(); ++i) {
    Playing& one = playing_[i];
    if (one.body >= 0 && one.queue.over(now_)) one.body = -1;
    around_[i] = {};
    around_[i].queue = one.body < 0 ? nullptr : &one.queue;
    if (one.body < 0) continue;
    around_[i].place = Eigen::Vector3d(data.xipos + 3 * one.body);
    around_[i].fresh = one.fresh;
    one.fresh = false;
    const Direction* direction = directions_[static_cast<std::size_t>(one.body)];
    if (direction != nullptr) direct(around_[i], data, one.body, *direction);
  }
}

void Soundscape::slide(const mjModel& model, const mjData& data, const engine::Meeting& met) {
  const sound::Sliding found = sliding(model, data, met);
  if (found.speed <= sound::kSlowestScrape) return;
  const auto [first, second] = bodies_of(model, met);
  if (first == second) return;
  const auto sides = sides_of(model, *solids_, met);
  const sound::ScrapeLevel level = sound::scrape_level(sides[0], sides[1], found);
  Rub* rub = level.pressure > 0 ? rub_of(first, second) : nullptr;
  if (rub == nullptr) return;
  const double power = level.pressure * level.pressure;
  rub->power += power;
  rub->speed += power * found.speed;
  rub->corner += power * level.corner;
  rub->place += power * Eigen::Vector3d(data.contact[met.number].pos);
}

Soundscape::Rub* Soundscape::rub_of(int first, int second) {
  for (std::size_t i = 0; i < rub_count_; ++i) {
    if (rubs_[i].first == first && rubs_[i].second == second) return &rubs_[i];
  }
  if (rub_count_ == rubs_.size()) return nullptr;
  rubs_[rub_count_] = {};
  rubs_[rub_count_].first = first;
  rubs_[rub_count_].second = second;
  return &rubs_[rub_count_++];
}

void Soundscape::scrape() {
  for (std::size_t i = 0; i < rub_count_; ++i) {
    const Rub& rub = rubs_[i];
    const double pressure = std::sqrt(rub.power);
    if (pressure < sound::kFaintestScrape) continue;
    Scrape* scrape = scrape_of(rub.first, rub.second);
    if (scrape == nullptr) continue;
    scrape->level = {pressure, rub.corner / rub.power};
    scrape->speed = rub.speed / rub.power;
    scrape->place = rub.place / rub.power;
  }
}

Soundscape::Scrape* Soundscape::scrape_of(int first, int second) {
  Scrape* free = nullptr;
  for (Scrape& scrape : scrapes_) {
    if (scrape.first == first && scrape.second == second) return &scrape;
    if (scrape.first < 0 && free == nullptr) free = &scrape;
  }
  if (free == nullptr) return nullptr;
  free->first = first;
  free->second = second;
  free->fresh = true;
  free->queue.clear();
  free->level = {};
  free->noise.rest(static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second));
  return free;
}

void Soundscape::find_scrapes() {
  for (std::size_t i = 0; i < scrapes_.size(); ++i) {
    Scrape& scrape = scrapes_[i];
    Source& source = around_[playing_.size() + voices_.size() + i];
    source = {};
    if (scrape.first < 0) continue;
    if (scrape.noise.sound(scrape.level, scrape.speed, rate_, made_)) {
      scrape.queue.add(made_, now_ + sound::kAhead);
    } else if (scrape.queue.over(now_)) {
      scrape.first = scrape.second = -1;
      continue;
    }
    scrape.level = {};
    source.queue = &scrape.queue;
    source.place = scrape.place;
    source.fresh = scrape.fresh;
    scrape.fresh = false;
  }
}

void Soundscape::find_voices(const mjData& data) {
  for (std::size_t i = 0; i < voices_.size(); ++i) {
    Voice& voice = voices_[i];
    Source& source = around_[playing_.size() + i];
    source = {};
    const bool utters = voice.vocal.utter(*voice.mouth.told, made_);
    if (utters) {
      source.fresh = !voice.sounds;
      voice.sounds = true;
      voice.queue.add(made_, now_ + sound::kAhead);
    } else if (voice.sounds && voice.queue.over(now_)) {
      voice.sounds = false;
    }
    if (!voice.sounds) continue;
    source.queue = &voice.queue;
    direct(source, data, voice.mouth.head, {"", voice.mouth.place, voice.mouth.axis, kMouth});
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
  save_made(to);
}

void Soundscape::save_made(ByteWriter& to) const {
  for (const Voice& voice : voices_) {
    const sound::Utterance& told = *voice.mouth.told;
    for (const double number : {told.loudness, told.pitch, told.opening, told.front}) to.put(number);
    to.put(voice.sounds);
    voice.vocal.save(to);
    voice.queue.save(to);
  }
  for (const Scrape& scrape : scrapes_) {
    to.put(scrape.first);
    to.put(scrape.second);
    to.put(scrape.fresh);
    for (int i = 0; i < 3; ++i) to.put(scrape.first < 0 ? 0.0 : scrape.place[i]);
    scrape.noise.save(to);
    scrape.queue.save(to);
  }
}

void Soundscape::load_made(ByteReader& from) {
  for (Voice& voice : voices_) {
    sound::Utterance& told = *voice.mouth.told;
    for (double* number : {&told.loudness, &told.pitch, &told.opening, &told.front}) {
      *number = from.take_finite("what a voice is told");
    }
    const bool sane = told.loudness >= 0 && told.loudness <= 1 && std::abs(told.pitch) <= 0.5 &&
                      std::abs(told.opening - 1) < 0.31 && std::abs(told.front - 1) < 0.31;
    require(sane, "the state holds a voice whose numbers are out of range");
    voice.sounds = from.take_flag();
    voice.vocal.load(from);
    voice.queue.load(from);
  }
  for (Scrape& scrape : scrapes_) {
    scrape.first = from.take<std::int32_t>();
    scrape.second = from.take<std::int32_t>();
    scrape.fresh = from.take_flag();
    for (int i = 0; i < 3; ++i) scrape.place[i] = from.take_finite("the place of a noise");
    scrape.level = {};
    scrape.noise.load(from);
    scrape.queue.load(from);
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
  load_made(from);
  blow_count_ = 0;
}

}  // namespace mimo::senses
