// The real program in a pseudo terminal: what it leaves behind when it is ended.
#include <array>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

namespace eod::box {
namespace {

constexpr std::string_view kLeaveSecondScreen = "\x1b[?1049l";
constexpr int kPatienceMs = 60000;  // ends a test that hangs; a sound one needs a tenth of a second

/// eod-box --keyboard, on a bus and an LCM of its own, with this test as its terminal.
class KeyboardBox : public testing::Test {
 protected:
  KeyboardBox() {
    const winsize size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
    openpty(&master_, &slave_, nullptr, nullptr, &size);
    tcgetattr(slave_, &before_);
    child_ = fork();
    if (child_ == 0) {
      login_tty(slave_);
      execl(EOD_BIN_DIR "/eod-box", "eod-box", "--keyboard", "--bus", "inproc:a", "--lcm-url",
            "memq://", nullptr);
      _exit(127);
    }
  }
  ~KeyboardBox() override {
    if (child_ > 0) kill(child_, SIGKILL);
    if (child_ > 0) waitpid(child_, nullptr, 0);
    close(master_);
    close(slave_);
  }

  /// Reads until `text` was shown.
  bool Shows(std::string_view text) {
    while (shown_.find(text) == std::string::npos) {
      pollfd readable{.fd = master_, .events = POLLIN, .revents = 0};
      std::array<char, 4096> bytes;
      if (poll(&readable, 1, kPatienceMs) != 1) return false;
      const ssize_t count = read(master_, bytes.data(), bytes.size());
      if (count <= 0) return false;
      shown_.append(bytes.data(), static_cast<size_t>(count));
    }
    return true;
  }
  void Type(std::string_view keys) {
    ASSERT_EQ(write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  int WaitForEnd() {
    int status = -1;
    waitpid(child_, &status, 0);
    child_ = -1;
    return status;
  }
  bool IsTerminalAsBefore() const {
    termios after;
    tcgetattr(slave_, &after);
    return after.c_lflag == before_.c_lflag && after.c_iflag == before_.c_iflag &&
           after.c_cc[VMIN] == before_.c_cc[VMIN];
  }

  int master_ = -1;
  int slave_ = -1;
  pid_t child_ = -1;
  termios before_{};
  std::string shown_;
};

TEST_F(KeyboardBox, DrawsThePanelAndFollowsKeys) {
  ASSERT_TRUE(Shows("EOD CONTROL BOX"));
  EXPECT_FALSE(IsTerminalAsBefore());
  Type("m");
  EXPECT_TRUE(Shows("Key standby"));
  Type(" ");
  EXPECT_TRUE(Shows("E-stop PRESSED"));
}

TEST_F(KeyboardBox, ChoosesTheBombModuleRequestsAPresetAndArms) {
  ASSERT_TRUE(Shows("EOD CONTROL BOX"));
  Type("888");
  EXPECT_TRUE(Shows("Module bomb"));
  Type("C");
  EXPECT_TRUE(Shows("Preset carry"));
  Type("AN");
  EXPECT_TRUE(Shows("Arm key armed   Circuit 1"));
  Type("LR");
  EXPECT_TRUE(Shows("Fire left pressed   right pressed"));
}

TEST_F(KeyboardBox, QuitKeyRestoresTheTerminalAndEndsWell) {
  ASSERT_TRUE(Shows("EOD CONTROL BOX"));
  Type("Q");
  EXPECT_TRUE(Shows(kLeaveSecondScreen));
  EXPECT_EQ(WaitForEnd(), 0);
  EXPECT_TRUE(IsTerminalAsBefore());
}

TEST_F(KeyboardBox, ControlCRestoresTheTerminalAndEndsWell) {
  ASSERT_TRUE(Shows("EOD CONTROL BOX"));
  Type("\x03");
  EXPECT_TRUE(Shows(kLeaveSecondScreen));
  EXPECT_EQ(WaitForEnd(), 0);
  EXPECT_TRUE(IsTerminalAsBefore());
}

TEST_F(KeyboardBox, ACrashRestoresTheTerminal) {
  ASSERT_TRUE(Shows("EOD CONTROL BOX"));
  kill(child_, SIGFPE);
  EXPECT_TRUE(Shows(kLeaveSecondScreen));
  EXPECT_TRUE(WIFSIGNALED(WaitForEnd()));
  EXPECT_TRUE(IsTerminalAsBefore());
}

}  // namespace
}  // namespace eod::box
