# One robot in one module, step by step, and what carries it to LCM. Knows of cameras only that they
# take snapshots: OpenGL is not linked here.
eod_library(eod_simulator
  SOURCES all_modules.cpp command_link.cpp exercise_control.cpp judge_step.cpp look_ahead.cpp message_node.cpp
          mission_report.cpp operator_command.cpp picture_node.cpp place.cpp placing.cpp sight.cpp sim_node.cpp
          simulator.cpp state_csv.cpp step_report.cpp telemetry_node.cpp
  DEPENDS eod_platform lcmtypes eod_sim_robot eod_sim_world eod_sim_motion eod_sim_isectors
          eod_sim_response eod_sim_rules eod_sim_scenario eod_sim_bodies eod_sim_stance eod_sim_disposal eod_sim_plume
          eod_sim_alarms eod_sim_task eod_sim_radio eod_sim_battery eod_sim_faults eod_sim_score
  HIDES fmt::fmt)
