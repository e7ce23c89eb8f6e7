#include <gtest/gtest.h>

#include <string>

#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/evaluation/map_quality.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;

class ScrubBag : public testing::Test {
 protected:
  static ProgramRun run(const std::string& program, const std::string& arguments) {
    ProgramRun done = test::runProgram(program, arguments);
    EXPECT_EQ(done.exit_status, 0) << program << ' ' << arguments << '\n' << done.output;
    return done;
  }

  evaluation::MapQuality qualityOf(const std::string& session_file) const {
    const grid::OccupancyGrid session = grid::loadMap(session_file);
    const search::Reference reference(grid::loadMap(office), {});
    const belief::Answer match = belief::matchAlone({&reference}, session, {});
    EXPECT_TRUE(match.matched()) << match.reason;
    return evaluation::mapQuality(reference.grid(), session, match.search.T_reference_session, 0.15);
  }

  const test::TemporaryDir dir;
  const std::string office = dir / "office.yaml";
  const std::string crowd = dir / "crowd.bag";
  const std::string scrubbed = dir / "scrubbed.bag";
};

TEST_F(ScrubBag, keepsMostPeopleOutOfTheSessionMap) {
  run(GENERATE_BUILDING, "--seed 1 --resolution 0.05 --output " + office);
  run(SIMULATE_DRIVE, "--map " + office + " --seed 1 --duration 60 --density 0.3 --standing-share 0.7 --bag " + crowd);

  const ProgramRun scrub = run(SCRUB_BAG, "--bag " + crowd + " --scan scan --output " + scrubbed);
  run(MAP_BAG, "--bag " + scrubbed + " --scan scan --output " + (dir / "raw.yaml"));
  run(MAP_BAG, "--bag " + scrubbed + " --scan scan_scrubbed --output " + (dir / "scrubbed.yaml"));

  EXPECT_NE(scrub.output.find("/scan: 901 scans"), std::string::npos) << scrub.output;
  EXPECT_GT(qualityOf(dir / "raw.yaml").falsely_occupied, 3 * qualityOf(dir / "scrubbed.yaml").falsely_occupied / 2);
}

TEST_F(ScrubBag, namesABagThatIsNotThere) {
  const ProgramRun done = test::runProgram(SCRUB_BAG, "--bag " + (dir / "nowhere.bag"));

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("nowhere.bag' cannot be read"), std::string::npos) << done.output;
}

TEST_F(ScrubBag, namesAModeThatThereIsNot) {
  const ProgramRun done = test::runProgram(SCRUB_BAG, "--bag " + crowd + " --mode sometimes");

  EXPECT_EQ(done.exit_status, 2);
  EXPECT_NE(done.output.find("mode is \"sometimes\", expected cached | synchronised"), std::string::npos)
      << done.output;
}

}  // namespace
}  // namespace map_matcher
