#include "firmware_emu/seen_condition.h"

#include <fmt/format.h>

namespace eod::box {

using Subject = Condition::Subject;

bool IsByEye(Subject subject) { return subject >= Subject::kX; }

bool IsOfObject(Subject subject) { return subject >= Subject::kDistance; }

std::optional<double> SeenQuantity(const Condition& condition, const Sight& sight) {
  if (!IsOfObject(condition.subject)) {
    return sight
        .position[static_cast<size_t>(condition.subject) - static_cast<size_t>(Subject::kX)];
  }
  const SeenObject* object = sight.Find(condition.object);
  if (condition.subject == Subject::kSeen) return object == nullptr ? 0 : 1;
  if (object == nullptr) return std::nullopt;
  const FromRobot there = SeenFromRobot(sight, object->position[0], object->position[1]);
  switch (condition.subject) {
    case Subject::kDistance:
      return there.distance();
    case Subject::kAhead:
      return there.ahead;
    case Subject::kSide:
      return there.side;
    case Subject::kHeight:
      return object->position[2];
    default:
      return object->tilt_deg;
  }
}

std::string NotSeen(std::string_view object, const Sight& sight) {
  std::string seen;
  for (const SeenObject& other : sight.objects) {
    if (other.is_gone) continue;
    if (!seen.empty()) seen += ", ";
    seen += other.name;
  }
  return fmt::format("'{}' is not seen; seen are {}", object, seen.empty() ? "no objects" : seen);
}

}  // namespace eod::box
