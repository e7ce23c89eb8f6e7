#include "map_matcher/work/latest_job_worker.hpp"

#include <exception>
#include <utility>

namespace map_matcher::work {
namespace {

/// What `call` threw; nothing when it returned.
template <typename Call>
std::optional<std::string> whatThrows(const Call& call) {
  try {
    call();
    return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown exception";
  }
}

}  // namespace

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

void LatestJobWorker::submit(Job job, JobFailureHandler on_failure) {
  // Destroyed after the lock is released: it is the caller's code.
  std::optional<Submitted> replaced(Submitted{std::move(job), std::move(on_failure)});
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.swap(replaced);
  }
  changed_.notify_one();
}

void LatestJobWorker::cancel() {
  std::optional<Submitted> dropped;  // destroyed after the lock is released: it is the caller's code
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.swap(dropped);
  stop_running_.requestStop();
}

std::optional<LatestJobWorker::Submitted> LatestJobWorker::nextJob() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return shutting_down_ || waiting_; });
  if (shutting_down_) {
    return std::nullopt;
  }
  stop_running_ = StopToken();
  return std::exchange(waiting_, std::nullopt);
}

void LatestJobWorker::run() {
  while (const std::optional<Submitted> submitted = nextJob()) {
    const std::optional<std::string> failure = whatThrows([&] { submitted->job(stop_running_); });
    if (failure) {
      tellFailure(*submitted, *failure);
    }
  }
}

void LatestJobWorker::tellFailure(const Submitted& submitted, const std::string& what) const {
  const std::optional<std::string> failure = whatThrows([&] {
    if (submitted.on_failure) {
      submitted.on_failure(what, stop_running_);
    }
  });
  whatThrows([&] { on_failure_(what); });  // who throws here has told whom it could
  if (failure) {
    whatThrows([&] { on_failure_("the handler of a failure: " + *failure); });
  }
}

}  // namespace map_matcher::work
