#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "map_matcher/grid/map_limits.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::grid {
namespace {

TEST(MapLimits, LeaveRoomForEveryBuilding) {
  EXPECT_NO_THROW(requireMapLimits({kMinMapResolution, 1, 1, {}}));
  EXPECT_NO_THROW(requireMapLimits({kMaxMapResolution, 1 << 14, 1 << 14, {-kMaxMapOrigin, kMaxMapOrigin, 3.0}}));
}

TEST(MapLimits, NameTheFieldItsValueAndWhatWasExpected) {
  struct Case {
    GridGeometry geometry;
    const char* named;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Case& bad :
       {Case{{1e-9, 1, 1, {}}, "resolution is 1e-09, expected a positive number of metres per cell, 0.001 to 10"},
        Case{{1e9, 1, 1, {}}, "resolution is 1000000000, expected"}, Case{{nan, 1, 1, {}}, "resolution is nan"},
        Case{{0.05, 1, 1, {1e300, 0.0, 0.0}}, "origin is (1e+300, 0, 0), expected x and y within 1000000 m"},
        Case{{0.05, 1, 1, {0.0, -2e6, 0.0}}, "origin is (0, -2000000, 0)"},
        Case{{0.05, 1, 1, {0.0, 0.0, nan}}, "origin is (0, 0, nan)"},
        Case{{0.05, 20000, 20000, {}}, "the map is 20000 x 20000 cells, expected at most 268435456 in all"}}) {
    const std::string text = test::thrownText<std::invalid_argument>([&bad] { requireMapLimits(bad.geometry); });
    EXPECT_NE(text.find(bad.named), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace map_matcher::grid
