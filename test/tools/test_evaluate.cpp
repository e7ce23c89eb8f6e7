#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;

const std::string kTools = std::filesystem::path(EVALUATE_DRIVE).parent_path().string();

class Evaluate : public testing::Test {
 protected:
  ProgramRun run(const std::string& arguments) const {
    return test::runProgram(MAP_MATCHER_SOURCE_DIR "/scripts/evaluate",
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
  EXPECT_NE(done.output.find("2 runs, 0 failed"), std::string::npos) << done.output;
  EXPECT_NE(page().find("| time to the first match [s] | mean | 1.91 |"), std::string::npos) << page();
  EXPECT_EQ(page().find("nan"), std::string::npos) << page();
  for (const char* name : {"crowd.csv", "crowd_ratios.png", "crowd_times.png", "crowd_match.png"}) {
    EXPECT_TRUE(std::filesystem::exists(output + "/page/" + name)) << name;
  }

  const ProgramRun again = run(arguments);
  EXPECT_NE(again.output.find("2 runs, 2 of them done before"), std::string::npos) << again.output;
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

}  // namespace
}  // namespace map_matcher
