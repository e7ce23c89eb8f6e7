#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "map_matcher/localization/monte_carlo_localizer.hpp"
#include "support/program.hpp"
#include "support/source_dir.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;

const std::string kTools = std::filesystem::path(EVALUATE_DRIVE).parent_path().string();

class Evaluate : public testing::Test {
 protected:
  ProgramRun run(const std::string& arguments) const {
    return test::runProgram(test::sourceFile("scripts/evaluate"),
                            "--tools " + kTools + " --output " + output + " " + arguments);
  }

  std::string page() const {
    std::ifstream file(output + "/page/README.md");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const test::TemporaryDir dir;
  const std::string output = dir / "evaluation";
};

TEST_F(Evaluate, writesAPageWithTablesAndFigures) {
  const std::string arguments = "--quick --only crowd --data " + (dir / "nowhere");

  const ProgramRun done = run(arguments);

  ASSERT_EQ(done.exit_status, 0) << done.output;
  EXPECT_NE(done.output.find("4 runs, 0 failed"), std::string::npos) << done.output;
  EXPECT_NE(page().find("| time to the first match [s] | mean | 1.91 |"), std::string::npos) << page();
  EXPECT_EQ(page().find("nan"), std::string::npos) << page();
  for (const char* name : {"crowd.csv", "crowd_ratios.png", "crowd_times.png", "crowd_match.png"}) {
    EXPECT_TRUE(std::filesystem::exists(output + "/page/" + name)) << name;
  }

  const ProgramRun again = run(arguments);
  EXPECT_NE(again.output.find("4 runs, 4 of them done before"), std::string::npos) << again.output;
}

TEST_F(Evaluate, drawsThePageOfWhatWasDoneAndSaysWhatIsMissing) {
  const ProgramRun done = run("--quick --only crowd --draw-only --data " + (dir / "nowhere"));

  ASSERT_EQ(done.exit_status, 0) << done.output;
  EXPECT_NE(page().find("**4 runs were not done yet and are missing from the tables.**"), std::string::npos) << page();
}

TEST_F(Evaluate, tellsWhatBecameOfStartsAndLeavesThePlacesThatWereFound) {
  const ProgramRun done = run("--quick --only changed_world --data " + (dir / "nowhere"));

  ASSERT_EQ(done.exit_status, 0) << done.output;
  EXPECT_NE(page().find("| wrong poses announced, all experiments | 0 | 0 | - |"), std::string::npos) << page();
  EXPECT_NE(page().find("| scrubbed | 2 | "), std::string::npos) << page();
  EXPECT_EQ(page().find("nan"), std::string::npos) << page();
  std::ifstream starts(output + "/page/changed_world.csv");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(starts), {}, '\n'), 5) << "a header and four starts";
  std::ifstream candidates(output + "/candidates.csv");
  std::string header;
  std::getline(candidates, header);
  for (const char* name : {"experiment", "building", "seed", "candidate_right", "candidate_error", "evidence."}) {
    EXPECT_NE(header.find(name), std::string::npos) << name << " is not in " << header;
  }
}

TEST_F(Evaluate, doesNotMixParametersIntoThePageOfTheDefaults) {
  const ProgramRun done =
      test::runProgram(test::sourceFile("scripts/evaluate"), "--quick --only sessions --config " + (dir / "x.yaml"));

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("--config is given without --output"), std::string::npos) << done.output;
}

TEST_F(Evaluate, namesABagThatIsNotThere) {
  const ProgramRun done = run("--bag " + (dir / "drive.bag") + " --map " + (dir / "map.yaml"));

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("there is no file '" + (dir / "drive.bag")), std::string::npos) << done.output;
}

TEST_F(Evaluate, needsTheMapOfABag) {
  const ProgramRun done = run("--bag " + (dir / "drive.bag"));

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("--bag and --map are needed both"), std::string::npos) << done.output;
}

/// A short drive through a generated office.
class EvaluateABag : public Evaluate {
 protected:
  void SetUp() override {
    if (!localization::MonteCarloLocalizer::available()) {
      GTEST_SKIP() << "MRPT is not in this build";
    }
    ASSERT_EQ(test::runProgram(GENERATE_BUILDING, "--seed 1 --output " + map).exit_status, 0);
    const ProgramRun simulated =
        test::runProgram(SIMULATE_DRIVE, "--map " + map + " --seed 1 --duration 12 --beams 181 --bag " + bag);
    ASSERT_EQ(simulated.exit_status, 0) << simulated.output;
  }

  const std::string map = dir / "office.yaml";
  const std::string bag = dir / "drive.bag";
};

