#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "map_matcher/trials/truth_fit.hpp"
#include "support/drives.hpp"

namespace map_matcher::trials {
namespace {

using testing::HasSubstr;

/// A drive through two rooms with its truth moved by T_wrong_reference, looked at in a map.
TruthFit fitOf(const grid::OccupancyGrid& map, const grid::Rigid2& T_wrong_reference) {
  simulation::DriveOptions options = test::shortDrive(1);
  options.rate = 5.0;
  const simulation::Drive drive = simulation::simulateDrive(test::twoRooms(), options);
  TruthFit fit(map);
  for (const simulation::DriveStep& step : drive.steps) {
    TrialMoment moment;
    moment.T_reference_base = T_wrong_reference * step.T_map_base;
    moment.scans = {{step.scans.front(), {drive.T_base_lidar.front(), false}}};
    fit.add(moment);
  }
  return fit;
}

TEST(TruthFit, FindsNothingWrongWithADriveInItsMap) { EXPECT_EQ(fitOf(test::twoRooms(), {}).problem(), std::nullopt); }

TEST(TruthFit, TellsThatTheRobotWasOutsideTheMap) {
  EXPECT_THAT(fitOf(test::twoRooms(), {100.0, 0.0, 0.0}).problem().value_or(""),
              HasSubstr("only 0 of 16 true poses that were looked at lie within the map, expected most of them"));
}

TEST(TruthFit, TellsThatTheScansSawOtherWalls) {
  EXPECT_THAT(fitOf(test::building(1), {12.0, 6.0, 0.5}).problem().value_or(""),
              HasSubstr("% of the scans' points lie within 0.3 m of a wall of the map"));
}

TEST(TruthFit, SaysNothingWithoutTruth) { EXPECT_EQ(TruthFit(test::twoRooms()).problem(), std::nullopt); }

}  // namespace
}  // namespace map_matcher::trials
