#include "growth/range.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "base/angle.h"
#include "growth/parts.h"

namespace mimo::growth {
namespace {

enum Side : int { kLower = 0, kUpper = 1 };

struct Mark {
  double age;    // months
  double angle;  // degrees
};

// A limit that is another one in young infants, and the base's from an age on. Straight lines between the marks.
struct Limit {
  std::string_view joint;
  std::array<Mark, 4> marks;  // the first so many
  std::size_t count;
  double grown_out;  // months
  Side side;
  bool from_base;         // angles are to be added to the base's limit
  bool moves_the_spring;  // as far as the limit
};

// Knees: Broughton, Wright and Menelaus 1993, n = 57 (verified). Hips: Haas et al. 1973 for newborns (single copy) and
// Coon et al. 1975 at 6 weeks and 3 months (verified). Elbows: Shah et al. 2017 for newborns (verified), then
// estimated. Ankles of newborns: Waugh et al. 1983 (that the foot bends further up and less down is verified; how far,
// estimated).
constexpr Limit kLimits[] = {
    {"knee", {{{0, -21.4}, {3, -10.7}, {6, -3.3}}}, 3, 12, kUpper, false, true},
    {"hip1", {{{0, -30}, {1.4, -19}, {3, -7}, {9, 0}}}, 4, 12, kUpper, false, true},
    {"elbow", {{{0, -19}, {3, -7}}}, 2, 9, kUpper, false, true},
    {"foot1", {{{0, 30}}}, 1, 12, kUpper, true, false},
    {"foot1", {{{0, -25}}}, 1, 12, kLower, false, false},
};

double between(const Mark& a, const Mark& b, double age) {
  return a.angle + (b.angle - a.angle) * (age - a.age) / (b.age - a.age);
}

// In degrees, at an age before it is grown out.
double limit_at(const Limit& limit, double base, double age) {
  std::vector<Mark> marks(limit.marks.begin(), limit.marks.begin() + limit.count);
  for (Mark& mark : marks) mark.angle += limit.from_base ? base : 0;
  marks.push_back({limit.grown_out, base});
  const auto next = std::find_if(marks.begin() + 1, marks.end(), [&](const Mark& mark) { return age < mark.age; });
  return between(next[-1], next[0], age);
}

void apply(const Limit& limit, const Growth& growth, Joint& joint) {
  if (growth.physiological_age >= limit.grown_out) return;
  double& end = joint.range[limit.side];
  const double young = limit_at(limit, end / kDegree, growth.physiological_age) * kDegree;
  const double shift = growth.contracture * (young - end);
  end += shift;
  if (limit.moves_the_spring) joint.springref = std::max(joint.springref + shift, joint.range[kLower]);
}

}  // namespace

void limit(Skeleton& body, const Growth& growth) {
  for (Bone& bone : body.bones) {
    for (Joint& joint : bone.joints) {
      for (const Limit& limit : kLimits) {
        if (plain_name(joint.name) == limit.joint) apply(limit, growth, joint);
      }
    }
  }
}

}  // namespace mimo::growth
