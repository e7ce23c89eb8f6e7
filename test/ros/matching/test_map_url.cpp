#include <gtest/gtest.h>

#include <stdexcept>

#include "map_matcher/ros/matching/map_url.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_matching {
namespace {

TEST(MapUrl, NamesAPath) {
  EXPECT_EQ(pathOfMapUrl("/maps/floor1.yaml"), "/maps/floor1.yaml");
  EXPECT_EQ(pathOfMapUrl("maps/floor1.yaml"), "maps/floor1.yaml");
  EXPECT_EQ(pathOfMapUrl("file:///maps/floor1.yaml"), "/maps/floor1.yaml");
}

TEST(MapUrl, OfAnotherKindIsRefusedByItsName) {
  EXPECT_EQ(test::thrownText<std::invalid_argument>([] { pathOfMapUrl("http://maps/floor1.yaml"); }),
            "map_url is \"http://maps/floor1.yaml\", expected a path or file:///PATH");
}

}  // namespace
}  // namespace map_matcher::ros_matching
