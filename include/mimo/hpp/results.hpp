/**
 * @file mimo/hpp/results.hpp
 * What worlds tell: results of steps, contacts, touch sensors, pictures. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_RESULTS
#define MIMO_HPP_RESULTS

#include <array>
#include <cstdint>
#include <vector>

#include "../mimo.h"

namespace mimo {

/// What a step returns for one agent.
struct Result {
  double reward;
  bool terminated;
  bool truncated;
};

/// The same for all agents, in memory that is made once: Env::make_results.
struct Results {
  std::vector<double> reward;
  std::vector<std::uint8_t> terminated, truncated;
};

}  // namespace mimo

#endif
