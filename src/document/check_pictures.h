// Textures, height fields and their pictures, checked before MuJoCo reads them.
#pragma once

#include <pugixml.hpp>

#include "document/budget.h"
#include "document/files.h"

namespace mimo::document {

// What is inside a PNG picture, looked at before MuJoCo reads it.

struct PictureSize {
  double width = 0, height = 0;
};

// As its header says, which has to be there.
PictureSize png_size(const LoadedFile& file);

// Refuses a file whose data is longer than its picture, compressed or not: MuJoCo's reader inflates all of it before it
// looks at the size, and a megabyte may become a gigabyte.
void check_png_data(const LoadedFile& file);

// Textures, height fields and the pictures that shadows are made of.

// They throw as check() does.
void check_texture(pugi::xml_node texture, const Limits& limits, Budget& budget);
void check_height_field(pugi::xml_node field, const Limits& limits, Budget& budget);
void check_shadows(pugi::xml_node quality, const Limits& limits);

}  // namespace mimo::document
