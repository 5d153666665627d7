// What these tests share: checks, and worlds.
#pragma once

#include <cmath>
#include <cstdio>
#include <mimo/mimo.hpp>
#include <string>

static int failures = 0;

inline void check(bool good, const std::string& what) {
  if (good) return;
  ++failures;
  std::printf("failed: %s\n", what.c_str());
}

inline void check_near(double expected, double value, double tolerance, const std::string& what) {
  check(std::fabs(value - expected) <= tolerance,
        what + " is " + std::to_string(value) + ", expected " + std::to_string(expected));
}

// A model of its own, whose one agent is a body with all below it.
inline mimo::Scene scene_around(const char* xml, const char* root) {
  mimo_scene_config config = mimo::scene_config();
  config.xml = xml;
  mimo::Scene scene(config);
  mimo_agent_config agent = mimo::agent_config();
  agent.root = root;
  agent.body = "scene";
  agent.acts = MIMO_ACT_NONE;
  agent.vision = agent.vestibular = agent.proprioception = 0;
  agent.touch = MIMO_TOUCH_SLIP | MIMO_TOUCH_TEMPERATURE;
  agent.touch_slip_threshold = 0.001;  // slower sliding counts as friction that holds
  scene.add_agent(agent);
  return scene;
}
