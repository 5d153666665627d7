// What a message says of a name that is not there.
#pragma once

#include <string>
#include <vector>

namespace mimo {

// "there are: a, b", and before that which of them may have been meant: a name that begins otherwise ("left_elbow" for
// "robot:left_elbow"), or a letter or two apart.
std::string choice_of(const std::string& wanted, std::vector<std::string> names);

}  // namespace mimo
