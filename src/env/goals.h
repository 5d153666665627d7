// How large tasks' goals are.
#pragma once

namespace mimo::env {

constexpr int kLargestGoal = 1024;  // numbers; reading one takes so much of a thread's stack

}  // namespace mimo::env
