// Agents, cameras and requested fields, and what goes together: names, bodies, roots, places, motors.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "access/requested_fields.h"
#include "env/options.h"
#include "scene/scene.h"

namespace mimo::blueprint {

// Agents, and what goes together: their names, bodies, roots, places and motors.

constexpr const char* kUsualBody = "mitten";

// An agent as it is asked for.
struct AgentPlan {
  env::AgentOptions options;
  std::string body = kUsualBody;         // "scene": the document brings it along
  std::optional<document::Place> place;  // nothing: the scene's own
  unsigned acts = 0;                     // scene::Group bits; 0: the scene's own choice
  std::optional<growth::Growth> growth;  // nothing: 18 months
};

// Those that a world is made with.
class Agents {
 public:
  const std::vector<env::AgentOptions>& all() const { return agents_; }

  // Gives the agent's number, and the scene its body.
  std::size_t add(const AgentPlan& plan, scene::Scene& scene);
  // All that the scene names, or a single one; gives their number.
  std::size_t add_all(const AgentPlan& plan, scene::Scene& scene);

  // These throw for a number that is none of an agent.
  // What its proprioception reads: by their names in the model, instead of all joints.
  void read_joint(std::size_t agent, const std::string& joint);
  void limit_sense(std::size_t agent, const std::string& path, const observation::Limits& limits);
  // The limits that senses have by now are of no concern where there is no such field.
  void forgive_limits();
  // The paths to motors: one by its name, a part of the body, "left_arm", or "" for all.
  void limit_motor(std::size_t agent, const std::string& path, const observation::Limits& limits);
  // Its eyes and nerves; nothing: as its growth says.
  void set_maturity(std::size_t agent, const std::optional<env::Maturity>& maturity);
  // Of a part of its body, or of all.
  void set_sensory_delay(std::size_t agent, const std::string& body, double seconds, const scene::Scene& scene);
  void set_sensory_delay(std::size_t agent, double seconds);
  // Infants of a scene where they are as old as that already.
  void be_as_old_as(const std::vector<growth::Growth>& growths);
  // Another age, of its body in the scene.
  void grow(std::size_t agent, const growth::Growth& growth, scene::Scene& scene);
  // How dense its skin is on a body of its own, or everywhere.
  void set_touch(std::size_t agent, const std::string& body, double spacing, const scene::Scene& scene);
  void set_touch(std::size_t agent, double spacing);
  // A sense of the user's own, whose parameters have their names within it.
  void add_sense(std::size_t agent, const env::OwnSense& sense);
  // The parameters of all senses of the user's own.
  std::vector<const env::OwnSense::Parameter*> sense_parameters() const;
  // Null and false where there is no such parameter. Setting throws for a value out of range.
  const double* sense_parameter(const std::string& name) const;
  bool set_sense_parameter(const std::string& name, double value);

 private:
  env::AgentOptions& at(std::size_t agent);
  void require_name(const std::string& name) const;

  std::vector<env::AgentOptions> agents_;
};

// Cameras whose pictures are observed, though they belong to no agent.

// Where a new camera stands, and where it looks.
struct Stand {
  std::string body;  // "": the world; both points are in its frame
  std::array<double, 3> position{};
  std::array<double, 3> look_at{};
};

struct CameraPlan {
  env::CameraOptions options;
  std::optional<Stand> placed;  // nothing: the scene has it already
};

class Cameras {
 public:
  const std::vector<env::CameraOptions>& all() const { return cameras_; }
  // No camera is observed twice, and none for nothing. The scene gets one that it does not have: of the same name, and
  // as wide as the picture where that says.
  void add(const CameraPlan& plan, scene::Scene& scene);

 private:
  std::vector<env::CameraOptions> cameras_;
};

// Fields on request, which the scene's worlds observe beside what agents and cameras give.

class Fields {
 public:
  const std::vector<access::FieldOptions>& all() const { return fields_; }
  // No two of a name, and none of what no field can be.
  void add(const access::FieldOptions& field);
  // Makes the sense that fills them; empty where there are none.
  env::FurtherSense sense() const;

 private:
  std::vector<access::FieldOptions> fields_;
};

}  // namespace mimo::blueprint
