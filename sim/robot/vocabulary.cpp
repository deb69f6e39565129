#include "sim/robot/vocabulary.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eod::sim {

namespace {

constexpr std::array<std::string_view, 12> kParts = {"front_left_wheel",
                                                     "front_right_wheel",
                                                     "rear_left_wheel",
                                                     "rear_right_wheel",
                                                     "left_hand",
                                                     "right_hand",
                                                     "crossbeam",
                                                     "chassis",
                                                     "big_arm",
                                                     "small_arm",
                                                     "mast",
                                                     "held_bomb"};

constexpr std::array<std::string_view, 8> kMethods = {"volume", "hat", "z",      "zpr",
                                                      "xyzpr",  "los", "tripod", "bump"};

/// Index of the attribute's word in `words`.
template <size_t size>
int IndexOf(const CustomElement& element, const std::string& attribute,
            const std::array<std::string_view, size>& words) {
  const std::string& text = element.Text(attribute);
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    element.Fail(fmt::format("{} = \"{}\" of <eod:{}>: allowed {}", attribute, text, element.name,
                             fmt::join(words, ", ")));
  }
  return static_cast<int>(found - words.begin());
}

int ToMotion(const CustomElement& element, const std::string& attribute, std::string_view word) {
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (word == fmt::format("M{:02}", motion + 1)) return motion;
  }
  element.Fail(fmt::format("{}: \"{}\" of <eod:{}> is no motion: allowed M01..M{}", attribute, word,
                           element.name, kMotionCount));
}

}  // namespace

int MotionOf(const CustomElement& element, const std::string& attribute) {
  return ToMotion(element, attribute, element.Text(attribute));
}

MotionSet MotionsOf(const CustomElement& element, const std::string& attribute) {
  const std::string& text = element.Text(attribute);
  if (text == "all") return kAllMotions;
  if (text == "always") return kAllMotions | kAlways;
  MotionSet motions = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) motions |= SetOf(ToMotion(element, attribute, word));
  if (motions == 0) {
    element.Fail(fmt::format("{} of <eod:{}> is empty", attribute, element.name));
  }
  return motions;
}

Part PartOf(const CustomElement& element, const std::string& attribute) {
  return static_cast<Part>(IndexOf(element, attribute, kParts));
}

IsectorMethod MethodOf(const CustomElement& element, const std::string& attribute) {
  return static_cast<IsectorMethod>(IndexOf(element, attribute, kMethods));
}

}  // namespace eod::sim
