#include "firmware_emu/box_console.h"

#include "firmware_emu/keyboard.h"
#include "firmware_emu/panel_screen.h"

namespace eod::box {
namespace {

constexpr Duration kPicturePeriod = std::chrono::milliseconds(50);
// A terminal sends an escape sequence in one go; ESC alone for this long is the Escape key.
constexpr Duration kEscapeTime = std::chrono::milliseconds(50);

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
    terminal_->Write(DrawPanel(node_.status(), node_.hands().inputs()));
    next_picture_ = scheduled + kPicturePeriod;
  }
}

void BoxConsole::ReadKeys(TimePoint now) {
  const std::string typed = terminal_->Read();
  if (!typed.empty()) last_key_ = now;
  std::vector<Key> keys = keys_.Feed(typed);
  if (typed.empty() && now - last_key_ > kEscapeTime) keys = keys_.Flush();
  for (const Key& key : keys) {
    if (PressKey(key, now, node_.hands()) == KeyOutcome::kQuit) has_quit_ = true;
  }
}

}  // namespace eod::box
