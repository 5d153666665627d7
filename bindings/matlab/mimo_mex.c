/*
 * The gateway from MATLAB and Octave to libmimo: mimo_mex('command', arguments...). Users call the .m files of this
 * folder. mimo_build compiles it, with MATLAB's mex or with mkoctfile --mex.
 */
#include <string.h>

#include "mimo_access.h"
#include "mimo_base.h"
#include "mimo_engines.h"
#include "mimo_layout.h"
#include "mimo_recordings.h"
#include "mimo_report.h"
#include "mimo_scenes.h"
#include "mimo_sight.h"
#include "mimo_stages.h"
#include "mimo_worlds.h"

static const mimo_command* find(const char* name) {
  const mimo_command* parts[] = {mimo_world_commands,  mimo_layout_commands,    mimo_access_commands,
                                 mimo_sight_commands,  mimo_scene_commands,     mimo_report_commands,
                                 mimo_engine_commands, mimo_recording_commands, mimo_stage_commands};
  const mimo_command* command;
  size_t i;
  for (i = 0; i < sizeof parts / sizeof *parts; ++i)
    for (command = parts[i]; command->name != NULL; ++command)
      if (strcmp(name, command->name) == 0) return command;
  return NULL;
}

void mexFunction(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  char name[16] = "";
  const mimo_command* command;
  mexAtExit(mimo_close_all);
  mimo_need(nin > 0 && mxIsChar(in[0]), "expected a command");
  mxGetString(in[0], name, sizeof name);
  command = find(name);
  if (command == NULL) mimo_refuse("no command %s", name);
  command->run(nout, out, nin - 1, in + 1);
}
