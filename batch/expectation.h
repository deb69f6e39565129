#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/scenario/fail_reason.h"

namespace eod::batch {

/// How a run ends.
struct Outcome {
  enum class Kind : uint8_t {
    kSuccess,
    kFailure,     ///< of the exercise, for `reason`
    kAbort,       ///< the operator ended the exercise
    kScript,      ///< the script failed: it did not find what it waited for
    kUnfinished,  ///< the script ended, or time did, and the exercise had not
  };
  Kind kind = Kind::kSuccess;
  sim::FailReason reason = sim::FailReason::kNone;
  bool operator==(const Outcome&) const = default;
};

/// "success", "failure exploded", "abort", "script", "unfinished".
std::string TextOf(const Outcome& outcome);

/// Throws std::runtime_error "'WORDS': allowed: …" for what TextOf does not give.
Outcome ParseOutcome(std::string_view text);

/// What a script says that its run comes to: its first line "# expect: failure exploded". Without
/// one, a script named NAME.boxscript is to succeed, and one named NAME.WHAT.boxscript has to say
/// it. Throws std::runtime_error "FILE:1: …".
Outcome ExpectedOf(const std::filesystem::path& script, std::string_view text);

}  // namespace eod::batch
