#pragma once

#include <cstdint>

namespace eod::sim {

/// Class mask bits of what segments can meet. Order of the modules as in the source paper.
inline constexpr uint32_t kModuleFlat = 0x01, kModuleSlope = 0x02, kModuleBomb = 0x04,
                          kModuleOutdoor = 0x08, kModuleIndoor = 0x10, kBombObject = 0x100,
                          kMovableObject = 0x200, kContainmentVessel = 0x400,
                          kClampProxy = 0x1000,  ///< what TRIPOD and HAT stand on
    kBumpProxy = 0x2000;                         ///< what BUMP and LOS run into
inline constexpr uint32_t kAnyModule = 0xFF;
inline constexpr uint32_t kAnyKind = 0xFFFFFF00;

/// Whether a segment with `mask` is tested against an object of class `object`: they share a bit,
/// and where the mask names modules (kinds) at all, one of those modules (kinds) is the object's.
constexpr bool Accepts(uint32_t mask, uint32_t object) {
  const uint32_t shared = mask & object;
  const bool module_fits = (mask & kAnyModule) == 0 || (shared & kAnyModule) != 0;
  const bool kind_fits = (mask & kAnyKind) == 0 || (shared & kAnyKind) != 0;
  return shared != 0 && module_fits && kind_fits;
}

}  // namespace eod::sim
