#include "dbc/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <numeric>

namespace eod::dbc {
namespace {

constexpr int kEdit = 2;
constexpr int kCaseEdit = 1;

int SubstitutionCost(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? kCaseEdit : kEdit;
}

/// Levenshtein distance, in half edits.
int Distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  std::for_each(row.begin(), row.end(), [](int& cost) { cost *= kEdit; });
  for (size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0];
    row[0] += kEdit;
    for (size_t j = 0; j < b.size(); ++j) {
      const int substituted = diagonal + SubstitutionCost(a[i], b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + kEdit, row[j + 1] + kEdit});
    }
  }
  return row.back();
}

}  // namespace

std::string NearestName(std::string_view name, const std::vector<std::string>& candidates) {
  std::string nearest;
  int least = std::numeric_limits<int>::max();
  for (const std::string& candidate : candidates) {
    const int distance = Distance(name, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace eod::dbc
