#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/work/latest_job_worker.hpp"

namespace map_matcher::work {
namespace {

constexpr std::chrono::seconds kDeadline{10};

void ignoreFailure(const std::string&) {}

/// Runs until its stop is requested; tells when it began and whether it was stopped before the deadline.
class UntilStopped {
 public:
  LatestJobWorker::Job job() {
    return [this](const StopToken& stop) {
      began_.set_value();
      const auto deadline = std::chrono::steady_clock::now() + kDeadline;
      while (!stop.stopRequested() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::yield();
      }
      stopped_.set_value(stop.stopRequested());
    };
  }

  bool began() { return began_.get_future().wait_for(kDeadline) == std::future_status::ready; }
  bool stopped() { return stopped_.get_future().get(); }

 private:
  std::promise<void> began_;
  std::promise<bool> stopped_;
};

/// Submits a job and waits until it ran.
bool runsJob(LatestJobWorker& worker) {
  const auto done = std::make_shared<std::promise<void>>();
  std::future<void> future = done->get_future();
  worker.submit([done](const StopToken&) { done->set_value(); });
  return future.wait_for(kDeadline) == std::future_status::ready;
}

TEST(LatestJobWorker, RunsAJobOnAnotherThread) {
  LatestJobWorker worker(ignoreFailure);
  std::promise<std::thread::id> thread;

  worker.submit([&](const StopToken&) { thread.set_value(std::this_thread::get_id()); });

  EXPECT_NE(thread.get_future().get(), std::this_thread::get_id());
}

TEST(LatestJobWorker, RunsOnlyTheNewestOfTheJobsThatWait) {
  std::vector<int> ran;
  std::promise<void> release;
  std::promise<void> began;
  std::promise<void> done;
  LatestJobWorker worker(ignoreFailure);
  worker.submit([&](const StopToken&) {
    began.set_value();
    release.get_future().wait();
  });
  began.get_future().wait();

  worker.submit([&](const StopToken&) { ran.push_back(1); });
  worker.submit([&](const StopToken&) { ran.push_back(2); });
  worker.submit([&](const StopToken&) {
    ran.push_back(3);
    done.set_value();
  });
  release.set_value();
  done.get_future().wait();

  EXPECT_EQ(ran, std::vector<int>{3});
}

TEST(LatestJobWorker, DestroysAReplacedJobSoThatItsPromisesBreak) {
  UntilStopped running;
  LatestJobWorker worker(ignoreFailure);
  worker.submit(running.job());
  ASSERT_TRUE(running.began());
  auto promise = std::make_shared<std::promise<void>>();
  std::future<void> answer = promise->get_future();
  worker.submit([promise = std::move(promise)](const StopToken&) { promise->set_value(); });

  worker.submit([](const StopToken&) {});

  EXPECT_THROW(answer.get(), std::future_error);
  worker.cancel();
}

TEST(LatestJobWorker, ANewJobDoesNotStopTheRunningOne) {
  std::promise<bool> stopped;
  std::promise<void> began;
  std::promise<void> release;
  LatestJobWorker worker(ignoreFailure);
  worker.submit([&](const StopToken& stop) {
    began.set_value();
    release.get_future().wait();
    stopped.set_value(stop.stopRequested());
  });
  began.get_future().wait();

  worker.submit([](const StopToken&) {});
  release.set_value();

  EXPECT_FALSE(stopped.get_future().get());
}

TEST(LatestJobWorker, CancelStopsTheRunningJobAndDropsTheWaitingOne) {
  UntilStopped running;
  bool waiting_ran = false;
  LatestJobWorker worker(ignoreFailure);
  worker.submit(running.job());
  ASSERT_TRUE(running.began());
  worker.submit([&](const StopToken&) { waiting_ran = true; });

  worker.cancel();

  EXPECT_TRUE(running.stopped());
  EXPECT_TRUE(runsJob(worker));
  EXPECT_FALSE(waiting_ran);
}

TEST(LatestJobWorker, AJobAfterACancelIsNotStopped) {
  UntilStopped running;
  LatestJobWorker worker(ignoreFailure);
  worker.submit(running.job());
  ASSERT_TRUE(running.began());
  worker.cancel();
  std::promise<bool> stopped;

  worker.submit([&](const StopToken& stop) { stopped.set_value(stop.stopRequested()); });

  EXPECT_FALSE(stopped.get_future().get());
}

TEST(LatestJobWorker, TellsWhatAJobThrewAndRunsTheNextOne) {
  std::promise<std::string> failure;
  LatestJobWorker worker([&](const std::string& what) { failure.set_value(what); });

  worker.submit([](const StopToken&) { throw std::runtime_error("no such map"); });

  EXPECT_EQ(failure.get_future().get(), "no such map");
  EXPECT_TRUE(runsJob(worker));
}

TEST(LatestJobWorker, SurvivesAnExceptionThatIsNotOfTheStandardLibrary) {
  std::promise<std::string> failure;
  LatestJobWorker worker([&](const std::string& what) { failure.set_value(what); });

  worker.submit([](const StopToken&) { throw 42; });

  EXPECT_EQ(failure.get_future().get(), "unknown exception");
  EXPECT_TRUE(runsJob(worker));
}

TEST(LatestJobWorker, TellsTheSubmitterWhatItsJobThrewBeforeAllElse) {
  std::string told;
  std::promise<std::string> all;
  LatestJobWorker worker([&](const std::string& what) { all.set_value(told + "; " + what); });

  worker.submit([](const StopToken&) { throw std::runtime_error("no memory"); },
                [&](const std::string& what, const StopToken& stop) {
                  told = what + (stop.stopRequested() ? ", stopped" : " for the submitter");
                });

  EXPECT_EQ(all.get_future().get(), "no memory for the submitter; no memory");
}

TEST(LatestJobWorker, TellsTheSubmitterOfNoOtherJobsFailure) {
  int told = 0;
  std::promise<std::string> failure;
  LatestJobWorker worker([&](const std::string& what) { failure.set_value(what); });
  const auto count = [&](const std::string&, const StopToken&) { ++told; };
  std::promise<void> done;
  worker.submit([&](const StopToken&) { done.set_value(); }, count);
  done.get_future().wait();

  worker.submit([](const StopToken&) { throw std::runtime_error("of another"); });

  EXPECT_EQ(failure.get_future().get(), "of another");
  EXPECT_EQ(told, 0);
}

TEST(LatestJobWorker, TellsTheSubmitterThatItsJobWasStoppedBeforeItThrew) {
  std::promise<void> began;
  std::promise<bool> stopped;
  LatestJobWorker worker(ignoreFailure);
  worker.submit(
      [&](const StopToken& stop) {
        began.set_value();
        while (!stop.stopRequested()) {
          std::this_thread::yield();
        }
        throw std::runtime_error("too late");
      },
      [&](const std::string&, const StopToken& stop) { stopped.set_value(stop.stopRequested()); });
  began.get_future().wait();

  worker.cancel();

  EXPECT_TRUE(stopped.get_future().get());
}

TEST(LatestJobWorker, GoesOnAndEndsWhenHandlersThrow) {
  std::vector<std::string> told;
  std::promise<void> told_both;
  bool ran = false;
  {
    LatestJobWorker worker([&](const std::string& what) {
      told.push_back(what);
      if (told.size() == 2) {
        told_both.set_value();
      }
      throw std::runtime_error("from the handler of all");
    });
    worker.submit([](const StopToken&) { throw std::runtime_error("no memory"); },
                  [](const std::string&, const StopToken&) { throw std::runtime_error("no memory left at all"); });
    told_both.get_future().wait();
    ran = runsJob(worker);
  }

  EXPECT_TRUE(ran);
  EXPECT_EQ(told, (std::vector<std::string>{"no memory", "the handler of a failure: no memory left at all"}));
}

TEST(LatestJobWorker, DestructionStopsTheRunningJobAndWaitsForIt) {
  UntilStopped running;
  bool waiting_ran = false;
  {
    LatestJobWorker worker(ignoreFailure);
    worker.submit(running.job());
    ASSERT_TRUE(running.began());
    worker.submit([&](const StopToken&) { waiting_ran = true; });
  }

  EXPECT_TRUE(running.stopped());
  EXPECT_FALSE(waiting_ran);
}

}  // namespace
}  // namespace map_matcher::work
