#include "sim/scenario/variation.h"
#include "sim/simulator.h"

namespace eod::sim {

/// What the operator wishes, as far as the instructor lets him.
Wish Simulator::Hear(const OperatorCommand& command, TimePoint now) const {
  if (paused_) return {};
  const Wish wish = WishOf(command, faults_.active(), now, config_.command_timeout);
  if (!estopped_) return wish;
  Wish stopped;
  stopped.refused = wish.demand.commanded | wish.refused;
  stopped.reason = kReasonEstop;
  return stopped;
}

bool Simulator::Instruct(const InstructorCommand& command) {
  estopped_ = command.estop;
  if (!command.scenario.empty() && menu_.Find(command.scenario) == nullptr) return false;
  instructed_.push_back(command);
  return true;
}

void Simulator::ObeyInstructor() {
  for (const InstructorCommand& command : instructed_) {
    const Scenario* found = command.scenario.empty() ? nullptr : menu_.Find(command.scenario);
    if (found != nullptr && PlaceOf(found->module) != nullptr) {
      menu_.Load(Vary(*found, command.repetition));
      scenario_ = nullptr;
      Enter(menu_.loaded());
      paused_ = false;
    }
    if (command.menu_command == kMenuStart) Enter(*scenario_);
    if (command.menu_command == kMenuEnd) {
      instructor_ends_ = true;
      paused_ = false;
    } else {
      Obey(command.menu_command);
    }
  }
  instructed_.clear();
}

/// A menu command acts once, when it appears. A module that this world lacks is no reason to fail:
/// the mission starts where the robot is.
void Simulator::ObeyMenu(const OperatorCommand& command) {
  if (command.menu_command == last_menu_command_) return;
  last_menu_command_ = command.menu_command;
  if (command.menu_command == kMenuStart) {
    const bool stays = command.menu_module == 0 && command.menu_exercise > 0;
    const int module = stays ? place_->module().id : command.menu_module;
    if (PlaceOf(module) != nullptr) Enter(menu_.Choose(module, command.menu_exercise));
  }
  Obey(command.menu_command);
}

void Simulator::Obey(int menu_command) {
  switch (menu_command) {
    case kMenuStart:
      start_asked_ = true;
      break;
    case kMenuPause:
      paused_ = true;
      return;
    case kMenuResume:
      break;
    case kMenuReset:
      Enter(*scenario_);
      break;
    case kMenuEnd:
      end_asked_ = true;
      break;
    default:
      return;
  }
  paused_ = false;
}

Place* Simulator::PlaceOf(int module) const {
  for (const auto& place : places_) {
    if (place->module().id == module) return place.get();
  }
  return nullptr;
}

void Simulator::Enter(const Scenario& scenario) {
  place_ = PlaceOf(scenario.module);
  if (scenario_ == &scenario) {
    place_->Restart();
  } else {
    scenario_ = &scenario;
    place_->Load(scenario);
    link_ = ControlLink(scenario.link, config_.exercise.link, dt_s_);
    faults_ = FaultInjector(scenario, robot_);
    ++exercises_;
  }
  explosion_.Reset();
  faults_.Reset();
  battery_.Reset();
  StandAtStart();
  link_.Reset(place_->world, place_->module().class_bit, result_.state, true);
}

}  // namespace eod::sim
