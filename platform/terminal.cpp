#include "platform/terminal.h"

#include <array>
#include <csignal>
#include <stdexcept>

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace eod {
namespace {

constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l\x1b[2J";
constexpr std::string_view kLeave = "\x1b[0m\x1b[?25h\x1b[?1049l";
constexpr std::array kCrashSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Static, because a crash must find it.
termios former_mode;

void WriteAll(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<size_t>(written));
  }
}

void Restore() {
  WriteAll(kLeave);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &former_mode);
}

// The handler was reset by SA_RESETHAND: the signal now does what it does by itself.
void RestoreAndCrash(int signal) {
  Restore();
  ::raise(signal);
}

void OnCrash(void (*reaction)(int)) {
  struct sigaction action {};
  action.sa_handler = reaction;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : kCrashSignals) ::sigaction(signal, &action, nullptr);
}

}  // namespace

Terminal::Terminal() {
  if (::isatty(STDOUT_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &former_mode) != 0) {
    throw std::runtime_error(
        "--keyboard: standard input and output must be a terminal; use --script FILE without one");
  }
  termios raw = former_mode;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | IEXTEN);
  raw.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  raw.c_cc[VSUSP] = raw.c_cc[VQUIT] = _POSIX_VDISABLE;
  OnCrash(RestoreAndCrash);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  WriteAll(kEnter);
}

Terminal::~Terminal() {
  Restore();
  OnCrash(SIG_DFL);
}

std::string Terminal::Read() {
  std::array<char, 256> bytes;
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  return count > 0 ? std::string(bytes.data(), static_cast<size_t>(count)) : std::string();
}

void Terminal::Write(std::string_view text) {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  if (::poll(&output, 1, 0) == 1) WriteAll(text);
}

int TerminalColumns() {
  if (::isatty(STDOUT_FILENO) == 0) return 0;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace eod
