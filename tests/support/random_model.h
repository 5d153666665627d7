// Small models of shapes and joints of all kinds, for comparing with MuJoCo what takes its place.
#pragma once

#include <string>

#include "base/format.h"
#include "base/random.h"

namespace mimo::test {

inline int pick(Random& random, int count) { return static_cast<int>(random.uniform(0, count)); }

// A shape of any kind, near the origin of its body, with rules of its own as often as not.
inline std::string random_geom(Random& random, const std::string& name) {
  constexpr const char* kTypes[] = {"sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh"};
  const char* type = kTypes[pick(random, 6)];
  std::string text = format("<geom name='{}' type='{}' pos='{} {} {}' euler='{} {} {}' ", name, type,
                            random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                            random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180));
  if (std::string(type) == "mesh") {
    text += "mesh='wedge' ";
  } else {
    text +=
        format("size='{} {} {}' ", random.uniform(0.01, 0.12), random.uniform(0.01, 0.12), random.uniform(0.01, 0.12));
  }
  if (pick(random, 2) == 0) {
    text += format("margin='{}' gap='{}' ", random.uniform(0, 0.05), random.uniform(0, 0.02));
  }
  if (pick(random, 2) == 0) text += format("priority='{}' solmix='{}' ", pick(random, 2), pick(random, 3));
  if (pick(random, 2) == 0) text += format("contype='{}' conaffinity='{}' ", pick(random, 4), pick(random, 4));
  if (pick(random, 3) == 0) text += "solref='-1000 -10' ";
  constexpr int kDimensions[] = {1, 3, 4, 6};
  return text + format("condim='{}' friction='{} {} {}' solimp='{} 0.95 0.01'/>", kDimensions[pick(random, 4)],
                       random.uniform(0, 2), random.uniform(0, 0.1), random.uniform(0, 0.1), random.uniform(0.5, 0.9));
}

inline constexpr int kBodies = 12;

// Chains of three bodies, of one or two shapes each, among shapes of the world.
inline std::string random_bodies(Random& random) {
  std::string text;
  for (int i = 0; i < kBodies; ++i) {
    const bool first = i % 3 == 0;
    text += format("<body name='b{}' pos='{} {} {}'>", i, random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                   random.uniform(-0.3, 0.3));
    const int joint = pick(random, 4);
    if (first && joint < 3) text += "<freejoint/>";
    if (!first && joint < 3) text += "<joint type='ball'/>";
    text += random_geom(random, format("g{}", i));
    if (pick(random, 2) == 0) text += random_geom(random, format("h{}", i));
    if (i % 3 == 2) text += "</body></body></body>";
  }
  return text;
}

// `rules` stand in the model's options.
inline std::string random_model(Random& random, const std::string& rules) {
  std::string text =
      "<mujoco><size nconmax='4000'/><option " + rules +
      "/><asset><mesh name='wedge' vertex='0 0 0  .2 0 0  0 .15 0  0 0 .1  .1 .1 .1'/></asset><worldbody>"
      "<geom type='plane' size='1 1 .1' pos='0 0 -.2' euler='5 0 0'/>" +
      random_geom(random, "w") + random_bodies(random) + "</worldbody><contact>";
  for (int i = 0; i < 4; ++i) {
    text += format("<exclude body1='b{}' body2='b{}'/>", i, 11 - i);
    text += format("<pair geom1='g{}' geom2='g{}' margin='{}' condim='3'/>", 2 * i, (2 * i + 5) % kBodies,
                   random.uniform(0, 0.1));
  }
  return text + "</contact></mujoco>";
}

}  // namespace mimo::test
