#include <gtest/gtest.h>

#include "map_matcher/belief/session_map_traits.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::belief {
namespace {

const SessionMapTraits kLast{"session_map", "/mapper", 100.0, 0.05, 20000};

std::string whyAfter(const SessionMapTraits& next) { return whyAnotherSession(kLast, next); }

TEST(SessionMapTraits, OfAMapThatGrewAreOfTheSameSession) {
  SessionMapTraits next = kLast;
  next.stamp = 105.0;
  next.known_cells = 21000;

  EXPECT_EQ(whyAfter(next), "");
  EXPECT_EQ(whyAfter(kLast), "");
}

TEST(SessionMapTraits, AllowForCellsThatAreForgotten) {
  SessionMapTraits next = kLast;
  next.known_cells = 10000;

  EXPECT_EQ(whyAfter(next), "");
}

TEST(SessionMapTraits, TellAMapThatWasBegunAnew) {
  SessionMapTraits next = kLast;
  next.stamp = 105.0;
  next.known_cells = 9999;

  EXPECT_EQ(whyAfter(next), "it has 9999 known cells, the last one had 20000");
}

TEST(SessionMapTraits, TellAnotherFramePublisherResolutionOrAnEarlierStamp) {
  SessionMapTraits frame = kLast;
  frame.frame = "other_map";
  SessionMapTraits publisher = kLast;
  publisher.publisher = "/other";
  SessionMapTraits resolution = kLast;
  resolution.resolution = 0.02;
  SessionMapTraits stamp = kLast;
  stamp.stamp = 97.5;

  EXPECT_EQ(whyAfter(frame), "its frame is \"other_map\", not \"session_map\"");
  EXPECT_EQ(whyAfter(publisher), "it comes from /other, not /mapper");
  EXPECT_EQ(whyAfter(resolution), "its cells are 0.02 m wide, not 0.05 m");
  EXPECT_EQ(whyAfter(stamp), "its stamp is 2.5 s before that of the last one");
}

TEST(SessionMapTraits, SayNothingOfMapsWithoutStamps) {
  SessionMapTraits next = kLast;
  next.stamp.reset();

  EXPECT_EQ(whyAfter(next), "");
  EXPECT_EQ(whyAnotherSession(next, kLast), "");
}

TEST(Digest, IsThatOfTheCellsAndOfWhereTheyLie) {
  const grid::OccupancyGrid map = test::asciiMap({"#.?", "..#"});
  grid::OccupancyGrid other = map;
  other.at(1, 1) = grid::kOccupied;
  grid::GridGeometry moved = map.geometry();
  moved.T_map_grid.x += 0.05;

  EXPECT_EQ(digestOf(map), digestOf(test::asciiMap({"#.?", "..#"})));
  EXPECT_NE(digestOf(map), digestOf(other));
  EXPECT_NE(digestOf(map), digestOf({moved, map.values()}));
  EXPECT_NE(digestOf(test::asciiMap({"#."})), digestOf(test::asciiMap({"#", "."})));
}

}  // namespace
}  // namespace map_matcher::belief
