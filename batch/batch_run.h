#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "batch/drive_run.h"

namespace eod::batch {

struct BatchProgress {
  size_t planned = 0;      ///< runs of this shard
  size_t found = 0;        ///< of them done by an earlier batch, with the same inputs
  size_t driven = 0;       ///< by this one
  size_t unexpected = 0;   ///< of both
  double simulated_s = 0;  ///< by this one
  size_t done() const { return found + driven; }
};

/// Drives runs on several threads, and leaves a file for each in a folder as soon as it is done, so
/// that whatever ends a batch costs no more than the runs under way.
class BatchRun {
 public:
  /// `ground` and the pairs of `runs` must outlive the batch. Looks into `folder` (made if missing)
  /// for runs that are done. Throws std::runtime_error for a folder that cannot be made.
  BatchRun(const Ground& ground, std::vector<PlannedRun> runs, std::filesystem::path folder,
           const RunLimits& limits);
  ~BatchRun();
  BatchRun(const BatchRun&) = delete;
  BatchRun& operator=(const BatchRun&) = delete;

  void Start(int threads);
  /// Gives up the runs under way, and waits for the threads.
  void Stop();
  /// All is done, or something was thrown.
  bool is_finished() const;
  /// Waits for the threads. Throws what a run threw.
  void Join();

  BatchProgress progress() const;
  /// A line for each run that did not end as expected, since the last call.
  std::vector<std::string> TakeNews();
  /// Of all runs that are done, sorted.
  std::vector<RunRecord> records() const;

 private:
  void FindDoneRuns();
  void Work();
  void Add(const RunRecord& record, bool is_found);
  std::filesystem::path FileOf(const PlannedRun& run) const;

  const Ground& ground_;
  std::filesystem::path folder_;
  RunLimits limits_;
  std::vector<PlannedRun> to_do_;
  std::atomic<size_t> next_{0};
  std::atomic<size_t> working_{0};
  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;  ///< for all that follows
  BatchProgress progress_;
  std::vector<RunRecord> records_;
  std::vector<std::string> news_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;
};

}  // namespace eod::batch
