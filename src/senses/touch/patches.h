// What is fixed of each sensor as a patch of skin: its region, how wide it is, what it stands for.
#pragma once

#include <string>
#include <vector>

#include "body/body.h"
#include "receptors/innervation.h"
#include "senses/touch/skin.h"

namespace mimo::senses::touch {

struct Patch {
  receptors::Region region;
  double spacing;    // m; not wider than all skin of its body
  double afferents;  // of all kinds
};

// By the name of a body of an infant; anything unknown is trunk.
receptors::Region region_of(const std::string& name);

// An infant has as many afferents as anybody, at any age, wherever its skin has sensors: each part has a share by its
// area and density at 18 months, which its sensors share equally. Bodies that are no infants have the densities alone.
std::vector<Patch> patches(const mjModel& model, const body::Body& body, const Skin& skin);

}  // namespace mimo::senses::touch
