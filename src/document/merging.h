// What MuJoCo wants of a document as a whole, and what documents that are put together need not keep between them.
#pragma once

#include <pugixml.hpp>

namespace mimo::document {

// Actuators that have a state of their own come after those that have none; else the order stays.
void put_stateful_last(pugi::xml_node root);

// Where sizes of user numbers are given, each becomes the largest of those given and of those used.
void fit_user_numbers(pugi::xml_node root);

}  // namespace mimo::document
