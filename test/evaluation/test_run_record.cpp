#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "map_matcher/evaluation/run_record.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> linesOf(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

const RunRow kLost{{1000.25, {1.0, 2.0, 0.5}, std::nullopt}, std::nullopt, std::nullopt};
const RunRow kLocalized{{1000.5, {1.0, 2.0, 0.5}, grid::Rigid2{1.0, 2.25, 0.25}}, grid::Rigid2{10.0, -20.0, 3.0}, 0.75};

TEST(RunRecord, WritesEachMomentAsItComesAndLeavesEmptyWhatIsNotKnown) {
  const test::TemporaryDir dir;
  RunRecord record(dir / "run.csv");

  record.add(kLost);
  record.add(kLocalized);

  EXPECT_THAT(linesOf(dir / "run.csv.partial"),
              ElementsAre("time,truth_x,truth_y,truth_yaw,estimate_x,estimate_y,estimate_yaw,translation_error,"
                          "rotation_error,session_x,session_y,session_yaw,ratio",
                          "1000.25,1,2,0.5,,,,,,,,,", "1000.5,1,2,0.5,1,2.25,0.25,0.25,0.25,10,-20,3,0.75"));
}

TEST(RunRecord, ReplacesTheFileOfAnEarlierRunOnlyWhenItIsComplete) {
  const test::TemporaryDir dir;
  dir.write("run.csv", "old");
  { RunRecord given_up(dir / "run.csv"); }
  EXPECT_THAT(linesOf(dir / "run.csv"), ElementsAre("old"));
  RunRecord record(dir / "run.csv");
  record.add(kLost);

  record.complete();

  EXPECT_EQ(linesOf(dir / "run.csv").size(), 2U);
  EXPECT_THAT(linesOf(dir / "run.csv.partial"), ElementsAre());
}

TEST(RunRecord, KeepsTheSamplesAlsoWithoutAFile) {
  RunRecord record;

  record.add(kLost);
  record.add(kLocalized);

  ASSERT_EQ(record.samples().size(), 2U);
  EXPECT_FALSE(record.samples()[0].estimate);
  EXPECT_TRUE(record.samples()[1].estimate);
}

TEST(RunRecord, NamesAFileThatCannotBeWritten) {
  const test::TemporaryDir dir;
  const std::string path = dir / "missing/run.csv";
  try {
    const RunRecord record(path);
    FAIL();
  } catch (const RunRecordError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path));
  }
  EXPECT_THROW(writeSummary({}, path), RunRecordError);
}

TEST(RunSummary, HasTheFigures) {
  const test::TemporaryDir dir;

  writeSummary(evaluateTrajectory({kLost.sample, kLocalized.sample}), dir / "summary.json");

  const auto json = nlohmann::json::parse(std::ifstream(dir / "summary.json"));
  EXPECT_EQ(json["samples"], 2);
  EXPECT_EQ(json["estimates"], 1);
  EXPECT_EQ(json["time_to_first_estimate"], 0.25);
  EXPECT_EQ(json["worst_time"], 1000.5);
  EXPECT_EQ(json["translation"]["mean"], 0.25);
  EXPECT_EQ(json["translation"]["worst"], 0.25);
  EXPECT_EQ(json["rotation"]["rms"], 0.25);
  EXPECT_EQ(json["rotation"]["standard_deviation"], 0.0);
}

TEST(RunSummary, IsNullWhereThereWasNoEstimate) {
  const auto json = nlohmann::json::parse(toJson(evaluateTrajectory({kLost.sample})));

  EXPECT_TRUE(json["translation"].is_null());
  EXPECT_TRUE(json["time_to_first_estimate"].is_null());
}

}  // namespace
}  // namespace map_matcher::evaluation
