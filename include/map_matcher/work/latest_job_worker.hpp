/// \file
/// A thread that always works on the newest job.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::work {

/// Runs jobs one at a time on a thread of its own. A job that waits is replaced by a newer one; a job that runs goes on
/// until it ends or heeds its stop token. Every function is thread-safe; none but the destructor waits for a job.
class LatestJobWorker {
 public:
  /// A piece of work that returns soon after its token's stop was requested.
  using Job = std::function<void(const StopToken&)>;
  /// Told what a job threw. Called on the worker's thread; must not throw.
  using FailureHandler = std::function<void(const std::string& what)>;

  explicit LatestJobWorker(FailureHandler on_failure);

  /// Requests the running job to stop, drops the waiting one and joins the thread.
  ~LatestJobWorker();

  LatestJobWorker(const LatestJobWorker&) = delete;
  LatestJobWorker& operator=(const LatestJobWorker&) = delete;

  /// Runs `job` as soon as the thread is free, instead of a job that still waits.
  void submit(Job job);

  /// Requests the running job to stop and drops the waiting one.
  void cancel();

 private:
  void run();
  std::optional<Job> nextJob();

  FailureHandler on_failure_;
  std::mutex mutex_;  ///< Guards all below but the thread.
  std::condition_variable changed_;
  std::optional<Job> waiting_;
  StopToken stop_running_;  ///< Written by the worker's thread only.
  bool shutting_down_ = false;
  std::thread thread_;  ///< Last, so that it starts when all else is there.
};

}  // namespace map_matcher::work
