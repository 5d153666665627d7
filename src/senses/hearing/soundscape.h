// Everything that sounds: impacts, what slides and rolls, voices of infants, and what a host plays. It is the same
// for everyone who hears.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hearing/ears.h"
#include "observation/sense.h"
#include "senses/hearing/options.h"
#include "sound/impact.h"
#include "sound/queue.h"
#include "sound/scrape.h"
#include "sound/vocal.h"

typedef struct mjModel_ mjModel;
typedef struct mjData_ mjData;

namespace mimo::engine {
struct Meeting;
}

namespace mimo::senses {

// A geom as something that is struck. What can move counts with the mass that MuJoCo feels at its body (translation
// alone: at corners it is too large).
sound::Struck struck(const mjModel& model, int geom, const sound::Solid& solid);

// How fast the two geoms of a contact come nearer, m/s: of the start of the last physics step. Forces of contacts,
// which MuJoCo spreads over tens of milliseconds, would tell nothing of sound.
double approach(const mjModel& model, const mjData& data, const engine::Meeting& met);

// How the two geoms of a contact slide on each other or roll: of the start of the last physics step.
sound::Sliding sliding(const mjModel& model, const mjData& data, const engine::Meeting& met);

// What geoms are made of, by their number.
using Solids = std::vector<sound::Solid>;
using SolidsPtr = std::shared_ptr<const Solids>;

// An infant's mouth and what is in it.
struct Mouth {
  int head = 0;                 // body
  Eigen::Vector3d place, axis;  // in its frame
  double pitch = 0;             // Hz
  std::array<double, sound::kFormants> formants{};
  std::shared_ptr<sound::Utterance> told;  // what it is to say; part of what this remembers
};

class Soundscape : public observation::Process {
 public:
  // `tick` is what passes from one advance to the next, s. The number of samples in it is whole.
  // So many mouths are added before anybody hears.
  Soundscape(const mjModel& model, SolidsPtr solids, double tick, const PlayOptions& options, std::size_t mouths);
  // Returns which of the sources around it is.
  std::size_t add(const Mouth& mouth);

  std::size_t samples() const { return samples_; }  // of a tick
  double rate() const { return rate_; }             // samples a second: 16000 where the tick allows it
  std::size_t sources() const { return around_.size(); }

  // A body plays samples, in Pa at 1 m from it, as soon as what it plays already is over; without any it stops.
  // Throws Status::kInvalidArgument for more than there is room for, for another rate, and where all sources play.
  void play(int body, Span<const float> samples, double rate);

  // Of the last tick, whose first sample has this number.
  std::int64_t first_sample() const { return now_ - static_cast<std::int64_t>(samples_); }
  Span<const hearing::Blow> blows() const { return {blows_.data(), blow_count_}; }
  // As many as there can be; where they are at its end.
  Span<const hearing::Source> around() const { return around_; }

 private:
  // Two bodies that met.
  struct Pair {
    std::int32_t first = -1, second = -1;
    std::int64_t last = 0;  // sample of their last blow
  };
  struct Playing {
    int body = -1;  // -1: nothing
    bool fresh = false;
    sound::Queue queue;
  };
  struct Voice {
    Mouth mouth;
    sound::Vocal vocal;
    bool sounds = false, fresh = false;
    sound::Queue queue;
  };
  // Two bodies that slide or roll on each other.
  struct Scrape {
    std::int32_t first = -1, second = -1;  // -1: nothing
    bool fresh = false;
    Eigen::Vector3d place{0, 0, 0};
    sound::ScrapeNoise noise;
    sound::Queue queue;
    // Of the tick.
    sound::ScrapeLevel level{};
    double speed = 0;
  };
  // All contacts of two bodies that slide in a tick: their powers add up, as their noises have nothing to do with each
  // other.
  struct Rub {
    int first = -1, second = -1;
    double power = 0;                                 // Pa^2
    double speed = 0, corner = 0;                     // times their power
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // times their power
  };

  void rest(const mjModel& model, const mjData& data) override;
  void go_on(const mjModel& model, const mjData& data) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

  void find_blows(const mjModel& model, const mjData& data);
  void slide(const mjModel& model, const mjData& data, const engine::Meeting& met);
  Rub* rub_of(int first, int second);  // null where too many others slide
  // What has come together goes on, or begins.
  void scrape();
  // Of two bodies, or one that is given to them; null where too many others scrape.
  Scrape* scrape_of(int first, int second);
  sound::Queue made_queue() const;
  void find_scrapes();
  void find_voices(const mjData& data);
  void save_made(ByteWriter& to) const;
  void load_made(ByteReader& from);
  // The pair's place in memory, or one that may be given to it; null where they have met too lately.
  Pair* meet(int first, int second, std::int64_t at);
  void strike(const mjModel& model, const mjData& data, const engine::Meeting& met, double approach, double onset);
  void add_blow(const hearing::Blow& blow);
  void find_sources(const mjData& data);

  int bodies_;  // of the model
  SolidsPtr solids_;
  std::size_t samples_;
  double tick_, rate_;
  std::int64_t now_ = 0;  // the next tick's first sample
  std::vector<Pair> pairs_;
  std::vector<Playing> playing_;
  std::vector<const Direction*> directions_;  // by body; null: from its middle to all sides
  std::vector<Direction> given_;
  std::vector<Voice> voices_;
  std::vector<Scrape> scrapes_;
  std::vector<Rub> rubs_;  // of a tick
  std::size_t rub_count_ = 0;
  std::vector<float> made_;  // of a tick
  std::vector<hearing::Blow> blows_;
  std::size_t blow_count_ = 0;
  std::vector<hearing::Source> around_;
};

// Carries it among a world's senses, before those that hear.
class Around : public observation::Sense {
 public:
  explicit Around(std::unique_ptr<Soundscape> soundscape) { keep(std::move(soundscape)); }
  observation::Share share() const override { return observation::Share::kHearing; }
  void write(const mjModel&, const mjData&, std::uint8_t*) override {}
};

}  // namespace mimo::senses
