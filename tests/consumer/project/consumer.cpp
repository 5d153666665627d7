// The same in C++ 11: the headers below mimo.hpp are installed, too.
#include <mimo/mimo.hpp>

int main() try {
  mimo::Env env = mimo::make("reach");
  mimo::Block block = env.make_block();
  env.step({}, block);
  return env.time() > 0.0099 && env.time() < 0.0101 ? 0 : 1;
} catch (const mimo::Exception&) {
  return 1;
}
