#pragma once

#include <algorithm>
#include <span>

#include "platform/can_bus.h"

namespace eod {

/// True if one of `filters` accepts `frame`, or if there are none.
inline bool IsAccepted(std::span<const CanFilter> filters, const CanFrame& frame) {
  return filters.empty() || std::ranges::any_of(filters, [&frame](const CanFilter& filter) {
           return filter.extended == frame.extended && ((filter.id ^ frame.id) & filter.mask) == 0;
         });
}

}  // namespace eod
