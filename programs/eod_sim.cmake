eod_program(eod-sim SOURCES batch_command.cpp batch_display.cpp eod_sim.cpp score_command.cpp sim_options.cpp simulate.cpp
            DEPENDS eod_batch eod_lockstep eod_simulator eod_sim_camera eod_sim_score CLI11::CLI11 fmt::fmt)
