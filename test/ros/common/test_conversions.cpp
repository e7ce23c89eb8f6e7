#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "support/ascii_map.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_common {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A message of one row of three cells.
nav_msgs::OccupancyGrid goodMessage() {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = "map";
  message.info.resolution = 0.05F;
  message.info.width = 3;
  message.info.height = 1;
  message.info.origin.orientation.w = 1.0;
  message.data = {-1, 0, 100};
  return message;
}

/// What the refusal of `message` says; empty when it is accepted.
std::string refusalOf(const nav_msgs::OccupancyGrid& message) {
  try {
    fromMessage(message);
    return "";
  } catch (const MessageError& error) {
    return error.what();
  }
}

std::string refusalOf(const geometry_msgs::Pose& pose) {
  try {
    fromMessage(pose, "the pose");
    return "";
  } catch (const MessageError& error) {
    return error.what();
  }
}

geometry_msgs::Quaternion quaternion(double x, double y, double z, double w) {
  geometry_msgs::Quaternion message;
  message.x = x;
  message.y = y;
  message.z = z;
  message.w = w;
  return message;
}

void expectNames(const std::string& refusal, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(refusal.find(part), std::string::npos) << "'" << part << "' is not in: '" << refusal << "'";
  }
}

TEST(PoseMessage, ComesBackAsItWas) {
  for (double yaw = -3.1; yaw <= 3.15; yaw += 0.1) {
    const grid::Rigid2 pose{12.5, -0.25, yaw};

    const grid::Rigid2 from_pose = fromMessage(toPoseMessage(pose), "the pose");
    const grid::Rigid2 from_transform = fromMessage(toTransformMessage(pose), "the transform");

    for (const grid::Rigid2& back : {from_pose, from_transform}) {
      EXPECT_EQ(back.x, pose.x);
      EXPECT_EQ(back.y, pose.y);
      EXPECT_NEAR(grid::normalizeAngle(back.yaw - yaw), 0.0, 1e-12) << yaw;
    }
  }
}

TEST(PoseMessage, TakesEitherSignOfTheQuaternion) {
  geometry_msgs::Pose pose;
  pose.orientation = quaternion(0.0, 0.0, -std::sin(0.35), -std::cos(0.35));

  EXPECT_NEAR(fromMessage(pose, "the pose").yaw, 0.7, 1e-12);
}

TEST(PoseMessage, TakesAHalfTurnAboutZ) {
  geometry_msgs::Pose pose;
  pose.orientation = quaternion(0.0, 0.0, 1.0, 0.0);

  EXPECT_DOUBLE_EQ(fromMessage(pose, "the pose").yaw, M_PI);
}

TEST(PoseMessage, IgnoresHeight) {
  geometry_msgs::Pose pose;
  pose.position.z = 1.2;
  pose.orientation.w = 1.0;

  EXPECT_EQ(refusalOf(pose), "");
}

TEST(PoseMessage, ForgivesTheRoundingOfAQuaternion) {
  geometry_msgs::Pose pose;
  pose.orientation = quaternion(0.0, 0.0, 0.7071, 0.7071);  // norm 0.99999

  EXPECT_NEAR(fromMessage(pose, "the pose").yaw, M_PI / 2.0, 1e-9);
}

TEST(PoseMessage, IsRefusedWithAPositionThatIsNotFinite) {
  geometry_msgs::Pose pose;
  pose.orientation.w = 1.0;
  pose.position.y = kNan;
  expectNames(refusalOf(pose), {"the pose", "nan", "finite"});

  pose.position.y = 0.0;
  pose.position.z = kInfinity;
  expectNames(refusalOf(pose), {"the pose", "inf", "finite"});
}

TEST(PoseMessage, IsRefusedWithAQuaternionThatIsNotNormalised) {
  geometry_msgs::Pose pose;  // all zero, as a default-constructed message
  expectNames(refusalOf(pose), {"the pose", "(0, 0, 0, 0)", "norm 1"});

  pose.orientation = quaternion(0.0, 0.0, 0.0, 1.01);
  expectNames(refusalOf(pose), {"1.01", "norm 1"});

  pose.orientation = quaternion(kNan, 0.0, 0.0, 1.0);
  expectNames(refusalOf(pose), {"nan", "norm 1"});
}

TEST(PoseMessage, IsRefusedWhenTilted) {
  geometry_msgs::Pose pose;
  pose.orientation = quaternion(std::sin(0.05), 0.0, 0.0, std::cos(0.05));
  expectNames(refusalOf(pose), {"the pose", "roll 0.1", "about z"});

  pose.orientation = quaternion(0.0, std::sin(0.05), 0.0, std::cos(0.05));
  expectNames(refusalOf(pose), {"pitch 0.1", "about z"});

  pose.orientation = quaternion(1.0, 0.0, 0.0, 0.0);  // upside down
  expectNames(refusalOf(pose), {"about z"});
}

