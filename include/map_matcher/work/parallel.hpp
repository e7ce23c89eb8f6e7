/// \file
/// Loops on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace map_matcher::work {

/// Threads that are joined when they leave their scope, by an exception, too.
class JoinedThreads {
 public:
  JoinedThreads() = default;
  JoinedThreads(const JoinedThreads&) = delete;
  JoinedThreads& operator=(const JoinedThreads&) = delete;
  ~JoinedThreads() {
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }

  /// Calls work() on a thread of its own. Throws std::system_error when none can be started.
  template <typename Work>
  void start(Work&& work) {
    threads_.emplace_back(std::forward<Work>(work));
  }

 private:
  std::vector<std::thread> threads_;
};

/// The first of the exceptions that several threads threw. Thread-safe.
class FirstException {
 public:
  /// Keeps the exception that is being handled, unless there was one before.
  void keepCurrent() noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!first_) {
      first_ = std::current_exception();
    }
  }

  void rethrowIfAny() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (first_) {
      std::rethrow_exception(first_);
    }
  }

 private:
  mutable std::mutex mutex_;
  std::exception_ptr first_;
};

/// Calls work(worker, n) for n = 0 ... count - 1, each at most once and on a thread for each worker, until a call
/// returns false or throws. Whether none did. They are begun in this order, but a thread may come too late to begin n
/// when a later one has been begun. Throws what the first of the calls threw, or std::system_error when a thread cannot
/// be started, once all threads have ended. There is at least one worker.
template <typename Worker, typename Work>
bool parallelWhile(std::vector<Worker>& workers, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> goes_on{true};
  FirstException exception;
  const auto guarded = [&](const auto& part) {
    try {
      part();
    } catch (...) {
      exception.keepCurrent();
      goes_on = false;
    }
  };
  const auto run = [&](Worker& worker) {
    guarded([&] {
      for (std::size_t n = next++; n < count && goes_on; n = next++) {
        if (!work(worker, n)) {
          goes_on = false;
        }
      }
    });
  };
  {
    JoinedThreads others;
    guarded([&] {
      for (std::size_t thread = 1; thread < workers.size(); ++thread) {
        others.start([&run, &worker = workers[thread]] { run(worker); });
      }
    });
    run(workers.front());
  }
  exception.rethrowIfAny();
  return goes_on;
}

/// Calls work(n) for n = 0 ... count - 1, each once, on `threads` threads, at least one. Throws as parallelWhile()
/// does, and leaves out calls then.
template <typename Work>
void parallelFor(int threads, std::size_t count, const Work& work) {
  struct Worker {};
  std::vector<Worker> workers(static_cast<std::size_t>(std::max(1, threads)));
  parallelWhile(workers, count, [&work](Worker& /*worker*/, std::size_t n) {
    work(n);
    return true;
  });
}

}  // namespace map_matcher::work
