#include "firmware_emu/manoeuvre.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::box {
namespace {

bool IsNumberNext(const WordReader& words) {
  const std::string_view word = words.Peek();
  return !word.empty() && word.find_first_not_of("+-.0123456789") == std::string_view::npos;
}

void RequireWord(WordReader& words, std::string_view word) {
  if (words.TakeIf(word)) return;
  const std::string found = words.at_end() ? "end of line" : std::string(words.Peek());
  throw std::runtime_error(fmt::format("'{}': allowed: {}", found, word));
}

void ParsePlace(Manoeuvre& manoeuvre, WordReader& words) {
  RequireWord(words, "at");
  manoeuvre.kind = Manoeuvre::Kind::kApproach;
  manoeuvre.ahead = words.TakeNumber();
  if (IsNumberNext(words)) manoeuvre.side = words.TakeNumber();
  if (manoeuvre.ahead < Manoeuvre::kNearest) {
    throw std::runtime_error(
        fmt::format("'{}': allowed: {:g} m or more", manoeuvre.ahead, Manoeuvre::kNearest));
  }
}

void ParseDrive(Manoeuvre& manoeuvre, WordReader& words) {
  if (IsNumberNext(words)) {
    manoeuvre.x = words.TakeNumber();
    manoeuvre.y = words.TakeNumber();
  } else {
    manoeuvre.object = words.Take("X Y or the name of an object");
    if (words.Peek() == "at") return ParsePlace(manoeuvre, words);
  }
  manoeuvre.backwards = words.TakeIf("backwards");
}

}  // namespace

bool IsManoeuvreWord(std::string_view verb) {
  return verb == "drive" || verb == "turn" || verb == "approach";
}

Manoeuvre ParseManoeuvre(std::string_view verb, WordReader& words) {
  Manoeuvre manoeuvre;
  if (verb == "approach") {
    manoeuvre.object = words.Take("the name of an object");
    ParsePlace(manoeuvre, words);
    return manoeuvre;
  }
  RequireWord(words, "to");
  if (verb == "drive") {
    ParseDrive(manoeuvre, words);
    return manoeuvre;
  }
  manoeuvre.kind = Manoeuvre::Kind::kTurnTo;
  if (IsNumberNext(words)) {
    manoeuvre.heading_deg = words.TakeNumber();
  } else {
    manoeuvre.object = words.Take("a heading in degrees or the name of an object");
  }
  return manoeuvre;
}

}  // namespace eod::box
