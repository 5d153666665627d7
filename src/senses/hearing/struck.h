// What of a model meets when two geoms do.
#pragma once

#include "sound/scrape.h"
#include "sound/solid.h"

typedef struct mjModel_ mjModel;
typedef struct mjData_ mjData;

namespace mimo::engine {
struct Meeting;
}

namespace mimo::senses {

// A geom as something that is struck. What can move counts with the mass that MuJoCo feels at its body (translation
// alone: at corners it is too large).
sound::Struck struck(const mjModel& model, int geom, const sound::Solid& solid);

// How fast the two geoms of a contact come nearer, m/s: of the start of the last physics step. Forces of contacts,
// which MuJoCo spreads over tens of milliseconds, would tell nothing of sound.
double approach(const mjModel& model, const mjData& data, const engine::Meeting& met);

// How the two geoms of a contact slide on each other or roll: of the start of the last physics step.
sound::Sliding sliding(const mjModel& model, const mjData& data, const engine::Meeting& met);

}  // namespace mimo::senses
