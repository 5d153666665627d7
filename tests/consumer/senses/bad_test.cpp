// Each library that is no sense is named, with what is wrong with it; the scene stays as it was.
#include "check.hpp"

int main(int argc, char** argv) {
  const char* const words[] = {"exports no mimo_sense_entry", "interface_version is 7, but this library knows 1",
                               "returned -5 (MIMO_E_NOT_FOUND): no file of odours",
#ifdef _WIN32
                               "",
#else
                               "threw an exception: no nose here",
#endif
                               "write is NULL"};
  if (argc != 6) return 2;
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  scene.add_agents();
  for (int i = 0; i < 5; ++i) {
    if (*words[i] == '\0') continue;
    try {
      scene.load_sense(argv[i + 1]);
      check(false, std::string(argv[i + 1]) + " was not refused");
    } catch (const mimo::Exception& error) {
      const std::string message = error.what();
      check(message.find(words[i]) != std::string::npos && message.find(argv[i + 1]) != std::string::npos, message);
    }
  }
  check(scene.sense_parameters().empty(), "nothing was added");
  return failures;
}
