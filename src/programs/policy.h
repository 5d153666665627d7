// A learned policy, as docs/guide/policies.md describes its file: what of the observation it reads, a small network,
// and the actions that it gives.
#pragma once

#include <mimo/mimo.hpp>
#include <string>
#include <vector>

namespace cli {

class Policy {
 public:
  // Throws a Failure for a file that cannot be read or is no policy.
  explicit Policy(const std::string& file);

  // The scene that it was learned in; "" where the file does not say.
  const std::string& scene() const { return scene_; }

  // Finds its fields in a world's layout. Throws a Failure that names what does not fit: another body, other senses or
  // motors, another length of a step.
  void attach(const mimo::Env& env);
  // What it does, given an observation of the world that it is attached to.
  const std::vector<float>& act(const mimo::Block& block);

 private:
  struct Field {
    std::string name;
    std::size_t count;
    mimo_field place{};  // in the world's block
  };
  struct Layer {
    std::size_t rows, columns;
    std::vector<float> weights, bias;  // weights column after column: sums of all rows then grow side by side
    std::vector<float> out;
  };
  struct Bounds {
    float low, high;
  };

  std::string file_, scene_;
  double step_seconds_ = 0;  // 0: any
  float clip_ = 10;
  std::vector<Field> fields_;
  std::vector<std::string> actions_;
  std::vector<float> mean_, deviation_, seen_;
  std::vector<Layer> layers_;
  std::vector<Bounds> bounds_;
  std::vector<float> commands_;
};

}  // namespace cli
