// How a camera maps what it sees onto a picture.
#pragma once

namespace mimo {

// A pinhole before a sensor of so many pixels: what lies x to the right, y up and z ahead shows focal_x x / z pixels to
// the right of the centre and focal_y y / z pixels above it. Of an orthographic camera, which has no pinhole, that is
// focal_x x and focal_y y.
struct Pinhole {
  double focal_x = 0, focal_y = 0;    // pixels, or pixels a metre; 0: there is no camera
  double center_x = 0, center_y = 0;  // where the camera's axis meets the picture: pixels from its upper left corner
  bool parallel = false;              // it is orthographic
};

}  // namespace mimo
