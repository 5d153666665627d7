// What sounds around: blows, and what a host plays. It is the same for all who hear.
#pragma once

#include <memory>
#include <vector>

#include "hearing/ears.h"
#include "observation/process.h"
#include "observation/sense.h"
#include "senses/hearing/options.h"
#include "sound/queue.h"

typedef struct mjContact_ mjContact;

namespace mimo::senses {

// What geoms are made of, by their number.
using Solids = std::vector<sound::Solid>;
using SolidsPtr = std::shared_ptr<const Solids>;

class Soundscape : public observation::Process {
 public:
  // `tick` is what passes from one advance to the next, s. The number of samples in it is whole.
  Soundscape(const mjModel& model, SolidsPtr solids, double tick, const PlayOptions& options);

  std::size_t samples() const { return samples_; }  // of a tick
  double rate() const { return rate_; }             // samples a second: 16000 where the tick allows it
  std::size_t sources() const { return playing_.size(); }

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

  void rest(const mjModel& model, const mjData& data) override;
  void go_on(const mjModel& model, const mjData& data) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

  void find_blows(const mjModel& model, const mjData& data);
  // The pair's place in memory, or one that may be given to it; null where they have met too lately.
  Pair* meet(int first, int second, std::int64_t at);
  void strike(const mjModel& model, const mjContact& contact, double approach, double onset);
  void add_blow(const hearing::Blow& blow);
  void find_sources(const mjData& data);

  int bodies_;  // of the model
  SolidsPtr solids_;
  std::size_t samples_;
  double tick_, rate_;
  std::int64_t now_ = 0;  // the next tick's first sample
  std::vector<Pair> pairs_;
  std::vector<Playing> playing_;
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
