#include "sim/scenario/exercise_menu.h"

#include <utility>

#include "sim/scenario/catalogue.h"

namespace eod::sim {

ExerciseMenu::ExerciseMenu(const Scenario& loaded, std::vector<Scenario> catalogue)
    : loaded_(loaded), catalogue_(std::move(catalogue)) {
  for (size_t i = 0; i < free_.size(); ++i) {
    free_[i].file = loaded.file;
    free_[i].module = static_cast<int>(i) + 1;
  }
}

const Scenario& ExerciseMenu::Choose(int module, int number) const {
  const Scenario* first = nullptr;
  int count = 0;
  for (const Scenario& scenario : catalogue_) {
    if (scenario.module != module) continue;
    if (++count == number) return scenario;
    if (first == nullptr) first = &scenario;
  }
  if (loaded_.module == module) return loaded_;
  return first != nullptr ? *first : free_.at(static_cast<size_t>(module - 1));
}

const Scenario* ExerciseMenu::Find(std::string_view name) const {
  if (const Scenario* found = FindScenario(catalogue_, name)) return found;
  return loaded_.name == name ? &loaded_ : nullptr;
}

}  // namespace eod::sim
