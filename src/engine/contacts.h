// Contacts that a physics step found, what a body stands on or is stuck in, and MuJoCo 4's flexes.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <vector>

namespace mimo::engine {

// MuJoCo 4's flexes: things of many bodies that bend, such as cloth and ropes. Older models have none.

int flex_count(const mjModel& model);

// Flexes that move with nothing else than these bodies.
std::vector<int> flexes_on(const mjModel& model, const std::vector<int>& bodies);

// The flexes that are a contact's sides: -1 for geoms.
std::array<int, 2> flexes_of(const mjContact& contact);

// The body of a contact's side that is a flex: the body of the vertex next to the contact, or of the node where nodes
// move the vertices; -1 where the contact names no such thing.
int body_of_flex(const mjModel& model, const mjData& data, const mjContact& contact, std::size_t side);

// Throws Status::kUnsupported for a model with flexes whose contacts press with forces that no contact tells.
void require_told_forces(const mjModel& model);

// What meets what in the contacts that a physics step found, as all who look at contacts see it.

// A contact's two sides: geoms, or flexes (engine/flexes.h).
struct Meeting {
  int number;                 // of the contact
  std::array<int, 2> geoms;   // -1 for a flex
  std::array<int, 2> flexes;  // -1 for a geom
  std::array<int, 2> bodies;  // of a flex that next to the contact; -1 for no thing: a host's data may hold anything

  bool is_of_geoms() const { return geoms[0] >= 0 && geoms[1] >= 0; }
  bool is_known() const { return bodies[0] >= 0 && bodies[1] >= 0; }
};

inline Meeting meeting(const mjModel& model, const mjData& data, int number) {
  const mjContact& contact = data.contact[number];
  Meeting met{number, {contact.geom1, contact.geom2}, flexes_of(contact), {}};
  for (std::size_t side = 0; side < 2; ++side) {
    const int geom = met.geoms[side];
    const bool is_geom = geom >= 0 && geom < model.ngeom;
    met.bodies[side] = is_geom ? model.geom_bodyid[geom] : body_of_flex(model, data, contact, side);
  }
  return met;
}

// All contacts whose sides are known: for (const Meeting& met : Contacts(model, data)).
class Contacts {
 public:
  Contacts(const mjModel& model, const mjData& data) : model_(model), data_(data) {}

  class Iterator {
   public:
    Iterator(const Contacts& all, int number) : all_(all) { look(number); }
    const Meeting& operator*() const { return met_; }
    Iterator& operator++() {
      look(met_.number + 1);
      return *this;
    }
    bool operator!=(const Iterator& other) const { return met_.number != other.met_.number; }

   private:
    void look(int number) {
      for (met_.number = number; met_.number < all_.data_.ncon; ++met_.number) {
        met_ = meeting(all_.model_, all_.data_, met_.number);
        if (met_.is_known()) return;
      }
    }

    const Contacts& all_;
    Meeting met_{};
  };

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, data_.ncon}; }

 private:
  const mjModel& model_;
  const mjData& data_;
};

// What a body stands on, and what it is stuck in.

// Half the extent of a geom along the world's z axis.
double half_height(const mjModel& model, const mjData& data, int geom);

// Geoms of a body that hangs on the world, and of all that hangs on it.
std::vector<int> geoms_of_tree(const mjModel& model, int root);

// Heights at which a vertical line meets geoms that stand still and that can touch one of those given.
std::vector<double> heights_at(const mjModel& model, const mjData& data, const std::vector<int>& geoms, double x,
                               double y);

// How deep the two sides of a contact are in each other there, m, below 0 where they are apart. MuJoCo 2.2 reports half
// of it where a face of a box touches another box, and all of it where edges cross.
double overlap_of(const mjModel& model, const mjData& data, const Meeting& met);

struct Overlap {
  double depth = 0;  // m
  Meeting met{};
  std::size_t own = 0;  // its side
};

// Where a body that hangs on the world, with all that hangs on it, is deepest inside something else; from the contacts
// that the data holds.
Overlap deepest_overlap(const mjModel& model, const mjData& data, int root);

}  // namespace mimo::engine
