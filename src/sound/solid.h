// What a thing is like that is struck.
#pragma once

namespace mimo::sound {

// Of a material.
struct Solid {
  double young = 0;       // Pa
  double poisson = 0;     // ratio
  double efficiency = 0;  // share of a blow's energy that ringing gives to the air; 0: it does not ring
  int timbre = -1;        // row of kTimbreTable; -1: it does not ring
  double roughness = 0;   // height of its texture, m
};

// Of a body at the place where it is struck.
struct Struck {
  Solid solid;
  double inverse_mass = 0;  // of what moves, 1/kg; 0: it stands
  double curvature = 0;     // 1/m; 0: flat
  double radius = 0;        // of a ball of its volume, m
  double length = 0;        // sum of its three sizes, m
};

}  // namespace mimo::sound
