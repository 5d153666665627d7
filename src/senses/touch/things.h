// What the things of a model are like to the skin that touches them.
#pragma once

#include <memory>
#include <vector>

namespace mimo::senses::touch {

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

}  // namespace mimo::senses::touch
