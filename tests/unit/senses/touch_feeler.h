// A sense of touch on bodies of any model, without an infant.
#pragma once

#include <cstring>
#include <vector>

#include "senses/touch/touch.h"
#include "support/tiny.h"

namespace mimo::senses::touch {

class Feeler {
 public:
  Feeler(const engine::ModelPtr& model, const std::vector<BodySpacing>& bodies, const TouchOptions& options = {})
      : physics(model, {}), sense(std::make_shared<const Skin>(physics.model(), bodies), options) {
    std::size_t offset = 0;
    for (observation::Field& field : sense.fields()) {
      field.offset = offset;
      offset += field.bytes();
    }
    block_.resize(offset);
  }

  // What the sensors feel now, field after field; the memory held rubbish before.
  void feel() {
    std::fill(block_.begin(), block_.end(), std::uint8_t{0xcd});
    sense.write(physics.model(), physics.data(), block_.data());
  }

  const observation::Field& field(const std::string& name) const {
    for (const observation::Field& field : sense.fields()) {
      if (field.name == name) return field;
    }
    throw std::out_of_range("no field " + name);
  }

  // One row of a field, by sensor.
  Eigen::VectorXd row(const std::string& name, std::size_t sensor) const {
    const observation::Field& f = field(name);
    const std::size_t width = f.shape.at(1);
    std::vector<float> values(width);
    std::memcpy(values.data(), block_.data() + f.offset + 4 * width * sensor, 4 * width);
    Eigen::VectorXd row(static_cast<Eigen::Index>(width));
    for (std::size_t i = 0; i < width; ++i) row[static_cast<Eigen::Index>(i)] = static_cast<double>(values[i]);
    return row;
  }

  Eigen::VectorXd sum(const std::string& name, int body) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(field(name).shape.at(1)));
    for (std::size_t i = 0; i < sensors().size(); ++i) {
      if (sensors()[i].body == body) sum += row(name, i);
    }
    return sum;
  }

  const std::vector<Sensor>& sensors() const { return sense.skin().sensors(); }
  Eigen::Matrix3d rotation(int body) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(physics.data().xmat + 9 * body);
  }

  engine::Physics physics;
  Touch sense;

 private:
  std::vector<std::uint8_t> block_;
};

}  // namespace mimo::senses::touch
