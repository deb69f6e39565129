#pragma once

#include <filesystem>
#include <memory>

#include <CLI/App.hpp>

namespace eod::batch {

/// `batch` and `merge` of eod-sim.
class BatchCommands {
 public:
  /// Adds the subcommands to `app`.
  explicit BatchCommands(CLI::App& app);
  ~BatchCommands();

  /// One of them was given.
  bool is_asked() const;
  /// Runs the one that was given. Throws std::runtime_error if a run did not end as expected, if
  /// the batch was interrupted, and what reading and writing throw.
  void Run() const;

 private:
  struct Options;
  std::unique_ptr<Options> options_;
};

}  // namespace eod::batch
