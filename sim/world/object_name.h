#pragma once

#include <string>
#include <vector>

namespace eod::sim {

/// Name of an object by its number, "" if there is none.
inline const std::string& NameOf(const std::vector<std::string>& names, int object) {
  static const std::string none;
  const auto index = static_cast<size_t>(object);
  return object < 0 || index >= names.size() ? none : names[index];
}

}  // namespace eod::sim
