// What a document's author may leave open: how much memory the simulation gets, and how near things are drawn.
#pragma once

#include <pugixml.hpp>

namespace mimo::document {

// Room for contacts, constraints and the solver, where there are infants. What the document's author has decided stays
// where it is enough for them.
void size_buffers(pugi::xml_node root, int mittens, int fingers, int objects);

// Nothing nearer than znear * extent is drawn. MuJoCo's own choice, a hundredth of the size of all that there is, would
// hide an infant's hands from its eyes. Where the author has set both, it is so; else they become 5 mm and, for want of
// any other, 100 m.
void keep_hands_in_sight(pugi::xml_node root);

}  // namespace mimo::document
