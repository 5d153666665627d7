// What is inside a PNG picture, looked at before MuJoCo reads it.
#pragma once

#include "document/loaded_file.h"

namespace mimo::document {

struct PictureSize {
  double width = 0, height = 0;
};

// As its header says, which has to be there.
PictureSize png_size(const LoadedFile& file);

// Refuses a file whose data is longer than its picture, compressed or not: MuJoCo's reader inflates all of it before it
// looks at the size, and a megabyte may become a gigabyte.
void check_png_data(const LoadedFile& file);

}  // namespace mimo::document
