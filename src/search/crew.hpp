/// \file
/// Work shared out among threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace map_matcher {

/// Calls work(worker, n) for n = 0 ... count - 1, each once, in this order and on a thread for each worker, until a
/// call returns false. Whether none did.
template <typename Worker, typename Work>
bool shareOut(std::vector<Worker>& workers, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> complete{true};
  const auto run = [&](Worker& worker) {
    for (std::size_t n = next++; n < count && complete; n = next++) {
      if (!work(worker, n)) {
        complete = false;
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t thread = 1; thread < workers.size(); ++thread) {
    others.emplace_back(run, std::ref(workers[thread]));
  }
  run(workers.front());
  for (std::thread& other : others) {
    other.join();
  }
  return complete;
}

/// Calls work(n) for n = 0 ... count - 1, each once, on `threads` threads, at least one.
template <typename Work>
void forEachOnThreads(int threads, std::size_t count, const Work& work) {
  struct Worker {};
  std::vector<Worker> workers(static_cast<std::size_t>(std::max(1, threads)));
  shareOut(workers, count, [&work](Worker& /*worker*/, std::size_t n) {
    work(n);
    return true;
  });
}

}  // namespace map_matcher
