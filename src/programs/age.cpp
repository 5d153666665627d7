#include "programs/age.h"

#include <algorithm>
#include <vector>

#include "programs/world.h"

namespace cli {
namespace {

// Words for constants, in their order.
const std::vector<std::string> kSexes = {"mean", "female", "male"};
const std::vector<std::string> kGrowths = {"who", "original"};

std::int32_t place_of(const std::string& word, const std::vector<std::string>& words) {
  return static_cast<std::int32_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

bool is_given(const AgeOptions& it) {
  return it.age || it.physiological_age || it.sex != kSexes[0] || it.growth != kGrowths[0] || it.percentile != 0 ||
         it.z_length != 0 || it.z_weight != 0 || it.z_head != 0;
}

}  // namespace

void add_age_options(CLI::App& command, AgeOptions& options) {
  command.add_option("--age", options.age, "Age of the infants in months, 0 to 24. Default: 18")
      ->type_name("MONTHS")
      ->check(number(0, 24));
  command
      .add_option("--physiological-age", options.physiological_age,
                  "Of strength, range of motion and tone. Default: the age")
      ->type_name("MONTHS")
      ->check(number(0, 24));
  command.add_option("--sex", options.sex, "mean, female or male")
      ->type_name("SEX")
      ->check(CLI::IsMember(kSexes).description(""))
      ->capture_default_str();
  command
      .add_option("--percentile", options.percentile,
                  "Of length, weight and head at that age and sex, 1 to 99.865 percent.\nDefault: 50")
      ->type_name("P")
      ->check(number(1, 99.865));
  const auto add_z = [&](const char* name, double& z, const char* what) {
    command.add_option(name, z, std::string(what) + " from the median, in standard deviations, -3 to 3")
        ->type_name("Z")
        ->check(number(-3, 3));
  };
  add_z("--z-length", options.z_length, "How far length is");
  add_z("--z-weight", options.z_weight, "How far weight is");
  add_z("--z-head", options.z_head, "How far the head's circumference is");
  command
      .add_option("--growth", options.growth,
                  "Where sizes come from: who, the WHO's standards of growth, or\noriginal, the rules of MIMo v2")
      ->type_name("NAME")
      ->check(CLI::IsMember(kGrowths).description(""))
      ->capture_default_str();
}

void add_maturity_options(CLI::App& command, AgeOptions& options) {
  options.eyes = options.delays = true;
  const auto add = [&](const char* name, bool& on, const std::string& off, const char* what) {
    command
        .add_option_function<std::string>(
            name, [&on, off](const std::string& word) { on = word != off; }, what)
        ->type_name("WHICH")
        ->check(CLI::IsMember(std::vector<std::string>{"age", off}).description(""));
  };
  add("--eyes", options.eyes, "perfect", "With an age: age, eyes that are as old, or perfect. Default: age");
  add("--delays", options.delays, "none",
      "With an age: age, nerves that are as old, or none, which take\nno time. Default: age");
}

std::optional<mimo_growth> growth_of(const AgeOptions& options) {
  if (!is_given(options)) return std::nullopt;
  mimo_growth growth = mimo::growth();
  growth.age = options.age.value_or(growth.age);
  growth.matures_apart = options.physiological_age.has_value();
  growth.physiological_age = options.physiological_age.value_or(0);
  growth.sex = place_of(options.sex, kSexes);
  growth.model = place_of(options.growth, kGrowths);
  growth.percentile = options.percentile;
  growth.z_length = options.z_length;
  growth.z_weight = options.z_weight;
  growth.z_head = options.z_head;
  if (options.age || options.physiological_age) {
    growth.maturity |= (options.eyes ? MIMO_MATURITY_EYES : 0U) | (options.delays ? MIMO_MATURITY_DELAYS : 0U);
  }
  return growth;
}

}  // namespace cli
