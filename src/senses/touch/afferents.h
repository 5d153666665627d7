// The touch afferents of a skin, sensor by sensor: SA1, RA, PC, SA2, and the patch of skin that each sensor stands for.
#pragma once

#include <string>
#include <vector>

#include "base/bytes.h"
#include "body/body.h"
#include "receptors/skin.h"
#include "senses/touch/felt.h"
#include "senses/touch/rattle.h"
#include "senses/touch/skin.h"

namespace mimo::senses::touch {

// What is fixed of each sensor as a patch of skin: its region, how wide it is, what it stands for.

struct Patch {
  receptors::Region region;
  double spacing;    // m; not wider than all skin of its body
  double afferents;  // of all kinds
};

// By the name of a body of an infant; anything unknown is trunk.
receptors::Region region_of(const std::string& name);

// An infant has as many afferents as anybody, at any age, wherever its skin has sensors: each part has a share by its
// area and density at 18 months, which its sensors share equally. Bodies that are no infants have the densities alone.
std::vector<Patch> patches(const mjModel& model, const body::Body& body, const Skin& skin);

// The touch afferents of a skin, sensor by sensor: SA1, RA, PC, SA2. Forces are smoothed first, as contacts of physics
// chatter.

class Afferents {
 public:
  // The rates of each sensor, Hz; two directions of SA2.
  enum Rate : std::size_t { kSa1, kRa, kPc, kSa2Along, kSa2Across };
  static constexpr std::size_t kRates = 5;

  // What slides over the skin rattles there.
  Afferents(const std::vector<Patch>& patches, Rattle& rattle, double slip_threshold, double tick);

  void rest(const Felt& felt);
  void go_on(const Felt& felt);
  // Brings the rates up to date; only who looks at them pays for it. What is felt is that of the last go_on.
  void tell(const Felt& felt, const Things& things);

  // Fills a rate in at out[0], out[every] and so on, where a sensor is not at rest: there it is 0.
  void fill_in(Rate rate, float* out, std::size_t every = 1) const {
    table_.spread(kFirstRate + std::size_t{rate}, out, every);
  }

  const std::vector<int>& restless() const { return table_.sensors(); }
  double force(std::size_t sensor) const { return table_.number(kNormal, sensor); }  // smoothed, N
  // What slides over a sensor, also while it hops.
  Rattle::Slide slide(const Felt& felt, std::size_t sensor) const;

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  enum Column : std::size_t {
    kNormal,  // smoothed forces, N
    kAlong,
    kAcross,
    kDepth,                 // m
    kSpeed,                 // m/s
    kJolts,                 // envelope of PC, Hz
    kStates,                // those above are remembered
    kFeltNormal = kStates,  // forces of this tick, N
    kFeltAlong,
    kFeltAcross,
    kTold,     // the normal force that nerves are told of, N: the smoothed one, but of what slides
    kSpacing,  // m
    kFirstRate,
    kColumns = kFirstRate + kRates
  };

  void add(int sensor);
  void take_in(const Felt& felt);
  void smooth(const Felt& felt);
  void steady(const Felt& felt);
  bool gone(std::size_t place) const;
  void tell(std::size_t place, const Rattle::Slide& slide, const Things& things);

  const std::vector<Patch>& patches_;
  Rattle& rattle_;
  double slip_threshold_, tick_, kept_;
  Restless<kColumns> table_;
};

}  // namespace mimo::senses::touch
