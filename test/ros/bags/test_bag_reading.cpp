#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/ros/bags/bag_writing.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_bags {
namespace {

using test::thrownText;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A bag of 100 texts.
class BagReading : public testing::Test {
 protected:
  void SetUp() override {
    BagWriter bag(path_);
    for (int i = 0; i < kMessages; ++i) {
      std_msgs::String text;
      text.data = "text " + std::to_string(i);
      bag.write("/words", ros::Time(100.0 + i), text);
    }
    bag.close();
    bytes_ = contentOf(path_);
  }

  std::string read(const std::string& path) const {
    rosbag::Bag bag;
    openBag(bag, path);
    rosbag::View view(bag);
    std::string all;
    forEachMessage(bag, view, [&all](const rosbag::MessageInstance& message) {
      all += message.instantiate<std_msgs::String>()->data + ';';
    });
    return all;
  }

  std::string problemWith(const std::string& content) const {
    return thrownText<BagError>([&] { read(dir_.write("bad.bag", content)); });
  }

  static constexpr int kMessages = 100;
  const test::TemporaryDir dir_;
  const std::string path_ = dir_ / "words.bag";
  const std::string bad_ = dir_ / "bad.bag";
  std::string bytes_;
};

TEST_F(BagReading, givesTheMessagesInTheirOrder) {
  EXPECT_THAT(read(path_), AllOf(HasSubstr("text 0;text 1;text 2;"), HasSubstr("text 99;")));
}

TEST_F(BagReading, saysWhatAFileIsThatIsNoBag) {
  EXPECT_THAT(thrownText<BagError>([&] { read(dir_ / "nowhere.bag"); }),
              HasSubstr("nowhere.bag' cannot be read: No such file or directory"));
  EXPECT_THAT(thrownText<BagError>([&] { read(dir_ / ""); }), HasSubstr("is a directory"));
  EXPECT_THAT(problemWith(""), AllOf(HasSubstr(bad_), HasSubstr("is empty")));
  EXPECT_THAT(problemWith("image: room.pgm\n"), AllOf(HasSubstr(bad_), HasSubstr("is no bag")));
}

TEST_F(BagReading, namesABagThatIsCutOffAnywhereAndWhatToDo) {
  for (std::size_t size = 13; size < bytes_.size(); size += 101) {
    EXPECT_THAT(problemWith(bytes_.substr(0, size)), AllOf(HasSubstr(bad_), HasSubstr("rosbag reindex"))) << size;
  }
}

TEST_F(BagReading, namesABagThatWasNeverClosed) {
  std::string open = bytes_;
  const std::size_t index = open.find("index_pos=") + 10;
  open.replace(index, 8, 8, '\0');

  EXPECT_THAT(problemWith(open), AllOf(HasSubstr(bad_), HasSubstr("has no index"), HasSubstr("rosbag reindex")));
}

TEST_F(BagReading, namesBagTopicAndTimeOfADamagedMessage) {
  std::string damaged = bytes_;
  const std::size_t text = damaged.find("text 7");
  damaged.replace(text - 4, 4, "\xff\xff\xff\x7f");  // the length of the text

  EXPECT_THAT(problemWith(damaged),
              AllOf(HasSubstr(bad_), HasSubstr("topic '/words' recorded at 107 s"), HasSubstr("rosbag reindex")));
}

TEST_F(BagReading, leavesTheErrorsOfItsUserAlone) {
  rosbag::Bag bag;
  openBag(bag, path_);
  rosbag::View view(bag);

  const std::string text = thrownText<std::invalid_argument>([&] {
    forEachMessage(bag, view, [](const rosbag::MessageInstance& /*message*/) { throw std::invalid_argument("mine"); });
  });

  EXPECT_EQ(text, "mine");
}

TEST_F(BagReading, leavesNothingOfABagThatIsNotClosed) {
  const std::string path = dir_ / "new.bag";
  {
    BagWriter bag(path);
    bag.write("/words", ros::Time(1.0), std_msgs::String());
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_TRUE(std::filesystem::exists(path + ".partial"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
}

}  // namespace
}  // namespace map_matcher::ros_bags
