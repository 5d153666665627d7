// Fields on request: quantities of elements of the scene, as named access reads them.
#pragma once

#include <vector>

#include "access/access.h"
#include "engine/present.h"
#include "observation/sense.h"

namespace mimo::access {

// A quantity of some elements as a field of the observation.
struct FieldOptions {
  std::string name;
  const Quantity* quantity;
  bool now = false;                   // at the step's end, of what else belongs to the start of its last physics step
  std::vector<std::string> elements;  // their names; none of the world
  std::string relative_to;            // the body in whose frame it is; "": the world's
};

// Throws Status::kInvalidArgument for what no field can be, whatever the model.
void check(const FieldOptions& wanted);

class RequestedFields : public observation::Sense {
 public:
  // Looks everything up; model and world outlive it. The world is null where somebody else's simulation is sensed:
  // throws Status::kUnsupported for what only worlds know, and kNotFound for what the model does not have.
  RequestedFields(const mjModel& model, const env::World* world, const std::vector<FieldOptions>& wanted);

  observation::Share share() const override { return observation::Share::kRequest; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  struct Reader {
    const Quantity* quantity;
    bool now;
    std::vector<std::int32_t> ids;
    int relative_to;  // body, or -1: the world
    std::size_t count;
  };

  Reader reader_of(const mjModel& model, const FieldOptions& wanted) const;
  observation::Field field_of(const mjModel& model, const FieldOptions& wanted, Reader& reader) const;
  void read(const mjModel& model, const mjData& data, const Reader& reader);

  const env::World* world_;
  std::vector<Reader> readers_;  // one per field
  std::vector<double> values_;   // room for those of a field
  engine::Present present_;
};

}  // namespace mimo::access
