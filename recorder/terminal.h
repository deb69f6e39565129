#pragma once

namespace eod::recorder {

/// Width of the terminal that standard output goes to [columns]; 0 if it goes elsewhere.
int TerminalColumns();

}  // namespace eod::recorder
