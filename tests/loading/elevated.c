/* Prints what opening a recording says: check_elevated runs it with and without elevated rights.
 * loading_elevated libmimo.so */
#include "loading/library.h"

int main(int argc, char** argv) {
  mimo_status (*open_recording)(const char*, const char*, mimo_recording**);
  mimo_recording* recording = NULL;
  if (argc != 2) return 2;
  library mimo = open_library(argv[1]);
  look_up(mimo.handle, "mimo_recording_open", &open_recording);
  open_recording("/nowhere/run.h5", NULL, &recording);
  puts(mimo.last_error());
  return recording != NULL;
}
