#include "batch/expectation.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "firmware_emu/vocabulary.h"

namespace eod::batch {
namespace {

using Kind = Outcome::Kind;

constexpr std::array<std::string_view, 5> kKinds{"success", "failure", "abort", "script",
                                                 "unfinished"};
constexpr std::string_view kMark = "# expect:";

int IndexOf(auto& words, std::string_view word) {
  const auto found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::string TextOf(const Outcome& outcome) {
  const std::string kind(kKinds[static_cast<size_t>(outcome.kind)]);
  if (outcome.kind != Kind::kFailure) return kind;
  return fmt::format("{} {}", kind, box::words::kFailure[static_cast<size_t>(outcome.reason)]);
}

Outcome ParseOutcome(std::string_view text) {
  const std::string_view first = text.substr(0, text.find(' '));
  const std::string_view rest = Trim(text.substr(first.size()));
  const int kind = IndexOf(kKinds, first);
  const bool is_failure = kind == static_cast<int>(Kind::kFailure);
  const int reason = is_failure ? IndexOf(box::words::kFailure, rest) : 0;
  if (kind < 0 || (is_failure ? reason < 1 : !rest.empty())) {
    throw std::runtime_error(
        fmt::format("'{}': allowed: {}, where failure has one of {}", text, fmt::join(kKinds, ", "),
                    fmt::join(box::words::kFailure.begin() + 1, box::words::kFailure.end(), ", ")));
  }
  return {.kind = static_cast<Kind>(kind), .reason = static_cast<sim::FailReason>(reason)};
}

Outcome ExpectedOf(const std::filesystem::path& script, std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  if (!line.starts_with(kMark)) {
    const bool is_plain = script.stem().extension().empty();
    if (is_plain) return {};
    throw std::runtime_error(
        fmt::format("{}:1: '{}': allowed: {} OUTCOME, for a script that drives into a failure",
                    script.string(), line, kMark));
  }
  try {
    return ParseOutcome(Trim(line.substr(kMark.size())));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}:1: {}", script.string(), error.what()));
  }
}

}  // namespace eod::batch
