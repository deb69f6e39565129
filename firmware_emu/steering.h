#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "firmware_emu/manoeuvre.h"
#include "firmware_emu/operator_hands.h"
#include "firmware_emu/sight.h"

namespace eod::box {

/// Carries out a manoeuvre as a practised person does: looks, holds M01 to M04, lets go in time,
/// and looks again.
///
/// Turns toward the goal on the spot, drives at the speed that is set, corrects the heading on the
/// way, and goes down to low and creep for the end. Notices how late the robot follows, and lets go
/// by so much earlier; what is short is done by holding a button for a counted time, which is right
/// however late it acts. Standing, it goes over what is left: an approach until both ways are right
/// to 4 mm, a drive to 3 cm along its heading, a turn to 0.2 degrees. The speed controls are given
/// back as they were.
class Steering {
 public:
  enum class Progress : uint8_t {
    kUnderWay,
    kThere,
    kStuck,  ///< buttons are held and the robot has not moved for 5 s
  };

  void Begin(const Manoeuvre& manoeuvre, TimePoint now, const OperatorHands& hands);

  /// To be called every tick with what is seen now. `goal_is_seen` must hold.
  Progress Advance(TimePoint now, const Sight& sight, OperatorHands& hands);

  /// Lets go of the drive buttons: nothing is seen for the moment.
  void LetGo(TimePoint now, OperatorHands& hands) { Hold(0, now, hands); }

  /// Lets go of the drive buttons, and puts the speed controls back.
  void End(TimePoint now, OperatorHands& hands);

  bool goal_is_seen(const Sight& sight) const;

  /// How far it still is, for messages: "0.32 m and 1.5 deg are left".
  std::string Left(const Sight& sight) const;

 private:
  enum class Phase : uint8_t { kTurn, kGo, kSettle };
  /// What is left; both signed.
  struct Gap {
    double heading_deg = 0;  ///< left positive
    double way = 0;          ///< [m] forward positive
  };

  Gap Measure(const Sight& sight) const;
  void Turn(const Gap& gap, const Sight& sight, TimePoint now, OperatorHands& hands);
  void ChooseRange(double left, TimePoint now, OperatorHands& hands);
  void Go(const Gap& gap, const Sight& sight, TimePoint now, OperatorHands& hands);
  bool Settle(const Gap& gap);
  double HeadingTolerance(const Gap& gap) const;
  uint32_t Correct(double heading_gap, TimePoint now);
  bool IsTapping(TimePoint now, OperatorHands& hands);
  void Hold(uint32_t motions, TimePoint now, OperatorHands& hands);
  void Tap(uint32_t motions, double seconds, TimePoint now, OperatorHands& hands);
  void LearnLatency(const Sight& sight, TimePoint now);
  void SetRange(dbc::SpeedRange range, TimePoint now, OperatorHands& hands);
  void SetLimit(double share, TimePoint now, OperatorHands& hands);
  bool HasStood(const Sight& sight, TimePoint now);
  bool IsStuck(const Sight& sight, TimePoint now);

  Manoeuvre manoeuvre_;
  Phase phase_ = Phase::kTurn;
  double standoff_ = 0;  ///< [m] an approach stops before its end, to look once more
  uint32_t held_ = 0;    ///< motions, bit m-1
  dbc::SpeedRange cruise_ = dbc::SpeedRange::kLow;
  dbc::SpeedRange range_ = dbc::SpeedRange::kLow;
  double full_limit_ = 1;
  double limit_ = 1;
  TimePoint control_moved_{};         ///< a speed control: the robot hears of it a little later
  TimePoint moving_{};                ///< last moment of motion or of a held button
  double latency_ = 0;                ///< [s] from finger to what is seen of it, as last observed
  TimePoint pressed_{};               ///< when a button was pressed while the robot stood
  bool awaits_motion_ = false;        ///< nothing has been seen of that yet
  std::optional<TimePoint> tap_end_;  ///< a button is held for a counted time
  TimePoint correction_end_{};        ///< the same of a touch on the way
  TimePoint correction_seen_{};       ///< what came of it can be judged from then on
  TimePoint progress_{};              ///< last moment at which the robot got on
  std::array<double, 3> progress_position_{};  ///< where it was then
  double progress_heading_ = 0;
};

}  // namespace eod::box
