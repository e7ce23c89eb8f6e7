#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;
using Row = std::vector<std::string>;

std::vector<Row> rowsOf(const std::string& path) {
  std::ifstream file(path);
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    Row row;
    std::stringstream text(line + ",");
    for (std::string cell; std::getline(text, cell, ',');) {
      row.push_back(cell);
    }
    rows.push_back(row);
  }
  return rows;
}

/// The cells of all rows below a name.
std::vector<std::string> column(const std::vector<Row>& rows, const std::string& name) {
  for (std::size_t k = 0; k < rows.front().size(); ++k) {
    if (rows.front()[k] == name) {
      std::vector<std::string> cells;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        cells.push_back(rows[i].at(k));
      }
      return cells;
    }
  }
  ADD_FAILURE() << "no column " << name;
  return {};
}

class EvaluateDrive : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramRun run = test::runProgram(GENERATE_BUILDING, "--resolution 0.1 --output " + map);
    ASSERT_EQ(run.exit_status, 0) << run.output;
    dir.write("mapper.yaml", "delta: 0.1\nmap_update_interval: 1.0\n");
  }

  /// The table of short drives through the office.
  std::vector<Row> evaluate(const std::string& arguments, double duration = 3.0) const {
    const ProgramRun run =
        test::runProgram(EVALUATE_DRIVE, "--map " + map + " --mapper-config " + (dir / "mapper.yaml") + " --duration " +
                                             std::to_string(duration) + " --rate 5 " + "--beams 181 --output " + table +
                                             " " + arguments);
    EXPECT_EQ(run.exit_status, 0) << run.output;
    return rowsOf(table);
  }

  const test::TemporaryDir dir;
  const std::string map = dir / "office.yaml";
  const std::string table = dir / "table.csv";
};

TEST_F(EvaluateDrive, startsAtARandomPlaceOfEachSeedThatFollows) {
  const std::vector<Row> three = evaluate("--seed 5 --starts 3");
  const std::vector<Row> second = evaluate("--seed 6");

  const std::vector<std::string> sessions = column(three, "session");
  EXPECT_EQ(sessions.front(), "0");
  EXPECT_EQ(sessions.back(), "2");
  std::vector<std::string> poses;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (sessions[i] == "1") {
      poses.push_back(column(three, "truth_x")[i] + " " + column(three, "candidate_x")[i]);
    }
  }
  ASSERT_EQ(poses.size(), second.size() - 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(poses[i], column(second, "truth_x")[i] + " " + column(second, "candidate_x")[i]);
  }
}

TEST_F(EvaluateDrive, knowsNoTruthInAStrangersMap) {
  const std::string other = dir / "other.yaml";
  ASSERT_EQ(test::runProgram(GENERATE_BUILDING, "--seed 2 --resolution 0.1 --output " + other).exit_status, 0);

  const std::vector<Row> rows = evaluate("--stranger --reference " + other);

  ASSERT_GT(rows.size(), 1U);
  EXPECT_NE(column(rows, "candidate_x").back(), "");
  EXPECT_EQ(column(rows, "truth_x").back(), "");
  EXPECT_EQ(column(rows, "candidate_error").back(), "");
}

TEST_F(EvaluateDrive, matchesNothingInAMapThatLacksAllOfIt) {
  const std::vector<Row> rows = evaluate("--missing -1 -1 56 16");

  ASSERT_GT(rows.size(), 1U);
  EXPECT_EQ(column(rows, "status").back(), "empty_reference");
  EXPECT_NE(column(rows, "truth_x").back(), "");
}

TEST_F(EvaluateDrive, staysInTheAreaThatIsAskedFor) {
  const std::vector<Row> rows = evaluate("--area 20 0 35 15 --starts 4", 0.1);

  ASSERT_EQ(rows.size(), 5U);
  for (const std::string& x : column(rows, "truth_x")) {
    EXPECT_GE(std::stod(x), 20.0);
    EXPECT_LE(std::stod(x), 35.0);
  }
}

TEST_F(EvaluateDrive, refusesWhatIsNoPartOfAMap) {
  const ProgramRun run =
      test::runProgram(EVALUATE_DRIVE, "--map " + map + " --output " + table + " --missing 5 0 4 10");

  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.output.find("--missing is empty, expected x_min y_min x_max y_max"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace map_matcher
