/**
 * @file mimo/hpp/results.hpp
 * What worlds tell: results of steps, contacts, receptors, pictures. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_RESULTS
#define MIMO_HPP_RESULTS

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "../experimental.h"

namespace mimo {
inline namespace v1_0 {

/// What a step returns for one agent.
struct Result {
  double reward;
  bool terminated;
  bool truncated;
  std::int32_t outcome;  ///< MIMO_OUTCOME_, also where it does not end the episode.
};

/// The same for all agents, in memory that is made once: Env::make_results. Empty ones, Results(), are not written.
struct Results {
  std::vector<double> reward;
  std::vector<std::uint8_t> terminated, truncated;
  std::vector<std::int32_t> outcome;  ///< MIMO_OUTCOME_ constants.
  std::vector<double> terms;          ///< Of all agents' rewards, as Layout::terms names them.

  /// For the C interface. Throws std::invalid_argument where vectors of agents differ in length.
  mimo_env_results raw() {
    const std::size_t agents = reward.size();
    if (terminated.size() != agents || truncated.size() != agents || outcome.size() != agents) {
      throw std::invalid_argument("vectors of the results differ in length");
    }
    mimo_env_results results = {};
    results.struct_size = sizeof results;
    if (agents != 0) {
      results.reward = reward.data();
      results.terminated = terminated.data();
      results.truncated = truncated.data();
      results.outcome = outcome.data();
    }
    results.agent_count = agents;
    results.terms = terms.empty() ? nullptr : terms.data();
    results.term_count = terms.size();
    return results;
  }
};

/// A point or direction.
using Vector = std::array<double, 3>;
static_assert(sizeof(Vector) == 3 * sizeof(double), "vectors stand one after the other in memory");

/// Two geoms that touch. Metres, newtons; world frame where nothing else is said.
struct Contact {
  std::int32_t geoms[2];
  std::int32_t bodies[2];  ///< To which the geoms belong.
  Vector position;
  Vector normal;       ///< From the first geom to the second.
  Vector tangents[2];  ///< With the normal the contact's frame.
  double distance;     ///< Negative: so far they overlap.
  Vector force;        ///< On the second body, in the contact's frame.
  Vector torque;       ///< Likewise, Nm.
};

/// Two geoms that touched in the last step, in worlds whose config says step_contacts = 1. World frame.
struct StepContact {
  std::int32_t geoms[2];
  std::int32_t bodies[2];  ///< To which the geoms belong.
  double start, end;       ///< Seconds since the step began.
  Vector impulse;          ///< On the second body over the whole step, N s.
  Vector peak_force;       ///< On the second body, the largest of the physics steps', N.
  Vector peak_position;    ///< Of the strongest contact then, metres.
};

/// A receptor of the skin. Metres, in the frame of its body.
struct Receptor {
  std::int32_t body;
  std::int32_t geom;
  Vector position;
  Vector normal;  ///< Away from the body.
  Vector tangents[2];
};

/// Angles by which the left and the right eye miss a point because of their range, rad.
using Misses = std::array<double, 2>;

/// The joints that make an agent look at a point, and their angles, rad.
struct Look {
  std::vector<std::int32_t> joints;
  std::vector<double> angles;
  Misses misses;
};

/// What became of one world of a batch.
struct WorldError {
  mimo_status status;   ///< MIMO_OK, or why it did not do what was asked.
  std::string message;  ///< "" for none.
};

/// A pixel of a picture in colour.
struct Rgb {
  std::uint8_t r, g, b;
};
static_assert(sizeof(Rgb) == 3, "a picture is an array of bytes r g b");

/// Row after row, the top one first unless MIMO_PICTURE_BOTTOM_UP says otherwise: that of row y and column x is
/// pixels[y * width + x].
template <typename Pixel>
struct Picture {
  std::uint32_t width, height;
  std::vector<Pixel> pixels;
};

/// One view in colour, as depth in metres, and as ids of geoms, -1 for none: what of it was drawn. The others are empty.
struct Pictures {
  Picture<Rgb> color;
  Picture<float> depth;
  Picture<std::int32_t> segmentation;
};

namespace detail {
inline Vector vector_at(const double *first) { return Vector{{first[0], first[1], first[2]}}; }

/// The i-th of vectors that lie one behind the other.
inline Vector vector_of(const std::vector<double> &values, std::size_t i) { return vector_at(&values[3 * i]); }

/// Two ids that came as numbers.
inline void put_ids(const std::vector<double> &values, std::size_t i, std::int32_t (&ids)[2]) {
  ids[0] = static_cast<std::int32_t>(values[2 * i]);
  ids[1] = static_cast<std::int32_t>(values[2 * i + 1]);
}

/// Makes room for the pixels of a picture that is wanted, and none for another.
template <typename Pixel>
void make_room(Picture<Pixel> &picture, const mimo_picture_config &config, bool wanted) {
  picture.width = wanted ? config.width : 0;
  picture.height = wanted ? config.height : 0;
  picture.pixels.resize(std::size_t(picture.width) * picture.height);
}
}  // namespace detail

}  // namespace v1_0
}  // namespace mimo

#endif
