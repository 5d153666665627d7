/*
 * The gateway from MATLAB and Octave to libmimo: mimo_mex('command', arguments...). The .m files beside it are what
 * one calls; mimo_build compiles it, with MATLAB's mex or with mkoctfile --mex.
 */
#include <string.h>

#include "mimo_access.h"
#include "mimo_base.h"
#include "mimo_worlds.h"

static const mimo_command* find(const mimo_command* commands, const char* name) {
  for (; commands->name != NULL; ++commands)
    if (strcmp(name, commands->name) == 0) return commands;
  return NULL;
}

void mexFunction(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  char name[16] = "";
  const mimo_command* command;
  mexAtExit(mimo_close_all);
  mimo_need(nin > 0 && mxIsChar(in[0]), "expected a command");
  mxGetString(in[0], name, sizeof name);
  command = find(mimo_world_commands, name);
  if (command == NULL) command = find(mimo_access_commands, name);
  if (command == NULL) mimo_refuse("no command %s", name);
  command->run(nout, out, nin - 1, in + 1);
}
