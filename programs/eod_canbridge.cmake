eod_program(eod-canbridge SOURCES eod_canbridge.cpp DEPENDS eod_bridge)
