#pragma once

#include <cstdlib>

#include <LinearMath/btAlignedAllocator.h>

namespace eod {

/// Calls of Bullet's allocator since the program started.
inline long bullet_allocations = 0;

inline void* CountedBulletAllocation(size_t size) {
  ++bullet_allocations;
  return std::malloc(size);
}

/// Bullet must be told before it takes anything.
inline const bool kCountsBullet = [] {
  btAlignedAllocSetCustom(CountedBulletAllocation, std::free);
  return true;
}();

}  // namespace eod
