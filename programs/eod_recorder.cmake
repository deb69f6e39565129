eod_program(eod-recorder SOURCES eod_recorder.cpp recorder_options.cpp DEPENDS eod_recorder CLI11::CLI11 fmt::fmt)
