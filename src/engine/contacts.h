// What meets what in the contacts that a physics step found, as all who look at contacts see it.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>

#include "engine/flexes.h"

namespace mimo::engine {

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

}  // namespace mimo::engine
