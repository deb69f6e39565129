#pragma once

#include "sim/camera/draw_list.h"
#include "sim/camera/light_probe.h"

namespace eod::sim {

/// Cuts triangles of a static list, in the module's local frame, where light differs from place to
/// place, and writes sky and lamps into all its vertices. Edges are cut at their middles by rules
/// that know the edge alone, so that neighbours stay joined: under a roof to 2.4 m, near a lamp
/// that is lit to a third of the distance from it; the coarse shapes twice as coarsely,
/// blocks to 6 m and regions not at all.
void BakeLight(LightProbe& probe, DrawList& list);

}  // namespace eod::sim
