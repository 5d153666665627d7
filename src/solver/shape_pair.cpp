#include "solver/shape_pair.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>

#include "compat/mujoco.h"
#include "solver/apart.h"

#if !MIMO_MUJOCO_4

namespace mimo::solver {
namespace {

// How two shapes touch, where they do.
struct Rules {
  double margin, gap;
  int dimensions;
  std::array<double, 5> friction;
  std::array<double, mjNREF> solref;
  std::array<double, mjNIMP> solimp;
};

double plane_distance(const mjData& data, int plane, int geom) {
  const double* normal = data.geom_xmat + 9 * plane + 2;
  const double *from = data.geom_xpos + 3 * plane, *to = data.geom_xpos + 3 * geom;
  return (to[0] - from[0]) * normal[0] + (to[1] - from[1]) * normal[3] + (to[2] - from[2]) * normal[6];
}

// By the spheres around them; `first` is the plane if there is one.
bool are_far(const mjModel& model, const mjData& data, int first, int second, double margin) {
  const double radius = model.geom_rbound[first], other = model.geom_rbound[second];
  if (radius > 0 && other > 0) {
    return mju_dist3(data.geom_xpos + 3 * first, data.geom_xpos + 3 * second) > radius + other + margin;
  }
  return model.geom_type[first] == mjGEOM_PLANE && other > 0 && plane_distance(data, first, second) > margin + other;
}

void order_by_type(const mjModel& model, int& first, int& second) {
  if (model.geom_type[first] > model.geom_type[second]) std::swap(first, second);
}

// Two boxes may report a point twice.
int drop_repeated(mjContact* contacts, int count) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const double* point = contacts[i].pos;
    const bool again = std::any_of(contacts + i + 1, contacts + count, [&](const mjContact& later) {
      return point[0] == later.pos[0] && point[1] == later.pos[1] && point[2] == later.pos[2];
    });
    if (again) continue;
    if (kept < i) contacts[kept] = contacts[i];
    ++kept;
  }
  return kept;
}

// Completes the axes of a contact: the first is the normal, the second may be a wish.
void complete_frame(double* frame) {
  if (mju_normalize3(frame) < 0.5) mju_error("the normal of a contact is undefined");
  if (mju_norm3(frame + 3) < 0.5) {
    mju_zero3(frame + 3);
    frame[frame[1] < 0.5 && frame[1] > -0.5 ? 4 : 5] = 1;
  }
  double along[3];
  mju_scl3(along, frame, mju_dot3(frame, frame + 3));
  mju_subFrom3(frame + 3, along);
  mju_normalize3(frame + 3);
  mju_cross(frame + 6, frame, frame + 3);
}

// Calls `complete` for the rules of friction and softness only where there are contacts.
template <typename Complete>
void collide_ordered(const mjModel& model, mjData& data, int first, int second, Rules& rules, Complete&& complete) {
  const int type = model.geom_type[first], other_type = model.geom_type[second];
  const mjfCollision find = mjCOLLISIONFUNC[type][other_type];
  if (find == nullptr || are_far(model, data, first, second, rules.margin)) return;
  if (are_apart(model, data, first, second, rules.margin)) return;
  std::array<mjContact, mjMAXCONPAIR> contacts;
  int count = find(&model, &data, contacts.data(), first, second, rules.margin);
  if (count == 0) return;
  if (type == mjGEOM_BOX && other_type == mjGEOM_BOX) count = drop_repeated(contacts.data(), count);
  complete();
  for (double& friction : rules.friction) friction = std::max(mjMINMU, friction);
  for (int i = 0; i < count; ++i) {
    mjContact& contact = contacts[static_cast<std::size_t>(i)];
    contact.dim = rules.dimensions;
    contact.geom1 = first;
    contact.geom2 = second;
    contact.includemargin = rules.margin - rules.gap;
    contact.exclude = contact.dist < contact.includemargin ? 0 : 1;
    std::copy_n(rules.friction.data(), 5, contact.friction);
    std::copy_n(rules.solref.data(), mjNREF, contact.solref);
    std::copy_n(rules.solimp.data(), mjNIMP, contact.solimp);
    complete_frame(contact.frame);
    contact.efc_address = -1;
    contact.mu = 0;
    std::fill(std::begin(contact.H), std::end(contact.H), 0.0);
    if (mj_addContact(&model, &data, &contact) != 0) return;
  }
}

