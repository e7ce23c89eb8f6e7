#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "map_matcher/trials/monte_carlo_trial.hpp"
#include "map_matcher/trials/simulated_trial.hpp"
#include "support/drives.hpp"

namespace map_matcher::trials {
namespace {

simulation::DriveOptions driveOptions() {
  simulation::DriveOptions options = test::shortDrive(1);
  options.duration = 12.0;
  options.rate = 5.0;
  return options;
}

/// A trial of a drive through two rooms, and the filter beside it.
struct Compared {
  explicit Compared(double restart_interval) {
    const grid::OccupancyGrid map = test::twoRooms();
    TrialOptions options;
    options.map_update_interval = 1.0;
    options.restart_interval = restart_interval;
    localization::MonteCarloOptions filter;
    filter.max_particles = 2000;
    trial.emplace(map, options);
    MonteCarloTrial monte_carlo(map, filter);
    trial->onMoment([&monte_carlo](const TrialMoment& moment) { monte_carlo.add(moment); });
    simulation::DriveSimulation simulation(map, driveOptions());
    while (const auto step = simulation.next()) {
      trial->add(trialStepOf(*step, simulation.lidarPoses()));
    }
    rows = monte_carlo.rows();
  }

  std::optional<Trial> trial;
  std::vector<MonteCarloRow> rows;
};

class MonteCarloBesideATrial : public testing::Test {
 protected:
  void SetUp() override {
    if (!localization::MonteCarloLocalizer::available()) {
      GTEST_SKIP() << "MRPT is not in this build";
    }
  }
};

TEST_F(MonteCarloBesideATrial, HasARowForEachMapQuery) {
  const Compared compared(5.0);

  const std::vector<TrialQuery>& queries = compared.trial->matching().queries();
  ASSERT_EQ(compared.rows.size(), queries.size());
  ASSERT_GT(queries.size(), 4U);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_EQ(compared.rows[i].time, queries[i].time);
    EXPECT_EQ(compared.rows[i].session, queries[i].session);
    EXPECT_EQ(compared.rows[i].session_age, queries[i].session_age);
    EXPECT_EQ(compared.rows[i].travelled, queries[i].travelled);
    EXPECT_EQ(compared.rows[i].truth->x, queries[i].truth->x);
  }
}

TEST_F(MonteCarloBesideATrial, StartsWithoutAPoseInEachSession) {
  const Compared compared(5.0);

  int sessions = 0;
  for (std::size_t i = 0; i < compared.rows.size(); ++i) {
    if (compared.rows[i].session_age == 0.0) {
      ++sessions;
      EXPECT_EQ(compared.rows[i].estimate.particles, 2000);
      EXPECT_EQ(compared.rows[i].updates, 1);
      ASSERT_TRUE(compared.rows[i].update_time.has_value());
      EXPECT_GE(*compared.rows[i].update_time, 0.0);
    }
  }
  EXPECT_EQ(sessions, 3);
}

TEST_F(MonteCarloBesideATrial, WritesACellForEachName) {
  std::stringstream csv(toCsv(Compared(0.0).rows));
  std::string header;
  std::getline(csv, header);
  const auto commas = std::count(header.begin(), header.end(), ',');
  int num_rows = 0;
  for (std::string line; std::getline(csv, line); ++num_rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
  }
  EXPECT_GT(num_rows, 4);
  EXPECT_EQ(header.rfind("session,time,session_age,travelled,estimate_x,", 0), 0U);
}

TEST(MonteCarloTrial, LeavesEmptyWhatIsNotKnown) {
  MonteCarloRow row;
  row.estimate.particles = 7;

  const std::string csv = toCsv({row});

  EXPECT_EQ(csv.substr(csv.find('\n') + 1), "0,0,0,0,0,0,0,0,0,7,0,,,,,,\n");
}

}  // namespace
}  // namespace map_matcher::trials
