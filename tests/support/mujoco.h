/* What hosts call of MuJoCo, which is another call in another version of it. */
#ifndef MIMO_TESTS_SUPPORT_MUJOCO_H
#define MIMO_TESTS_SUPPORT_MUJOCO_H

#include <mujoco/mujoco.h>
#include <stdlib.h>
#include <string.h>

#include "support/capi.h"

#if mjVERSION_HEADER >= 4000000
typedef mjPreContact host_contact;
typedef mjData host_collision_data;
#else
typedef mjContact host_contact;
typedef const mjData host_collision_data;
#endif

/* The model of a document in memory; ends the program where there is none. */
static inline mjModel* host_model_of(const char* xml, size_t length) {
  char error[500] = "";
  mjModel* model;
  mjVFS* files = malloc(sizeof *files);
  if (files == NULL) exit(1);
  mj_defaultVFS(files);
#if mjVERSION_HEADER >= 4000000
  CHECK(mj_addBufferVFS(files, "host.xml", xml, (int)length) == 0);
#else
  CHECK(mj_makeEmptyFileVFS(files, "host.xml", (int)length) == 0);
  memcpy(files->filedata[0], xml, length);
#endif
  model = mj_loadXML("host.xml", files, error, (int)sizeof error);
  mj_deleteVFS(files);
  free(files);
  if (model == NULL) {
    fprintf(stderr, "%s\n", error);
    exit(1);
  }
  return model;
}

#endif
