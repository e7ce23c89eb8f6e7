#include "map_matcher/work/latest_job_worker.hpp"

#include <exception>
#include <utility>

namespace map_matcher::work {

LatestJobWorker::LatestJobWorker(FailureHandler on_failure)
    : on_failure_(std::move(on_failure)), thread_([this] { run(); }) {}

LatestJobWorker::~LatestJobWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shutting_down_ = true;
  }
  cancel();
  changed_.notify_one();
  thread_.join();
}

void LatestJobWorker::submit(Job job) {
  std::optional<Job> replaced(std::move(job));  // destroyed after the lock is released: it is the caller's code
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.swap(replaced);
  }
  changed_.notify_one();
}

void LatestJobWorker::cancel() {
  std::optional<Job> dropped;  // destroyed after the lock is released: it is the caller's code
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.swap(dropped);
  stop_running_.requestStop();
}

std::optional<LatestJobWorker::Job> LatestJobWorker::nextJob() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return shutting_down_ || waiting_; });
  if (shutting_down_) {
    return std::nullopt;
  }
  stop_running_ = StopToken();
  return std::exchange(waiting_, std::nullopt);
}

void LatestJobWorker::run() {
  while (const std::optional<Job> job = nextJob()) {
    try {
      (*job)(stop_running_);
    } catch (const std::exception& error) {
      on_failure_(error.what());
    } catch (...) {
      on_failure_("unknown exception");
    }
  }
}

}  // namespace map_matcher::work
