// How far the polar region of a spindle's fibre gives way within a tick.
//
// Its damping is that of Mileusnic et al.: a force beta (P - R) |v|^0.3 against its speed v, in parallel with springs
// of stiffness k. Where the springs alone would move it by p, it moves by m in a tick T, by an implicit step of
// Euler's:
//
//     m + c m^0.3 = p,  c = beta (P - R) / (k T^0.3)
//
// With m = c^(10/7) u this is u + u^0.3 = w, w = p c^(-10/7), for all fibres: m / p is a function of w alone.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::receptors {

class Creep {
 public:
  // T in seconds, k in force / L0. Makes tables, which takes a while.
  Creep(double tick, double stiffness);

  // What `moved` takes of beta: (k T^0.3 / beta)^(10/7). Costly.
  double ease(double damping) const;
  // m for p = `way` and P - R = `lever`, both in L0.
  double moved(double way, double lever, double ease) const;

 private:
  static constexpr std::size_t kSteps = 1024;
  using Table = std::array<double, kSteps + 1>;

  double force_;    // k T^0.3
  Table shares_{};  // m / p, at w / (1 + w) = 0 to 1
  Table powers_{};  // x^(10/7), at x = 0 to 1
};

}  // namespace mimo::receptors