TEST(GridMessage, ComesBackAsItWas) {
  const grid::OccupancyGrid grid = test::asciiMap({"#.?", ".#."}, 0.05, {1.0, -2.0, 0.5});

  const grid::OccupancyGrid back = fromMessage(toMessage(grid, "map", ros::Time(3.0)));

  EXPECT_EQ(back.values(), grid.values());
  EXPECT_EQ(back.width(), 3);
  EXPECT_EQ(back.height(), 2);
  EXPECT_EQ(back.resolution(), 0.05);
  EXPECT_EQ(back.geometry().T_map_grid.x, 1.0);
  EXPECT_EQ(back.geometry().T_map_grid.y, -2.0);
  EXPECT_NEAR(back.geometry().T_map_grid.yaw, 0.5, 1e-12);
}

TEST(GridMessage, CarriesFrameAndStamp) {
  const nav_msgs::OccupancyGrid message = toMessage(test::asciiMap({"#"}), "session_map", ros::Time(3.5));

  EXPECT_EQ(message.header.frame_id, "session_map");
  EXPECT_EQ(message.header.stamp, ros::Time(3.5));
  EXPECT_EQ(message.info.map_load_time, ros::Time(3.5));
}

TEST(GridMessage, HasTheDecimalResolutionThatItsFloatStandsFor) {
  nav_msgs::OccupancyGrid message = goodMessage();
  for (const double resolution : {0.01, 0.02, 0.025, 0.03, 0.05, 0.1, 0.15, 0.2, 0.0333333, 1.0}) {
    message.info.resolution = static_cast<float>(resolution);

    EXPECT_EQ(fromMessage(message).resolution(), resolution);
  }
}

TEST(GridMessage, IsRefusedWithABadResolution) {
  for (const float resolution : {0.0F, -0.05F, std::numeric_limits<float>::quiet_NaN()}) {
    nav_msgs::OccupancyGrid message = goodMessage();
    message.info.resolution = resolution;

    expectNames(refusalOf(message), {"resolution is", "positive"});
  }
  for (const float resolution : {1e-9F, 1e-45F, 1e9F}) {
    nav_msgs::OccupancyGrid message = goodMessage();
    message.info.resolution = resolution;

    expectNames(refusalOf(message), {"resolution is 1", "expected", "0.001 to 10"});
  }
}

TEST(GridMessage, IsRefusedFarFromEverything) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.info.origin.position.x = 1e300;
  expectNames(refusalOf(message), {"origin is (1e+300, 0, 0)", "within 1000000 m"});

  message.info.origin.position.x = 1e6;
  EXPECT_EQ(refusalOf(message), "");
}

TEST(GridMessage, IsRefusedWithMoreCellsThanABuildingHas) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.info.width = 20000;
  message.info.height = 20000;

  expectNames(refusalOf(message), {"20000 x 20000 cells", "at most 268435456"});
}

TEST(FrameOfAHeader, IsANameWithoutBlanksAndLineBreaks) {
  std_msgs::Header header;
  header.frame_id = "/robot-1/map";
  EXPECT_EQ(frameOf(header), "robot-1/map");
  for (const char* frame : {"", "/", "the map", "map\n", "map\t", "\x7f"}) {
    header.frame_id = frame;
    const std::string refusal = test::thrownText<MessageError>([&] { frameOf(header); });
    expectNames(refusal, {std::string("header.frame_id is \"") + frame + '"', "the name of a frame"});
  }
}

TEST(GridMessage, IsRefusedWithoutCells) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.info.width = 0;
  message.data.clear();

  expectNames(refusalOf(message), {"0 x 1", "at least 1 x 1"});
}

TEST(GridMessage, IsRefusedWhenDataAndSizeDisagree) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.data.push_back(0);
  expectNames(refusalOf(message), {"4 values", "3 x 1 = 3"});

  message.data.clear();
  expectNames(refusalOf(message), {"0 values", "3 x 1 = 3"});
}

TEST(GridMessage, IsRefusedWithASizeThatNoGridHas) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.info.width = 4294967295U;
  expectNames(refusalOf(message), {"4294967295 x 1", "at most"});

  message.info.width = 65536;
  message.info.height = 65536;
  expectNames(refusalOf(message), {"65536 x 65536", "at most"});
}

TEST(GridMessage, IsRefusedWithAValueThatIsNoOccupancy) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.data[1] = 101;
  expectNames(refusalOf(message), {"value 101", "0 to 100"});

  message.data[1] = -2;
  expectNames(refusalOf(message), {"value -2", "0 to 100"});
}

TEST(GridMessage, IsRefusedWithABadOrigin) {
  nav_msgs::OccupancyGrid message = goodMessage();
  message.info.origin.position.x = kNan;
  expectNames(refusalOf(message), {"origin", "nan"});

  message = goodMessage();
  message.info.origin.orientation.w = 0.0;
  expectNames(refusalOf(message), {"origin", "quaternion"});

  message = goodMessage();
  message.info.origin.orientation = quaternion(0.1, 0.0, 0.0, std::sqrt(0.99));
  expectNames(refusalOf(message), {"origin", "tilted"});
}

}  // namespace
}  // namespace map_matcher::ros_common
