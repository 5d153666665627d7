#include "senses/touch/spacing.h"

namespace mimo::senses::touch {
namespace {

struct Entry {
  std::string_view part;
  double spacing;  // m
};

// Two-point discrimination distances, the same for left and right, as the original sets them (the paper's section
// IV-D).
constexpr Entry kTable[] = {
    {"toes", 0.010},
    {"big_toe", 0.010},
    {"foot", 0.015},
    {"lower_leg", 0.038},
    {"upper_leg", 0.027},
    {"hip", 0.025},
    {"lower_body", 0.025},
    {"upper_body", 0.030},
    {"head", 0.013},
    {"eye", 1.0},
    {"upper_arm", 0.024},
    {"lower_arm", 0.024},
    {"hand", 0.007},
    // Mitten hands.
    {"fingers", 0.002},
    // Hands with five fingers.
    {"lfmetacarpal", 0.007},
    {"ffknuckle", 0.004},
    {"mfknuckle", 0.004},
    {"rfknuckle", 0.004},
    {"lfknuckle", 0.004},
    {"thbase", 0.004},
    {"ffmiddle", 0.004},
    {"mfmiddle", 0.004},
    {"rfmiddle", 0.004},
    {"lfmiddle", 0.004},
    {"thhub", 0.004},
    {"ffdistal", 0.002},
    {"mfdistal", 0.002},
    {"rfdistal", 0.002},
    {"lfdistal", 0.002},
    {"thdistal", 0.002},
};

std::string_view without_side(std::string_view name) {
  for (const std::string_view side : {"left_", "right_"}) {
    if (name.substr(0, side.size()) == side) return name.substr(side.size());
  }
  return name;
}

}  // namespace

double default_spacing(std::string_view body) {
  for (const Entry& entry : kTable) {
    if (entry.part == without_side(body)) return entry.spacing;
  }
  return 0;
}

}  // namespace mimo::senses::touch
