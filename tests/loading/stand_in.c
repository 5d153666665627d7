/* Stands in for a MuJoCo of another version: its functions have the same names, and must not be called with our data.
 */
#include <stdlib.h>

#define REFUSE(name) \
  void name(void);   \
  void name(void) { abort(); }

int mj_version(void);
int mj_version(void) { return 999; }
const char* mj_versionString(void);
const char* mj_versionString(void) { return "9.9.9"; }

REFUSE(mj_loadXML)
REFUSE(mj_defaultVFS)
REFUSE(mj_deleteVFS)
REFUSE(mj_makeEmptyFileVFS)
REFUSE(mj_makeData)
REFUSE(mj_resetData)
REFUSE(mj_deleteData)
REFUSE(mj_deleteModel)
REFUSE(mj_forward)
REFUSE(mj_step)
REFUSE(mj_kinematics)
REFUSE(mju_malloc)
REFUSE(mju_error)
