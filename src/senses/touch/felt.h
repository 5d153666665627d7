// What each sensor of a skin feels of the contacts of one physics step, before any receptor makes anything of it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "engine/contacts.h"
#include "engine/physics.h"
#include "mimo/agent.h"
#include "senses/touch/shape.h"
#include "senses/touch/skin.h"

namespace mimo::senses::touch {

// Which sensors feel a touch, and how much of it each: the surface response.

// Of the header. The distance d runs along the skin, s is the spacing.
enum class Response : std::int32_t {
  kNearest = MIMO_RESPONSE_NEAREST,    // the nearest sensor feels everything
  kLinear = MIMO_RESPONSE_LINEAR,      // 1 - d / 2s
  kGaussian = MIMO_RESPONSE_GAUSSIAN,  // exp(-d^2 / 2 sigma^2) with sigma = 2s/3; nothing beyond 2s
};

struct Share {
  int sensor;
  double weight;
};

class Spread {
 public:
  // The skin outlives the spread.
  Spread(const Skin& skin, Response response);

  // The shares of a touch of a geom at a point (body frame); they add up to 1. Valid until the next call.
  Span<const Share> at(int body, int geom, const Vec3& point);

 private:
  void collect(int anchor, const Vec3& point, double reach);
  void keep_nearest();
  bool weigh(double spacing);

  const Skin& skin_;
  Response response_;
  std::vector<Share> shares_;  // distances, before they become weights
};

// What the things of a model are like to the skin that touches them.

struct Thing {
  double temperature = 24;               // degrees Celsius; things are so large that skin does not change it
  double effusivity = 0;                 // W s^0.5 / (m^2 K)
  bool is_flesh = false;                 // of another infant, or as soft as that
  double wavelength = 0, amplitude = 0;  // of its texture, m
};

// The geoms of a model, and after them its flexes.
struct Things {
  double air = 24;  // degrees Celsius
  std::vector<Thing> all;

  const Thing& operator[](int number) const { return all[static_cast<std::size_t>(number)]; }
};

using ThingsPtr = std::shared_ptr<const Things>;

// A contact as one of its two bodies feels it.

enum class Side { kFirst, kSecond };  // of MuJoCo's pair of geoms

struct Press {
  int body, geom;
  int other;            // the body that touches
  int other_geom;       // -1 for a flex
  int other_thing;      // as things.h counts
  Vec3 point;           // on the body's own surface; world, m
  Vec3 normal;          // from this body to the other; world
  Vec3 force;           // on this body; world, N
  double normal_force;  // N
  double friction;      // coefficient of sliding; 0 where the contact has none
  double friction_use;  // share of the friction cone, 0 (no friction) to 1 (about to slip, or slipping)
};

// Force of a contact in its own frame, on the body of the second geom; none if nothing presses.
using ContactForce = std::array<double, 6>;
std::optional<ContactForce> pressing(const mjModel& model, const mjData& data, int contact);

Press press_on(const mjModel& model, const mjData& data, const engine::Meeting& met, const ContactForce& force,
               Side side);

// How the touching surface slides over the body's at the point: velocity without the part along the normal; world, m/s.
Vec3 slip_velocity(const mjModel& model, const mjData& data, const Press& press);

struct Feeling {
  double normal = 0;                                  // N
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();  // along the sensor's two tangents, N
  double sliding = 0;                                 // m/s, weighted by the normal force: divide by it
  double lift = 0;                                    // m/s, with which friction of what slides may throw it off
  double strongest = 0;                               // normal force of the contact that presses it most, N
  int other = -1;                                     // and the thing that does, as things.h counts
};

// Where something presses: the nearest sensor, and how hard in Pa.
struct Prick {
  int sensor;
  double pressure;
};

class Felt {
 public:
  // What is not wanted, slip and pricks, costs nothing. Slip below the threshold (m/s) is that of friction that holds.
  struct Wanted {
    bool sliding, pricks;
    double slip_threshold;
  };
  Felt(const Skin& skin, Response response, Wanted wanted, const Things& things);

  void take_in(const mjModel& model, const mjData& data);
  // Those that feel anything now, each once.
  const std::vector<int>& sensors() const { return sensors_; }
  const Feeling& of(int sensor) const { return feelings_[static_cast<std::size_t>(sensor)]; }
  const std::vector<Prick>& pricks() const { return pricks_; }

 private:
  void add(const mjModel& model, const mjData& data, const Press& press);

  const Skin& skin_;
  const Things& things_;
  Spread spread_;
  Wanted wanted_;
  std::vector<Feeling> feelings_;
  std::vector<int> sensors_;
  std::vector<Prick> pricks_;
};

}  // namespace mimo::senses::touch
