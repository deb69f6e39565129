#include "firmware_emu/script_runner.h"

#include <utility>

#include <fmt/format.h>

#include "firmware_emu/seen_condition.h"
#include "firmware_emu/vocabulary.h"

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

void ScriptRunner::Tick(TimePoint now, const PanelStatus& status, const Sight& sight,
                        OperatorHands& hands) {
  odometer_.Update(now, status);
  const Evidence evidence{
      .now = now, .status = status, .sight = sight.IsFresh(now) ? &sight : nullptr};
  while (!is_done_) {
    const Statement& statement = script_.statements[next_];
    if (!has_begun_) Begin(statement, now, status, hands);
    const bool has_ended = HasEnded(statement, evidence, hands);
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
  } else if (statement.kind == Kind::kManoeuvre) {
    steering_.Begin(statement.manoeuvre, now, hands);
    seen_ = now;
  }
}

bool ScriptRunner::HasEnded(const Statement& statement, const Evidence& evidence,
                            OperatorHands& hands) {
  const Duration elapsed = evidence.now - begin_;
  switch (statement.kind) {
    case Kind::kAction:
      return !statement.action.is_tap() || elapsed >= OperatorHands::kTapTime + kTapPause;
    case Kind::kWaitFor:
    case Kind::kHoldFor:
      return elapsed >= statement.duration;
    case Kind::kWaitUntil:
    case Kind::kHoldUntil:
      return HasCome(statement, evidence);
    case Kind::kManoeuvre:
      return HasArrived(statement, evidence, hands);
    case Kind::kExpect:
      if (!Holds(statement.condition, evidence.status, odometer_, evidence.sight)) {
        Fail(statement, Observed(statement.condition, evidence.status, odometer_, evidence.sight));
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

bool ScriptRunner::HasCome(const Statement& statement, const Evidence& evidence) {
  const Condition& condition = statement.condition;
  if (Holds(condition, evidence.status, odometer_, evidence.sight)) return true;
  if (evidence.now - begin_ < statement.duration) return false;
  Fail(statement, "time is up: " + Observed(condition, evidence.status, odometer_, evidence.sight));
  return true;
}

bool ScriptRunner::HasArrived(const Statement& statement, const Evidence& evidence,
                              OperatorHands& hands) {
  const TimePoint now = evidence.now;
  const Sight* sight = evidence.sight;
  if (sight == nullptr) {
    steering_.LetGo(now, hands);
    if (now - seen_ < Sight::kLongest) return false;
    Fail(statement, std::string(kNothingSeen));
    return true;
  }
  seen_ = now;
  if (!steering_.goal_is_seen(*sight)) {
    Fail(statement, NotSeen(statement.manoeuvre.object, *sight));
    return true;
  }
  const Steering::Progress progress = steering_.Advance(now, *sight, hands);
  const bool is_late = now - begin_ >= statement.duration;
  const bool is_there = progress == Steering::Progress::kThere;
  if (progress == Steering::Progress::kUnderWay && !is_late) return false;
  if (!is_there) {
    Fail(statement,
         fmt::format(
             "{}: {}, inhibit reason is {}",
             progress == Steering::Progress::kStuck ? "the robot does not move" : "time is up",
             steering_.Left(*sight),
             words::kInhibitReason[static_cast<size_t>(evidence.status.feedback.inhibit_reason)]));
  }
  steering_.End(now, hands);
  return true;
}

void ScriptRunner::Fail(const Statement& statement, const std::string& why) {
  failure_ =
      fmt::format("{}:{}: {}: {}", script_.file.string(), statement.line, statement.text, why);
}

}  // namespace eod::box
