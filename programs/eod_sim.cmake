eod_program(eod-sim SOURCES eod_sim.cpp sim_options.cpp simulate.cpp batch_command.cpp batch_display.cpp
            DEPENDS eod_batch eod_lockstep eod_simulator eod_sim_camera CLI11::CLI11 fmt::fmt)
