// Cameras that saw key points, by their matrix.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>

#include "motion/markers.h"
#include "programs/files.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

using Json = nlohmann::json;

Eigen::Vector3d vector_in(const Json& given, const char* key) {
  const std::vector<double> numbers = given.at(key);
  if (numbers.size() != 3) throw Failure(std::string(key) + text(" has %zu numbers, expected 3", numbers.size()));
  return {numbers[0], numbers[1], numbers[2]};
}

Camera camera_with(const Eigen::Matrix3d& inner, const Eigen::Vector3d& at, const Eigen::Vector3d& look_at,
                   const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = (look_at - at).normalized(), right = forward.cross(up).normalized();
  if (!right.allFinite() || right.isZero()) {
    throw Failure("look_at lies along up from position, or is position; expected another direction");
  }
  Eigen::Matrix3d turn;
  turn << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  Camera camera;
  camera << inner * turn, -inner * turn * at;
  return camera;
}

Eigen::Matrix3d inner_of(const Json& given) {
  Eigen::Matrix3d inner = Eigen::Matrix3d::Identity();
  if (given.contains("fovy")) {
    const double fovy = given.at("fovy"), width = given.at("width"), height = given.at("height");
    if (!(fovy > 0 && fovy < 180)) throw Failure(text("fovy is %g, expected more than 0 and less than 180", fovy));
    if (!(width >= 1 && height >= 1)) throw Failure(text("width and height are %g and %g", width, height));
    inner(0, 0) = inner(1, 1) = height / 2 / std::tan(fovy / 2 * kDegree);
    inner(0, 2) = width / 2;
    inner(1, 2) = height / 2;
  } else {
    inner(0, 0) = given.at("fx");
    inner(1, 1) = given.at("fy");
    inner(0, 2) = given.at("cx");
    inner(1, 2) = given.at("cy");
    if (!(inner(0, 0) > 0 && inner(1, 1) > 0)) throw Failure(text("fx is %g, expected more than 0", inner(0, 0)));
  }
  return inner;
}

Camera matrix_in(const Json& given) {
  const std::vector<std::vector<double>> rows = given.at("matrix");
  Camera camera;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows.size() != 3 || rows[i].size() != 4) break;
    for (std::size_t k = 0; k < 4; ++k) camera(Eigen::Index(i), Eigen::Index(k)) = rows[i][k];
  }
  if (rows.size() != 3 || rows[0].size() != 4 || rows[1].size() != 4 || rows[2].size() != 4) {
    throw Failure("matrix is no 3 rows of 4 numbers");
  }
  return camera;
}

// With lengths of its third row 1, so that the scale is the distance in front.
Camera checked(const Camera& camera) {
  const Eigen::Matrix3d turn = camera.leftCols<3>();
  const double length = turn.row(2).norm();
  if (!camera.allFinite() || !(length > 0) || !(std::abs((turn / length).determinant()) > 1e-9)) {
    throw Failure("expected three independent rows of finite numbers");
  }
  return camera / length;
}

}  // namespace

Camera camera_from_above(double fx, double fy, double cx, double cy) {
  Eigen::Matrix3d inner;
  inner << fx, 0, cx, 0, fy, cy, 0, 0, 1;
  return camera_with(inner, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY());
}

Camera read_camera(const std::string& path) {
  std::ifstream file = open_to_read(path);
  try {
    const Json given = Json::parse(file);
    if (given.contains("matrix")) return checked(matrix_in(given));
    const Eigen::Vector3d up = given.contains("up") ? vector_in(given, "up") : Eigen::Vector3d::UnitZ();
    return checked(camera_with(inner_of(given), vector_in(given, "position"), vector_in(given, "look_at"), up));
  } catch (const Json::exception& error) {
    throw Failure(path + " is not a camera: " + error.what());
  } catch (const Failure& error) {
    throw Failure(path + " is not a camera: " + error.what());
  }
}

}  // namespace cli