TEST_F(EvaluateABag, showsMatchesAndMonteCarloLocalization) {
  const ProgramRun done = run("--bag " + bag + " --map " + map + " --truth /ground_truth");

  ASSERT_EQ(done.exit_status, 0) << done.output;
  EXPECT_NE(page().find("## drive.bag in office.yaml"), std::string::npos) << page();
  EXPECT_NE(page().find("| position error, mean [m] | 0.0"), std::string::npos) << page();
  EXPECT_NE(page().find("Monte-Carlo localization: deviation below"), std::string::npos) << page();
  EXPECT_EQ(page().find("**"), std::string::npos) << page();
}

TEST_F(EvaluateABag, goesOnWithoutATruthThatCannotBeUsed) {
  const ProgramRun done = run("--bag " + bag + " --map " + map + " --truth /nowhere");

  EXPECT_EQ(done.exit_status, 1);
  EXPECT_NE(done.output.find("has no topic '/nowhere'"), std::string::npos) << done.output;
  EXPECT_NE(page().find("**Without truth**, since it cannot be used"), std::string::npos) << page();
  EXPECT_NE(page().find("| position error, mean [m] | - |"), std::string::npos) << page();
}

TEST_F(EvaluateABag, saysThatTheMapMayBeAnotherBuildings) {
  const std::string other = dir / "other.yaml";
  ASSERT_EQ(test::runProgram(GENERATE_BUILDING, "--seed 7 --output " + other).exit_status, 0);

  const ProgramRun done = run("--bag " + bag + " --map " + other + " --truth /ground_truth");

  EXPECT_NE(page().find("the map may be another building's"), std::string::npos) << page() << done.output;
}

TEST_F(EvaluateABag, replaysItWithTheMapperThatWasAskedFor) {
  const ProgramRun done =
      run("--bag " + bag + " --map " + map + " --truth /ground_truth --mapper session_mapper --rate 3");

  ASSERT_EQ(done.exit_status, 0) << done.output;
  EXPECT_NE(page().find("## drive.bag in office.yaml, replayed with session_mapper"), std::string::npos) << page();
  const std::string row = "| true poses | ";
  ASSERT_NE(page().find(row), std::string::npos) << page();
  EXPECT_GT(std::stoi(page().substr(page().find(row) + row.size())), 90) << "the bag has 181; a slow start misses some";
  EXPECT_NE(page().find("| translation error, mean [m] | 0.0"), std::string::npos) << page();
  EXPECT_TRUE(std::filesystem::exists(output + "/page/replay.png"));
}

TEST_F(EvaluateABag, tellsThatAMapperIsNotInstalled) {
  if (std::system("rospack find gmapping > /dev/null 2>&1") == 0) {
    GTEST_SKIP() << "slam_gmapping is installed";
  }

  const ProgramRun done = run("--bag " + bag + " --map " + map + " --truth /ground_truth --mapper gmapping");

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("slam_gmapping is not installed"), std::string::npos) << done.output;
}

TEST_F(EvaluateABag, needsTheTruthToReplayIt) {
  const ProgramRun done = run("--bag " + bag + " --map " + map + " --mapper gmapping");

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("--mapper is given without --truth"), std::string::npos) << done.output;
}

TEST_F(EvaluateABag, needsTheTruthToPutPeopleIntoIt) {
  const std::string arguments = "--bag " + bag + " --reference " + map + " --output " + (dir / "table.csv");

  const ProgramRun without = test::runProgram(EVALUATE_DRIVE, arguments + " --density 0.3");
  const ProgramRun with = test::runProgram(EVALUATE_DRIVE, arguments + " --density 0.3 --scrub --truth ground_truth");

  EXPECT_EQ(without.exit_status, 2);
  EXPECT_NE(without.output.find("--people or --density is given with --bag but without --truth"), std::string::npos)
      << without.output;
  EXPECT_EQ(with.exit_status, 0) << with.output;
}

TEST_F(EvaluateABag, namesABadParameterOfMonteCarloLocalization) {
  const std::string config = dir.write("monte_carlo.yaml", "laser_max_beams: 1\n");

  const ProgramRun done =
      test::runProgram(EVALUATE_DRIVE, "--bag " + bag + " --reference " + map + " --output " + (dir / "table.csv") +
                                           " --monte-carlo " + (dir / "mc.csv") + " --monte-carlo-config " + config);

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("laser_max_beams is 1, expected 2 to 10000"), std::string::npos) << done.output;
}

}  // namespace
}  // namespace map_matcher
