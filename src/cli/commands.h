// The commands of the program. Each function adds one to the parser; it runs when the parser has met it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "mimo/mimo.hpp"
#include "motion/retarget.h"
#include "programs/world.h"

namespace CLI {

class App;

}  // namespace CLI

namespace cli {

void add_run(CLI::App& program);
void add_info(CLI::App& program);
void add_render(CLI::App& program);
void add_rollout(CLI::App& program);
void add_export(CLI::App& program);
void add_record(CLI::App& program);
void add_replay(CLI::App& program);
void add_new(CLI::App& program);
void add_bench(CLI::App& program);

// mimo replay --motion: a world follows a movement that is known.

struct FollowOptions {
  WorldOptions world;
  RetargetOptions skeleton;
  std::string motion, forces, joints, errors;  // files; "" for none
  double cutoff = 0;                           // Hz; 0: movements are not filtered
  bool degrees = false, json = false;
};

// Options that only go with --motion, which is the one that is returned.
CLI::Option* add_follow_options(CLI::App& command, FollowOptions& options);

struct RecorderOptions;

// Where the recorder has a file, the movement and what is sensed go there.
void follow(const FollowOptions& options, const RecorderOptions& recorder);

// Ctrl-C, and what batch systems and closing terminals send: the first such signal asks for an early end, which leaves
// time to report and to close files; the second one ends the program at once.

class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested();
  // Ends the program as the signal would have, so that a script that called it ends, too.
  [[noreturn]] static void pass_on();
};

// Sound of two ears as a WAV file of 16 bits.

class Wave {
 public:
  // Of the agent with this prefix of its fields; throws a Failure where it hears nothing.
  Wave(const mimo::Layout& layout, const std::string& prefix);
  // What a step gave.
  void add(const mimo::Block& block);
  // Throws a Failure where that cannot be written. What is louder than `full_scale` Pa is cut.
  void write(const std::string& path, double full_scale) const;
  // The loudest sample, Pa.
  float peak() const { return peak_; }

 private:
  mimo_field left_, right_;
  std::vector<float> samples_;  // left and right in turns
  float peak_ = 0;
};

}  // namespace cli
