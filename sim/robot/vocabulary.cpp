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

// In the order of FaceRule and HitRule.
constexpr std::array<std::string_view, 2> kFaceRules = {"two_sided", "front_only"};
constexpr std::array<std::string_view, 3> kHitRules = {"nearest", "highest", "all"};

constexpr std::array<std::string_view, 5> kClasses = {"bump", "clamp", "bomb", "movable", "vessel"};
constexpr std::array<uint32_t, 5> kClassBits = {kBumpProxy, kClampProxy, kBombObject,
                                                kMovableObject, kContainmentVessel};

// In the order of SpotLightSpec::Switch.
constexpr std::array<std::string_view, 3> kSwitches = {"drive", "gripper", "infrared"};

constexpr std::array<std::string_view, 2> kFlags = {"false", "true"};

/// Index of `text`, a word of the attribute, in `words`.
template <size_t size>
int IndexOf(const CustomElement& element, const std::string& attribute, const std::string& text,
            const std::array<std::string_view, size>& words) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    element.Fail(fmt::format("{} = \"{}\" of <eod:{}>: allowed {}", attribute, text, element.name,
                             fmt::join(words, ", ")));
  }
  return static_cast<int>(found - words.begin());
}

/// The same for an attribute of one word.
template <size_t size>
int IndexOf(const CustomElement& element, const std::string& attribute,
            const std::array<std::string_view, size>& words) {
  return IndexOf(element, attribute, element.Text(attribute), words);
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
  return static_cast<IsectorMethod>(IndexOf(element, attribute, kMethodNames));
}

FaceRule FaceRuleOf(const CustomElement& element, const std::string& attribute) {
  return static_cast<FaceRule>(IndexOf(element, attribute, kFaceRules));
}

HitRule HitRuleOf(const CustomElement& element, const std::string& attribute) {
  return static_cast<HitRule>(IndexOf(element, attribute, kHitRules));
}

uint32_t ClassesOf(const CustomElement& element, const std::string& attribute) {
  uint32_t classes = 0;
  std::istringstream words(element.Text(attribute));
  for (std::string word; words >> word;) {
    classes |= kClassBits[IndexOf(element, attribute, word, kClasses)];
  }
  if (classes == 0) {
    element.Fail(fmt::format("{} of <eod:{}> is empty: allowed {}", attribute, element.name,
                             fmt::join(kClasses, ", ")));
  }
  return classes;
}

SpotLightSpec::Switch SwitchOf(const CustomElement& element, const std::string& attribute) {
  return static_cast<SpotLightSpec::Switch>(IndexOf(element, attribute, kSwitches));
}

bool FlagOf(const CustomElement& element, const std::string& attribute, bool missing) {
  if (!element.Has(attribute)) return missing;
  return IndexOf(element, attribute, kFlags) == 1;
}

}  // namespace eod::sim
