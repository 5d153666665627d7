/* Included several times, with another meaning of ROW each time. Of one function each:
 *   ROW(name, what it needs, a call that succeeds, faults...) */
#include "misuse/rows_batch.h"
#include "misuse/rows_env.h"
#include "misuse/rows_geometry.h"
#include "misuse/rows_layout.h"
#include "misuse/rows_recording.h"
#include "misuse/rows_scene.h"
#include "misuse/rows_sense.h"
#include "misuse/rows_senses.h"
#include "misuse/rows_stage.h"
