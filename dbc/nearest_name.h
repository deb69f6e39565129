#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eod::dbc {

/// The candidate that a mistyped `name` most likely meant: smallest edit distance, letter case
/// counting half. Empty if there is no candidate.
std::string NearestName(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace eod::dbc
