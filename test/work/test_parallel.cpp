#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "map_matcher/work/parallel.hpp"
#include "support/no_threads.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::work {
namespace {

struct Worker {
  std::vector<std::size_t> done;
};

TEST(ParallelWhile, DoesEachPieceOfWorkOnce) {
  for (const std::size_t threads : {1U, 2U, 5U}) {
    std::vector<Worker> workers(threads);

    EXPECT_TRUE(parallelWhile(workers, 1000, [](Worker& worker, std::size_t n) {
      worker.done.push_back(n);
      return true;
    }));

    std::array<int, 1000> times{};
    for (const Worker& worker : workers) {
      EXPECT_TRUE(std::is_sorted(worker.done.begin(), worker.done.end()));
      for (const std::size_t n : worker.done) {
        ++times[n];
      }
    }
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), 1000);
  }
}

TEST(ParallelWhile, BeginsNothingMoreOnceACallReturnedFalse) {
  std::vector<Worker> workers(1);

  EXPECT_FALSE(parallelWhile(workers, 10, [](Worker& worker, std::size_t n) {
    worker.done.push_back(n);
    return n < 3;
  }));

  EXPECT_EQ(workers.front().done, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(ParallelWhile, ThrowsWhatAnyThreadThrewOnceAllHaveEnded) {
  const std::thread::id caller = std::this_thread::get_id();
  std::promise<void> throwing;
  std::atomic<int> at_work{0};
  std::vector<Worker> workers(2);

  const std::string text = test::thrownText<std::runtime_error>([&] {
    parallelWhile(workers, 2, [&](Worker&, std::size_t) {
      ++at_work;
      if (std::this_thread::get_id() == caller) {
        throwing.get_future().wait();
      } else {
        --at_work;
        throwing.set_value();
        throw std::runtime_error("out of order");
      }
      --at_work;
      return true;
    });
  });

  EXPECT_EQ(text, "out of order");
  EXPECT_EQ(at_work, 0);
}

TEST(ParallelWhile, ThrowsWhatItsOwnThreadThrewOnceAllHaveEnded) {
  const std::thread::id caller = std::this_thread::get_id();
  std::promise<void> throwing;
  std::atomic<int> at_work{0};
  std::vector<Worker> workers(2);

  const std::string text = test::thrownText<std::runtime_error>([&] {
    parallelWhile(workers, 2, [&](Worker&, std::size_t) {
      if (std::this_thread::get_id() == caller) {
        throwing.set_value();
        throw std::runtime_error("out of order");
      }
      ++at_work;
      throwing.get_future().wait();
      --at_work;
      return true;
    });
  });

  EXPECT_EQ(text, "out of order");
  EXPECT_EQ(at_work, 0);
}

TEST(ParallelWhile, SaysThatThreadsCannotBeStarted) {
  const test::NoThreads no_threads;
  std::vector<Worker> workers(2);

  EXPECT_THROW(parallelWhile(workers, 2, [](Worker&, std::size_t) { return true; }), std::system_error);
}

TEST(JoinedThreads, AreJoinedWhenOneMoreCannotBeStarted) {
  std::promise<void> refused;
  std::atomic<bool> ended{false};

  EXPECT_THROW(
      {
        JoinedThreads threads;
        threads.start([&] {
          refused.get_future().wait();
          ended = true;
        });
        const test::NoThreads no_threads;
        try {
          threads.start([] {});
        } catch (...) {
          refused.set_value();
          throw;
        }
      },
      std::system_error);

  EXPECT_TRUE(ended);
}

TEST(ParallelFor, DoesEachPieceOfWorkOnceAndThrowsWhatAThreadThrew) {
  for (const int threads : {-1, 1, 3}) {
    std::array<std::atomic<int>, 100> times{};

    parallelFor(threads, times.size(), [&](std::size_t n) { ++times[n]; });

    for (const std::atomic<int>& time : times) {
      EXPECT_EQ(time, 1);
    }
    EXPECT_EQ(test::thrownText<std::runtime_error>([&] {
                parallelFor(threads, 10, [](std::size_t n) {
                  if (n == 7) {
                    throw std::runtime_error("number 7");
                  }
                });
              }),
              "number 7");
  }
}

}  // namespace
}  // namespace map_matcher::work
