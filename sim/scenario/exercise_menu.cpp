#include "sim/scenario/exercise_menu.h"

#include "sim/scenario/catalogue.h"

namespace eod::sim {

Scenario ExerciseMenu::Choose(int module, int number) const {
  const Scenario* first = nullptr;
  int count = 0;
  for (const Scenario& scenario : catalogue_) {
    if (scenario.module != module) continue;
    if (++count == number) return scenario;
    if (first == nullptr) first = &scenario;
  }
  if (loaded_.module == module) return loaded_;
  if (first != nullptr) return *first;
  Scenario free_driving;
  free_driving.file = loaded_.file;
  free_driving.module = module;
  return free_driving;
}

const Scenario* ExerciseMenu::Find(std::string_view name) const {
  if (const Scenario* found = FindScenario(catalogue_, name)) return found;
  return loaded_.name == name ? &loaded_ : nullptr;
}

}  // namespace eod::sim
