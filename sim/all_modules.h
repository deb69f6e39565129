#pragma once

#include "sim/world/world_model.h"

namespace eod::sim {

/// `own` with the static collision triangles of all other modules beside it, where they are in the
/// world: what segments meet when no module mask tells the modules apart. In `own`'s local frame.
ModuleModel WithAllModules(const WorldModel& world, const ModuleModel& own);

}  // namespace eod::sim
