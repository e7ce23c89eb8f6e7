// The program as other programs use it: exit status, JSON keys, clean standard output.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>

#include "map_matcher/grid/map_file.hpp"
#include "support/random_maps.hpp"
#include "support/source_dir.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

class MatchMaps : public testing::Test {
 protected:
  struct Run {
    int status = -1;
    std::string output;
    std::string errors;
  };

  void SetUp() override {
    std::mt19937 random(3);
    const grid::OccupancyGrid building = test::randomBuilding(random, 24.0, 12.0, 0.05);
    grid::saveMap(building, file("reference.yaml"));
    grid::saveMap(test::cutSession(building, {11.0, 6.0}, 8.0, truth_, 0.05), file("session.yaml"));
  }

  std::string file(const std::string& name) const { return dir_ / name; }

  Run run(const std::string& arguments) const {
    const std::string command =
        std::string("'") + MATCH_MAPS + "' " + arguments + " > '" + file("output") + "' 2> '" + file("errors") + "'";
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    return {WEXITSTATUS(status), contentOf(file("output")), contentOf(file("errors"))};
  }

  std::string maps() const {
    return "--reference '" + file("reference.yaml") + "' --session '" + file("session.yaml") + "'";
  }

  test::TemporaryDir dir_;
  const grid::Rigid2 truth_{2.0, -1.0, 0.8};
};

TEST_F(MatchMaps, PrintsNothingButTheResultAsJsonWhenAskedTo) {
  const Run match = run(maps() + " --json -");

  ASSERT_EQ(match.status, 0) << match.errors;
  const auto json = nlohmann::json::parse(match.output);
  EXPECT_EQ(json.at("status"), "matched");
  EXPECT_NEAR(json.at("transform").at("x"), truth_.x, 0.1);
  EXPECT_NEAR(json.at("transform").at("y"), truth_.y, 0.1);
  EXPECT_NEAR(json.at("transform").at("yaw"), truth_.yaw, 0.02);
  EXPECT_NEAR(json.at("ratio").get<double>(),
              json.at("matched_cells").get<double>() / json.at("total_cells").get<double>(), 1e-9);
  EXPECT_GT(json.at("search_time"), 0.0);
  EXPECT_GT(json.at("reference_time"), 0.0);
  ASSERT_EQ(json.at("stages").size(), 3U);
  EXPECT_EQ(json.at("stages")[0].at("name"), "coarse");
  EXPECT_EQ(json.at("stages")[2].at("name"), "exact");
  EXPECT_EQ(json.at("certified"), true);
  EXPECT_EQ(json.at("upper_bound"), json.at("hit_ratio"));
  EXPECT_TRUE(json.at("runner_up").is_null());
  EXPECT_GE(json.at("margin"), 0.1);
  ASSERT_FALSE(json.at("evidence").empty());
  for (const auto& piece : json.at("evidence")) {
    EXPECT_NE(piece.at("bearing"), "against") << piece;
    EXPECT_FALSE(piece.at("text").get<std::string>().empty()) << piece;
  }
}

TEST_F(MatchMaps, SearchesInTwoStagesAloneWhenAskedTo) {
  const Run match = run(maps() + " --search two_stage --json -");

  ASSERT_EQ(match.status, 0) << match.errors;
  const auto json = nlohmann::json::parse(match.output);
  EXPECT_EQ(json.at("stages").size(), 2U);
  EXPECT_EQ(json.at("certified"), false);
}

TEST_F(MatchMaps, ShowsTheRunnerUpWhenItIsNearlyAsGood) {
  std::ofstream(file("config.yaml")) << "min_margin: 0.9\nexact_deadline: 60.0\n";

  const Run match = run(maps() + " --config '" + file("config.yaml") + "' --search exact --json -");

  EXPECT_EQ(match.status, 1) << match.errors;
  const auto json = nlohmann::json::parse(match.output);
  EXPECT_EQ(json.at("status"), "ambiguous");
  EXPECT_TRUE(json.at("transform").is_null());
  EXPECT_EQ(json.at("candidate_ratio"), json.at("hit_ratio"));
  EXPECT_LT(json.at("runner_up_ratio"), json.at("hit_ratio"));
  EXPECT_LT(json.at("margin"), 0.9);
  for (const char* key : {"x", "y", "yaw"}) {
    EXPECT_TRUE(json.at("candidate").at(key).is_number()) << key;
    EXPECT_TRUE(json.at("runner_up").at(key).is_number()) << key;
  }
}

TEST_F(MatchMaps, WritesJsonAndPictureToFiles) {
  const Run match = run(maps() + " --json '" + file("result.json") + "' --overlay '" + file("overlay.png") + "'");

  ASSERT_EQ(match.status, 0) << match.errors;
  EXPECT_NE(match.output.find("matched:"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(contentOf(file("result.json"))).at("status"), "matched");
  EXPECT_EQ(contentOf(file("overlay.png")).substr(1, 3), "PNG");
}

TEST_F(MatchMaps, WithoutAcceptableMatchExitsWithOneAndTheReason) {
  std::ofstream(file("config.yaml")) << "min_hit_ratio: 1.0\ncoarse_resolution: 0.05\nhit_tolerance: 0.0\n";

  const Run match = run(maps() + " --config '" + file("config.yaml") + "' --json -");

  EXPECT_EQ(match.status, 1) << match.errors;
  const auto json = nlohmann::json::parse(match.output);
  EXPECT_EQ(json.at("status"), "below_acceptance_ratio");
  EXPECT_TRUE(json.at("transform").is_null());
}

TEST_F(MatchMaps, BadInputExitsWithTwoAndNamesIt) {
  std::ofstream(file("range.yaml")) << "acceptance_ratio: 1.5\n";
  std::ofstream(file("misspelt.yaml")) << "aceptance_ratio: 0.5\n";
  const std::string config = maps() + " --config '" + (dir_ / "");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"--session '" + file("session.yaml") + "'", "--reference"},
      {maps() + " --search magic", "two_stage"},
      {"--reference '" + file("nothing.yaml") + "' --session '" + file("session.yaml") + "'", "nothing.yaml"},
      {config + "range.yaml'", "acceptance_ratio is 1.5, expected 0 to 1"},
      {config + "misspelt.yaml'", "did you mean acceptance_ratio?"},
      {config + "nothing.yaml'", "nothing.yaml"},
      {maps() + " --json '" + file("no/such/dir.json") + "'", "dir.json"},
      {maps() + " --overlay '" + file("no/such/dir.png") + "'", "dir.png"},
  };
  for (const auto& [arguments, named] : cases) {
    const Run match = run(arguments);

    EXPECT_EQ(match.status, 2) << arguments;
    EXPECT_NE(match.errors.find(named), std::string::npos) << arguments << ": " << match.errors;
  }
}

TEST_F(MatchMaps, TakesTheParameterFileOfTheNode) {
  const Run match = run(maps() + " --config '" + test::sourceFile("config/map_matcher.yaml") + "'");

  EXPECT_EQ(match.status, 0) << match.errors;
  EXPECT_EQ(match.errors, "");
}

TEST_F(MatchMaps, HelpIsNoError) { EXPECT_EQ(run("--help").status, 0); }

}  // namespace
}  // namespace map_matcher
