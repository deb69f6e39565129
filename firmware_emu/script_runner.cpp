#include "firmware_emu/script_runner.h"

#include <utility>

#include <fmt/format.h>

namespace eod::box {
namespace {

using Kind = Statement::Kind;

bool IsHold(const Statement& statement) {
  return statement.kind == Kind::kHoldFor || statement.kind == Kind::kHoldUntil;
}

}  // namespace

ScriptRunner::ScriptRunner(Script script) : script_(std::move(script)) {
  is_done_ = script_.statements.empty();
}

const std::string& ScriptRunner::current_line() const {
  static const std::string nothing;
  return is_done_ ? nothing : script_.statements[next_].text;
}

std::vector<std::string> ScriptRunner::TakeNotes() { return std::exchange(notes_, {}); }

void ScriptRunner::Tick(TimePoint now, const PanelStatus& status, OperatorHands& hands) {
  odometer_.Update(now, status);
  while (!is_done_) {
    const Statement& statement = script_.statements[next_];
    if (!has_begun_) Begin(statement, now, status, hands);
    const bool has_ended = HasEnded(statement, now, status);
    if (has_ended && IsHold(statement)) {
      hands.Apply(statement.release, now);
    }
    if (failure_) {
      hands.Apply({.control = Control::kReleaseAll}, now);
      hands.Apply({.control = Control::kDeadman, .choice = 0}, now);
      is_done_ = true;
    }
    if (!has_ended || is_done_) return;
    has_begun_ = false;
    is_done_ = ++next_ >= script_.statements.size();
  }
}

void ScriptRunner::Begin(const Statement& statement, TimePoint now, const PanelStatus& status,
                         OperatorHands& hands) {
  has_begun_ = true;
  begin_ = now;
  if (statement.kind == Kind::kAction) {
    hands.Apply(statement.action, now);
  } else if (IsHold(statement)) {
    odometer_.Restart(now, status);
    hands.Apply(statement.press, now);
  }
}

bool ScriptRunner::HasEnded(const Statement& statement, TimePoint now, const PanelStatus& status) {
  switch (statement.kind) {
    case Kind::kAction:
      return !statement.action.is_tap() || now - begin_ >= OperatorHands::kTapTime + kTapPause;
    case Kind::kWaitFor:
    case Kind::kHoldFor:
      return now - begin_ >= statement.duration;
    case Kind::kWaitUntil:
    case Kind::kHoldUntil:
      return HasCome(statement, now, status);
    case Kind::kExpect:
      if (!Holds(statement.condition, status, odometer_)) {
        Fail(statement, Observed(statement.condition, status, odometer_));
      }
      return true;
    case Kind::kNote:
      notes_.push_back(statement.message);
      return true;
    case Kind::kFail:
      Fail(statement, statement.message);
      return true;
  }
  return true;
}

bool ScriptRunner::HasCome(const Statement& statement, TimePoint now, const PanelStatus& status) {
  if (Holds(statement.condition, status, odometer_)) return true;
  if (now - begin_ < statement.duration) return false;
  Fail(statement, "time is up: " + Observed(statement.condition, status, odometer_));
  return true;
}

void ScriptRunner::Fail(const Statement& statement, const std::string& why) {
  failure_ =
      fmt::format("{}:{}: {}: {}", script_.file.string(), statement.line, statement.text, why);
}

}  // namespace eod::box
