#pragma once

#include <filesystem>

#include "sim/sdf/sdf_file.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Steps of LoadWorld; private to this folder. Both throw "FILE:LINE: …".

/// A model that is not static, in the module whose class bit is given.
MovableObject ReadMovable(const SdfModel& model, uint32_t module_bit,
                          const std::filesystem::path& file);

/// The `<eod:vessel>` of a static model.
VesselSpec ReadVessel(const CustomElement& element, const SdfModel& model);

}  // namespace eod::sim
