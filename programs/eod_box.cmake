eod_program(eod-box SOURCES eod_box.cpp DEPENDS eod_box eod_platform CLI11::CLI11 fmt::fmt)
