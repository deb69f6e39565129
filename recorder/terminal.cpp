#include "recorder/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace eod::recorder {

int TerminalColumns() {
  if (::isatty(STDOUT_FILENO) == 0) return 0;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace eod::recorder
