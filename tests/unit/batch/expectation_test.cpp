#include "batch/expectation.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::batch {
namespace {

using Kind = Outcome::Kind;
using sim::FailReason;
using testing::HasSubstr;
using testing::StartsWith;

std::string ErrorOf(const char* file, const char* text) {
  try {
    ExpectedOf(file, text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Expectation, APlainScriptIsToSucceed) {
  EXPECT_EQ(ExpectedOf("d/bomb.boxscript", "# Anything\nwait 1s\n").kind, Kind::kSuccess);
  EXPECT_EQ(ExpectedOf("bomb.boxscript", "").kind, Kind::kSuccess);
}

TEST(Expectation, TheFirstLineSaysWhatElse) {
  EXPECT_EQ(ExpectedOf("bomb.dropped.boxscript", "# expect: failure exploded\nwait 1s\n"),
            (Outcome{Kind::kFailure, FailReason::kExploded}));
  EXPECT_EQ(ExpectedOf("bomb.late.boxscript", "# expect:  failure  time_out \r\n"),
            (Outcome{Kind::kFailure, FailReason::kTimeOut}));
  EXPECT_EQ(ExpectedOf("bomb.other_way.boxscript", "# expect: success").kind, Kind::kSuccess);
  EXPECT_EQ(ExpectedOf("bomb.boxscript", "# expect: abort").kind, Kind::kAbort);
}

TEST(Expectation, AScriptIntoAFailureHasToSayWhich) {
  EXPECT_THAT(ErrorOf("d/bomb.dropped.boxscript", "# Dropped\n"),
              StartsWith("d/bomb.dropped.boxscript:1: '# Dropped': allowed: # expect: OUTCOME"));
  EXPECT_THAT(ErrorOf("a.b.boxscript", "# expect: failure"), HasSubstr("failure has one of"));
  EXPECT_THAT(ErrorOf("a.b.boxscript", "# expect: failure none"), HasSubstr("a.b.boxscript:1:"));
  EXPECT_THAT(ErrorOf("a.b.boxscript", "# expect: victory"),
              HasSubstr("'victory': allowed: success, failure, abort"));
  EXPECT_THAT(ErrorOf("a.b.boxscript", "# expect: success soon"), HasSubstr("a.b.boxscript:1:"));
}

TEST(Expectation, EveryOutcomeReadsAsItIsWritten) {
  for (const Kind kind : {Kind::kSuccess, Kind::kAbort, Kind::kScript, Kind::kUnfinished}) {
    EXPECT_EQ(ParseOutcome(TextOf({.kind = kind})), Outcome{.kind = kind});
  }
  for (int reason = 1; reason <= static_cast<int>(FailReason::kWrongOrder); ++reason) {
    const Outcome failure{Kind::kFailure, static_cast<FailReason>(reason)};
    EXPECT_EQ(ParseOutcome(TextOf(failure)), failure);
  }
}

}  // namespace
}  // namespace eod::batch
