#include "batch/batch_run.h"

#include <utility>

#include <fmt/format.h>

#include "batch/text_file.h"

namespace eod::batch {

BatchRun::BatchRun(const Ground& ground, std::vector<PlannedRun> runs, std::filesystem::path folder,
                   const RunLimits& limits)
    : ground_(ground), folder_(std::move(folder)), limits_(limits), to_do_(std::move(runs)) {
  MakeFolder(folder_);
  progress_.planned = to_do_.size();
  FindDoneRuns();
}

BatchRun::~BatchRun() { Stop(); }

std::filesystem::path BatchRun::FileOf(const PlannedRun& run) const {
  return folder_ / (run.name() + ".json");
}

void BatchRun::FindDoneRuns() {
  std::erase_if(to_do_, [this](const PlannedRun& run) {
    if (!std::filesystem::exists(FileOf(run))) return false;
    const RunRecord record = ReadRecord(FileOf(run));
    // Of other inputs, or of another run of the same name: driven anew.
    if (record.inputs != InputsOf(ground_, run) || record.repetition != run.repetition)
      return false;
    Add(record, true);
    return true;
  });
}

void BatchRun::Start(int threads) {
  working_ = static_cast<size_t>(threads);
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { Work(); });
}

void BatchRun::Work() {
  try {
    for (size_t k = next_++; k < to_do_.size() && !stop_; k = next_++) {
      const std::optional<RunRecord> record = DriveRun(ground_, to_do_[k], limits_, stop_);
      if (!record) break;
      WriteText(FileOf(to_do_[k]), ToJson(*record));
      Add(*record, false);
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    stop_ = true;
  }
  --working_;
}

void BatchRun::Add(const RunRecord& record, bool is_found) {
  const std::lock_guard lock(mutex_);
  ++(is_found ? progress_.found : progress_.driven);
  if (!is_found) progress_.simulated_s += record.simulated_s;
  if (!record.passes()) {
    ++progress_.unexpected;
    news_.push_back(fmt::format("{} repetition {}: {}, expected {}{}{}", record.script,
                                record.repetition, TextOf(record.outcome), TextOf(record.expected),
                                record.why.empty() ? "" : ": ", record.why));
  }
  records_.push_back(record);
}

void BatchRun::Stop() {
  stop_ = true;
  threads_.clear();
}

bool BatchRun::is_finished() const { return working_ == 0; }

void BatchRun::Join() {
  threads_.clear();
  if (error_) std::rethrow_exception(error_);
}

BatchProgress BatchRun::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

std::vector<std::string> BatchRun::TakeNews() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

std::vector<RunRecord> BatchRun::records() const {
  const std::lock_guard lock(mutex_);
  std::vector<RunRecord> sorted = records_;
  SortRecords(sorted);
  return sorted;
}

}  // namespace eod::batch
