#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"

namespace eod::sim {

/// The exercises that trainee and instructor can choose from. What it returns stays where it is.
class ExerciseMenu {
 public:
  /// `loaded` is the one that waits, as Vary has made it; `catalogue` as LoadCatalogue sorts it.
  ExerciseMenu(const Scenario& loaded, std::vector<Scenario> catalogue);
  ExerciseMenu(const ExerciseMenu&) = delete;
  ExerciseMenu& operator=(const ExerciseMenu&) = delete;

  /// What the box's menu means: the `number`th exercise of a module (1..5) in the catalogue, from 1
  /// on. 0, and a number beyond the last, mean the loaded one if it belongs to that module, else
  /// the module's first; a module without any is free driving, which has no name and no steps.
  const Scenario& Choose(int module, int number) const;

  /// By name, in the catalogue and among what is loaded; nullptr if it is unknown.
  const Scenario* Find(std::string_view name) const;

  /// From now on this one waits.
  void Load(const Scenario& scenario) { loaded_ = scenario; }
  const Scenario& loaded() const { return loaded_; }

 private:
  Scenario loaded_;
  std::vector<Scenario> catalogue_;
  std::array<Scenario, 5> free_;  ///< driving, one a module
};

}  // namespace eod::sim
