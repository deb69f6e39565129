#include "firmware_emu/box_console.h"

#include "firmware_emu/keyboard.h"
#include "firmware_emu/panel_screen.h"

namespace eod::box {
namespace {

constexpr Duration kPicturePeriod = std::chrono::milliseconds(50);
// A terminal sends an escape sequence in one go; ESC alone for this long is the Escape key.
constexpr Duration kEscapeTime = std::chrono::milliseconds(50);
// Keyboards repeat 10 to 30 times a second; nobody taps that fast.
constexpr Duration kSlowestRepeat = std::chrono::milliseconds(120);

}  // namespace

BoxConsole::BoxConsole(BoxNode& node, const Options& options) : node_(node), options_(options) {
  if (options_.keyboard) terminal_.emplace();
}

bool BoxConsole::is_finished() const {
  return has_quit_ || (node_.is_script_done() && !options_.stay);
}

void BoxConsole::OnTick(TimePoint scheduled) {
  if (terminal_) ReadKeys(scheduled);
  node_.OnTick(scheduled);
  if (terminal_ && scheduled >= next_picture_) {
    const std::string_view alarm = node_.alarm_name(node_.status().feedback.alarm_code);
    terminal_->Write(DrawPanel(node_.status(), node_.hands().inputs(), alarm));
    next_picture_ = scheduled + kPicturePeriod;
  }
}

void BoxConsole::ReadKeys(TimePoint now) {
  const std::string typed = terminal_->Read();
  if (!typed.empty()) last_typed_ = now;
  std::vector<Key> keys = keys_.Feed(typed);
  if (typed.empty() && now - last_typed_ > kEscapeTime) keys = keys_.Flush();
  for (const Key& key : keys) {
    const bool is_repeat = key == last_key_ && now - last_press_ <= kSlowestRepeat;
    last_key_ = key;
    last_press_ = now;
    const Duration hold = is_repeat ? kRepeatHoldTime : kKeyHoldTime;
    if (PressKey(key, now, node_.hands(), hold) == KeyOutcome::kQuit) has_quit_ = true;
  }
}

}  // namespace eod::box
