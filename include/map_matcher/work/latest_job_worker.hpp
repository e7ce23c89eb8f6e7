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
  /// Told what a job threw, on the worker's thread. The worker goes on even if the handler throws.
  using FailureHandler = std::function<void(const std::string& what)>;
  /// Told what a job threw by whoever submitted it, with the token that the job had: nobody may want the answer any
  /// more. On the worker's thread.
  using JobFailureHandler = std::function<void(const std::string& what, const StopToken& stop)>;

  /// `on_failure` is told what any job threw, and what the handler of a job threw.
  explicit LatestJobWorker(FailureHandler on_failure);

  /// Requests the running job to stop, drops the waiting one and joins the thread.
  ~LatestJobWorker();

  LatestJobWorker(const LatestJobWorker&) = delete;
  LatestJobWorker& operator=(const LatestJobWorker&) = delete;

  /// Runs `job` as soon as the thread is free, instead of a job that still waits. `on_failure`, if there is one, is
  /// told what this job threw, before the constructor's and before the next job runs; it is destroyed with the job.
  void submit(Job job, JobFailureHandler on_failure = nullptr);

  /// Requests the running job to stop and drops the waiting one.
  void cancel();

 private:
  struct Submitted {
    Job job;
    JobFailureHandler on_failure;
  };

  void run();
  std::optional<Submitted> nextJob();
  void tellFailure(const Submitted& submitted, const std::string& what) const;

  FailureHandler on_failure_;
  std::mutex mutex_;  ///< Guards all below but the thread.
  std::condition_variable changed_;
  std::optional<Submitted> waiting_;
  StopToken stop_running_;  ///< Written by the worker's thread only.
  bool shutting_down_ = false;
  std::thread thread_;  ///< Last, so that it starts when all else is there.
};

}  // namespace map_matcher::work
