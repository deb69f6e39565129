eod_program(eod-console SOURCES eod_console.cpp DEPENDS eod_console CLI11::CLI11 fmt::fmt)
