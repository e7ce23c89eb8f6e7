#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/trials/simulated_trial.hpp"
#include "map_matcher/trials/trial_table.hpp"

namespace map_matcher::trials {
namespace {

grid::OccupancyGrid office() {
  simulation::OfficeBuildingOptions options;
  options.resolution = 0.05;
  return simulation::officeBuilding(options);
}

TrialOptions trialOptions() {
  TrialOptions options;
  options.map_update_interval = 1.0;
  return options;
}

simulation::DriveOptions driveOptions() {
  simulation::DriveOptions options;
  options.duration = 12.0;
  options.rate = 5.0;
  options.lidar.beams = 271;
  return options;
}

/// What a trial makes of a simulated drive.
std::vector<TrialQuery> queriesOf(const TrialOptions& options, const simulation::DriveOptions& drive) {
  const grid::OccupancyGrid map = office();
  Trial trial(map, options);
  simulation::DriveSimulation simulation(map, drive);
  while (const auto step = simulation.next()) {
    trial.add(trialStepOf(*step, simulation.lidarPoses()));
    for (const TrialDetections& detections : trialDetectionsOf(*step)) {
      trial.add(detections);
    }
  }
  return trial.matching().queries();
}

TEST(Trial, LocalizesARobotThatDrivesThroughAnOffice) {
  const std::vector<TrialQuery> queries = queriesOf(trialOptions(), driveOptions());

  ASSERT_GE(queries.size(), 4U);
  const TrialQuery& last = queries.back();
  ASSERT_TRUE(last.answer.matched()) << last.answer.reason;
  EXPECT_LT(last.robotError()->translation, 0.1);
  EXPECT_LT(evaluation::errorOf(*last.alignment(), *last.true_alignment).translation, 0.15);
  EXPECT_GT(last.travelled, 2.0);
  EXPECT_EQ(last.session, 0);
  EXPECT_EQ(last.session_age, last.time);
  EXPECT_LT(last.falsely_occupied, last.occupied / 10);
}

TEST(Trial, BeginsANewSessionWheneverTheIntervalIsOver) {
  TrialOptions options = trialOptions();
  options.restart_interval = 4.0;

  const std::vector<TrialQuery> queries = queriesOf(options, driveOptions());

  EXPECT_EQ(queries.back().session, 3);  // 0, 4, 8, 12 s
  EXPECT_EQ(queries.back().drive, 0);
  for (const TrialQuery& query : queries) {
    EXPECT_LT(query.session_age, 4.0);
    if (query.session_age == 0.0) {
      EXPECT_EQ(query.travelled, 0.0);
    }
    if (query.answer.matched() && query.travelled > 1.0) {
      EXPECT_LT(query.robotError()->translation, 0.2) << "at " << query.time << " s";
    }
  }
}

TEST(Trial, BeginsANewSessionWithEachDriveAsIfItWereTheFirst) {
  const grid::OccupancyGrid map = office();
  TrialOptions options = trialOptions();
  options.scrub = true;
  simulation::DriveOptions drive = driveOptions();
  drive.duration = 4.0;
  drive.pedestrians.density = 0.2;
  Trial trial(map, options);
  for (drive.seed = 1; drive.seed <= 2; ++drive.seed) {
    simulation::DriveSimulation simulation(map, drive);
    trial.beginDrive();
    while (const auto step = simulation.next()) {
      trial.add(trialStepOf(*step, simulation.lidarPoses()));
      for (const TrialDetections& detections : trialDetectionsOf(*step)) {
        trial.add(detections);
      }
    }
  }
  drive.seed = 2;
  const std::vector<TrialQuery> alone = queriesOf(options, drive);

  std::vector<TrialQuery> second;
  for (const TrialQuery& query : trial.matching().queries()) {
    ASSERT_LE(query.session, 1);
    EXPECT_EQ(query.drive, query.session);
    if (query.session == 1) {
      second.push_back(query);
    }
  }
  ASSERT_EQ(second.size(), alone.size());
  EXPECT_EQ(second.front().time, 0.0);
  EXPECT_EQ(second.back().travelled, alone.back().travelled);
  EXPECT_EQ(second.back().occupied, alone.back().occupied);
  EXPECT_EQ(second.back().answer.search.hit_cells, alone.back().answer.search.hit_cells);
}

TEST(Trial, ScrubsPeopleOutOfTheScans) {
  simulation::DriveOptions drive = driveOptions();
  drive.duration = 20.0;
  drive.pedestrians.density = 0.4;
  drive.pedestrians.standing_share = 1.0;
  TrialOptions options = trialOptions();
  const int original = queriesOf(options, drive).back().falsely_occupied;

  options.scrub = true;
  const int scrubbed = queriesOf(options, drive).back().falsely_occupied;

  EXPECT_LT(scrubbed, original);
}

TEST(Trial, IsNotChangedByScrubbingWhereNobodyIs) {
  TrialOptions options = trialOptions();
  const std::vector<TrialQuery> original = queriesOf(options, driveOptions());
  options.scrub = true;
  const std::vector<TrialQuery> scrubbed = queriesOf(options, driveOptions());

  ASSERT_EQ(original.size(), scrubbed.size());
  EXPECT_EQ(original.back().answer.search.matched_cells, scrubbed.back().answer.search.matched_cells);
  EXPECT_EQ(original.back().occupied, scrubbed.back().occupied);
}

TEST(Trial, RefusesOptionsOutOfRange) {
  TrialOptions options = trialOptions();
  options.scrubbing.max_removed_fraction = 2.0;

  EXPECT_THROW(Trial(office(), options), std::invalid_argument);
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream text(line + ",");
  for (std::string cell; std::getline(text, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

TEST(TrialTable, HasACellInEachRowForEachName) {
  const std::vector<TrialQuery> queries = queriesOf(trialOptions(), driveOptions());

  std::stringstream csv(toCsv(queries));
  std::string line;
  std::getline(csv, line);
  const std::vector<std::string> names = cellsOf(line);
  std::size_t num_rows = 0;
  for (; std::getline(csv, line); ++num_rows) {
    EXPECT_EQ(cellsOf(line).size(), names.size());
  }
  EXPECT_EQ(num_rows, queries.size());
  EXPECT_EQ(names.front(), "session");
}

TEST(TrialTable, LeavesEmptyWhatIsNotKnown) {
  TrialQuery query;
  query.time = 2.5;
  query.answer.status = belief::MatchStatus::kBelowAcceptanceRatio;

  const std::string csv = toCsv({query});

  const std::string row = csv.substr(csv.find('\n') + 1);
  EXPECT_EQ(row.rfind("0,2.5,0,0,below_acceptance_ratio,0,", 0), 0U) << row;
  EXPECT_NE(row.find(",,,,,,"), std::string::npos);
}

/// The cell of the only row of a table below a name.
std::string cellOf(const std::string& csv, const std::string& name) {
  std::stringstream lines(csv);
  std::string header;
  std::string row;
  std::getline(lines, header);
  std::getline(lines, row);
  const std::vector<std::string> names = cellsOf(header);
  const auto column = std::find(names.begin(), names.end(), name) - names.begin();
  return cellsOf(row).at(static_cast<std::size_t>(column));
}

TEST(TrialTable, TellsWhatTheExactSearchProved) {
  TrialQuery query;
  query.answer.search.certified = true;
  query.answer.search.hit_ratio = 0.75;
  query.answer.search.upper_bound = 0.8;
  query.answer.search.margin = 0.25;
  query.answer.nearby = {200, 10.0, 0.75, 90, 4.5, 0.5};
  query.answer.evidence = surroundingsEvidence(query.answer.nearby, {}, false);
  search::StageReport exact;
  exact.name = "exact";
  exact.initialization_time = 0.5;
  exact.rotation_expansion_time = 0.25;
  exact.depth_first_search_time = 2.0;
  query.answer.search.stages = {exact};

  const std::string csv = toCsv({query});

  EXPECT_EQ(cellOf(csv, "certified"), "1");
  EXPECT_EQ(cellOf(csv, "hit_ratio"), "0.75");
  EXPECT_EQ(cellOf(csv, "upper_bound"), "0.8");
  EXPECT_EQ(cellOf(csv, "margin"), "0.25");
  EXPECT_EQ(cellOf(csv, "nearby_cells"), "200");
  EXPECT_EQ(cellOf(csv, "nearby_ratio"), "0.75");
  EXPECT_EQ(cellOf(csv, "nearby_walls"), "90");
  EXPECT_EQ(cellOf(csv, "nearby_walls_ratio"), "0.5");
  EXPECT_EQ(cellOf(csv, "exact_time"), "2.75");
}

TEST(TrialTable, TellsHowFarOffACandidateIsThatIsNotBelieved) {
  TrialQuery query;
  query.answer.status = belief::MatchStatus::kAmbiguous;
  query.answer.search.found = true;
  query.answer.search.T_reference_session = {3.0, 4.0, 0.25};
  query.answer.search.session_centre = {1.0, 0.0};
  query.true_alignment = grid::Rigid2{};
  query.truth = grid::Rigid2{2.0, 0.0, 0.0};
  query.T_session_base = {2.0, 0.0, 0.0};

  const std::string csv = toCsv({query});

  EXPECT_EQ(cellOf(csv, "matched"), "0");
  EXPECT_EQ(cellOf(csv, "translation_error"), "");
  EXPECT_EQ(cellOf(csv, "candidate_x"), "3");
  EXPECT_EQ(cellOf(csv, "candidate_yaw"), "0.25");
  EXPECT_NEAR(std::stod(cellOf(csv, "candidate_error")),
              std::hypot(3.0 + 2.0 * std::cos(0.25) - 2.0, 4.0 + 2.0 * std::sin(0.25)), 1e-5);
  EXPECT_NEAR(std::stod(cellOf(csv, "candidate_rotation_error")), 0.25, 1e-9);
  EXPECT_NEAR(std::stod(cellOf(csv, "candidate_map_error")),
              std::hypot(3.0 + std::cos(0.25) - 1.0, 4.0 + std::sin(0.25)), 1e-5);
  EXPECT_NEAR(std::stod(cellOf(csv, "candidate_map_rotation_error")), 0.25, 1e-9);
}

TEST(TrialTable, HasNoCandidateWhereNoneWasFound) {
  TrialQuery query;
  query.true_alignment = grid::Rigid2{};
  query.truth = grid::Rigid2{};

  const std::string csv = toCsv({query});

  for (const char* name : {"candidate_x", "candidate_error", "candidate_rotation_error", "candidate_map_error"}) {
    EXPECT_EQ(cellOf(csv, name), "") << name;
  }
}

belief::Evidence evidence(const std::string& name, double value) {
  belief::Evidence piece;
  piece.name = name;
  piece.value = value;
  return piece;
}

TEST(TrialTable, HasAColumnForEachPieceOfEvidenceThatAnyAnswerHolds) {
  TrialQuery first;
  first.answer.evidence = {evidence("hit_ratio", 0.5), evidence("seen_through", 1.25)};
  TrialQuery second;
  second.answer.evidence = {evidence("other_building", std::numeric_limits<double>::quiet_NaN()),
                            evidence("hit_ratio", 0.75)};

  const std::string csv = toCsv({first, second});
  const std::string reversed = toCsv({second, first});

  EXPECT_EQ(cellOf(csv, "evidence.hit_ratio"), "0.5");
  EXPECT_EQ(cellOf(csv, "evidence.seen_through"), "1.25");
  EXPECT_EQ(cellOf(csv, "evidence.other_building"), "");
  EXPECT_EQ(cellOf(reversed, "evidence.hit_ratio"), "0.75");
  EXPECT_EQ(cellOf(reversed, "evidence.seen_through"), "");
  EXPECT_EQ(cellOf(reversed, "evidence.other_building"), "") << "nothing was measured";
}

TEST(TrialTable, TellsInNumbersWhateverAnAnswerDoes) {
  TrialQuery query;
  query.answer.search.hit_cells = 321;

  const std::string csv = toCsv({query});

  EXPECT_EQ(cellOf(csv, "answer.hit_cells"), "321");
  EXPECT_EQ(cellOf(csv, "answer.runner_up_proven"), "0");
  EXPECT_EQ(csv.find("answer.reason"), std::string::npos);
}

TEST(TrialTable, SaysNothingOfAnExactSearchThatDidNotRun) {
  const std::string csv = toCsv({TrialQuery{}});

  for (const char* name : {"certified", "hit_ratio", "upper_bound", "margin", "exact_time"}) {
    EXPECT_EQ(cellOf(csv, name), "") << name;
  }
}

TEST(TrialTable, IsTheSameForTheSameSeed) {
  const auto without_times = [](const std::string& csv) {
    std::string kept;
    std::stringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cellsOf(line);
    while (std::getline(lines, line)) {
      const std::vector<std::string> cells = cellsOf(line);
      for (std::size_t n = 0; n < cells.size(); ++n) {
        const bool is_duration = names[n].size() > 5 && names[n].substr(names[n].size() - 5) == "_time";
        kept += is_duration ? "" : cells[n] + ",";
      }
    }
    return kept;
  };
  simulation::DriveOptions drive = driveOptions();
  drive.pedestrians.density = 0.2;

  const std::string once = toCsv(queriesOf(trialOptions(), drive));
  const std::string again = toCsv(queriesOf(trialOptions(), drive));

  EXPECT_EQ(without_times(once), without_times(again));
}

}  // namespace
}  // namespace map_matcher::trials
