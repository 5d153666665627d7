// Where the world's points appear in a picture.
#pragma once

#include "render/renderer.h"

namespace mimo::render {

// How far a picture so high is from its camera, in pixels; fovy is in degrees.
double focal_length(double fovy, double height);

// Pixels right and pixels down from the picture's upper left corner, and the depth, m: negative behind the camera.
Eigen::Vector3d project(const View& view, double width, double height, const Eigen::Vector3d& point);

}  // namespace mimo::render