void take_rules_of(const mjModel& model, int geom, Rules& rules) {
  const double* friction = model.geom_friction + 3 * geom;
  rules.friction = {friction[0], friction[0], friction[1], friction[2], friction[2]};
  std::copy_n(model.geom_solref + mjNREF * geom, mjNREF, rules.solref.data());
  std::copy_n(model.geom_solimp + mjNIMP * geom, mjNIMP, rules.solimp.data());
}

double share_of_first(double first, double second) {
  if (first >= mjMINVAL && second >= mjMINVAL) return first / (first + second);
  if (first < mjMINVAL && second < mjMINVAL) return 0.5;
  return first < mjMINVAL ? 0 : 1;
}

void mix_rules(const mjModel& model, int first, int second, Rules& rules) {
  const double *one = model.geom_friction + 3 * first, *other = model.geom_friction + 3 * second;
  const double slide = std::max(one[0], other[0]), roll = std::max(one[2], other[2]);
  rules.friction = {slide, slide, std::max(one[1], other[1]), roll, roll};
  const double share = share_of_first(model.geom_solmix[first], model.geom_solmix[second]);
  const double *ref = model.geom_solref + mjNREF * first, *other_ref = model.geom_solref + mjNREF * second;
  const bool standard = ref[0] > 0 && other_ref[0] > 0;
  for (std::size_t i = 0; i < mjNREF; ++i) {
    rules.solref[i] = standard ? share * ref[i] + (1 - share) * other_ref[i] : std::min(ref[i], other_ref[i]);
  }
  const double *imp = model.geom_solimp + mjNIMP * first, *other_imp = model.geom_solimp + mjNIMP * second;
  for (std::size_t i = 0; i < mjNIMP; ++i) rules.solimp[i] = imp[i] * share + other_imp[i] * (1 - share);
}

}  // namespace

void collide_shapes(const mjModel& model, mjData& data, int geom, int other) {
  const bool match = (model.geom_contype[geom] & model.geom_conaffinity[other]) != 0 ||
                     (model.geom_contype[other] & model.geom_conaffinity[geom]) != 0;
  if (!match) return;
  int first = geom, second = other;
  order_by_type(model, first, second);
  const int priority = model.geom_priority[first], other_priority = model.geom_priority[second];
  const int chief = priority > other_priority ? first : second;
  Rules rules;
  rules.margin = std::max(model.geom_margin[first], model.geom_margin[second]);
  rules.gap = std::max(model.geom_gap[first], model.geom_gap[second]);
  rules.dimensions = priority == other_priority ? std::max(model.geom_condim[first], model.geom_condim[second])
                                                : model.geom_condim[chief];
  collide_ordered(model, data, first, second, rules, [&] {
    if (priority == other_priority) {
      mix_rules(model, first, second, rules);
    } else {
      take_rules_of(model, chief, rules);
    }
  });
}

void collide_pair(const mjModel& model, mjData& data, int pair) {
  int first = model.pair_geom1[pair], second = model.pair_geom2[pair];
  order_by_type(model, first, second);
  Rules rules;
  rules.margin = model.pair_margin[pair];
  rules.gap = model.pair_gap[pair];
  rules.dimensions = model.pair_dim[pair];
  collide_ordered(model, data, first, second, rules, [&] {
    std::copy_n(model.pair_friction + 5 * pair, 5, rules.friction.data());
    std::copy_n(model.pair_solref + mjNREF * pair, mjNREF, rules.solref.data());
    std::copy_n(model.pair_solimp + mjNIMP * pair, mjNIMP, rules.solimp.data());
  });
}

}  // namespace mimo::solver

#endif
