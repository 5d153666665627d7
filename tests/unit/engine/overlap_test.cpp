// How deep things are in each other: as far as one of them was moved from where they touch.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/contacts.h"
#include "engine/physics.h"
#include "support/numbers.h"

namespace mimo::test {
namespace {

std::string scene(const std::string& under, const std::string& thing) {
  return R"(
<mujoco>
  <worldbody>
    <geom )" +
         under + R"(/>
    <body name="thing"><joint name="up" type="slide" axis="0 0 1"/><geom )" +
         thing + R"(/></body>
  </worldbody>
</mujoco>)";
}

// The largest of all contacts.
double overlap_at(engine::Physics& physics, double height) {
  physics.data().qpos[0] = height;
  physics.forward();
  double deepest = 0;
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    deepest = std::max(deepest, engine::overlap_of(physics.model(), physics.data(), met));
  }
  return deepest;
}

// Where it just touches: MuJoCo has contacts below, and none above.
double touching(engine::Physics& physics) {
  double low = 0, high = 0.3;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    physics.data().qpos[0] = middle;
    physics.forward();
    (physics.data().ncon > 0 ? low : high) = middle;
  }
  return high;
}

// Flat, on an edge, on a corner, and askew; what lies under them is flat on top.
TEST(Overlap, IsTheDepthOfPenetration) {
  for (const char* under : {R"(type="plane" size="1 1 0.1")", R"(type="box" size="0.5 0.5 0.1" pos="0 0 -0.1")",
                            R"(type="box" size="0.5 0.5 0.1" pos="0 0 -0.1" euler="0 0 30")"}) {
    for (const char* thing :
         {R"(type="sphere" size="0.05")", R"(type="box" size="0.05 0.04 0.03")",
          R"(type="box" size="0.05 0.04 0.03" euler="45 0 0")", R"(type="box" size="0.05 0.05 0.05" euler="35 45 0")",
          R"(type="box" size="0.05 0.04 0.03" euler="20 30 10")",
          R"(type="capsule" size="0.02 0.05" euler="0 60 0")"}) {
      engine::Physics physics(engine::compile(scene(under, thing), {}, {}), {});
      const double touch = touching(physics);
      EXPECT_GT(touch, 0.02);
      for (const double deep : {1e-4, 1e-3, 5e-3}) {
        EXPECT_NEAR(overlap_at(physics, touch - deep), deep, 1e-9) << thing << " in " << under;
      }
    }
  }
}

// A cube that leans by one degree: two of its corners are deeper than the others.
TEST(Overlap, CoversEachCorner) {
  const double half = 0.05, lean = 0.0174532925199433, middle = 0.0485;
  for (const char* under : {R"(type="plane" size="1 1 0.1")", R"(type="box" size="0.5 0.5 0.1" pos="0 0 -0.1")"}) {
    engine::Physics physics(engine::compile(scene(under, R"(type="box" size="0.05 0.05 0.05" euler="1 0 0")"), {}, {}),
                            {});
    physics.data().qpos[0] = middle;
    physics.forward();
    const mjData& data = physics.data();
    int left = 0, right = 0;
    for (const engine::Meeting& met : engine::Contacts(physics.model(), data)) {
      const mjContact& contact = data.contact[met.number];
      ++(contact.pos[1] > 0 ? left : right);
      const double side = contact.pos[1] > 0 ? 1 : -1;  // what leans over goes up there
      const double corner = middle + side * half * std::sin(lean) - half * std::cos(lean);
      EXPECT_NEAR(engine::overlap_of(physics.model(), data, met), -corner, 1e-9) << under << side;
    }
    EXPECT_EQ(left, 2) << under;
    EXPECT_EQ(right, 2) << under;
  }
}

// Both stand on an edge, and their edges cross at right angles.
TEST(Overlap, CoversCrossingEdges) {
  const double deep = 2e-3, edge = 0.05 * std::sqrt(2);
  engine::Physics physics(engine::compile(scene(R"(type="box" size="0.3 0.05 0.05" euler="45 0 0")",
                                                R"(type="box" size="0.05 0.3 0.05" euler="0 45 0")"),
                                          {}, {}),
                          {});
  EXPECT_NEAR(overlap_at(physics, 2 * edge - deep), deep, 1e-9);
}

}  // namespace
}  // namespace mimo::test
