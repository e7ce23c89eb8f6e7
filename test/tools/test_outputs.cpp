// What programs leave behind when something goes wrong: nothing half-written, and nothing destroyed.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>

#include "map_matcher/grid/map_file.hpp"
#include "support/ascii_map.hpp"
#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

namespace fs = std::filesystem;
using test::ProgramRun;
using test::runProgram;

constexpr int kBadInput = 2;
constexpr const char* kSmallFiles = "ulimit -f 8; trap '' XFSZ;";  // 4 or 8 KiB, whatever the shell takes for a block

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A room, and a bag of a drive through it.
class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    grid::saveMap(test::asciiMap({"##########",  //
                                  "#........#",  //
                                  "#........#",  //
                                  "#........#",  //
                                  "##########"},
                                 0.5),
                  map_);
    ASSERT_EQ(runProgram(SIMULATE_DRIVE, drive_ + bag_).exit_status, 0);
    before_ = names();
  }

  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(dir_ / "")) {
      found.insert(entry.path().filename().string());
    }
    return found;
  }

  void expectRefused(const std::string& program, const std::string& arguments, const std::string& named) const {
    const ProgramRun done = runProgram(program, arguments);
    EXPECT_EQ(done.exit_status, kBadInput) << arguments << '\n' << done.output;
    EXPECT_NE(done.output.find(named), std::string::npos) << arguments << '\n' << done.output;
    EXPECT_EQ(names(), before_) << arguments;
  }

  const test::TemporaryDir dir_;
  const std::string map_ = dir_ / "room.yaml";
  const std::string bag_ = dir_ / "drive.bag";
  const std::string drive_ = "--map " + map_ + " --radius 0.2 --duration 2 --beams 51 --people 2 --bag ";
  std::set<std::string> before_;
};

TEST_F(Outputs, areNeverTheFilesThatAreRead) {
  fs::create_directory(dir_ / "inner");
  fs::create_symlink("drive.bag", dir_ / "link.bag");
  fs::create_hard_link(bag_, dir_ / "hard.bag");
  before_ = names();
  const std::string bag = contentOf(bag_);
  const std::string map = contentOf(map_);
  const std::string image = contentOf(dir_ / "room.pgm");
  const std::string maps = "--reference " + map_ + " --session " + map_;

  for (const char* name : {"drive.bag", "./drive.bag", "link.bag", "hard.bag", "inner/../drive.bag"}) {
    expectRefused(SCRUB_BAG, "--bag " + bag_ + " --scan scan --output " + (dir_ / name), "the same file as --bag");
  }
  expectRefused(SCRUB_BAG, "--bag " + bag_ + " --scan scan --output " + (dir_ / "inner"), "Is a directory");
  expectRefused(SIMULATE_DRIVE, drive_ + map_, "the same file as --map");
  expectRefused(SIMULATE_DRIVE, drive_ + (dir_ / "./room.pgm"), "the same file as the image of --map");
  expectRefused(MATCH_MAPS, maps + " --json " + (dir_ / "./room.yaml"), "the same file as --reference");
  expectRefused(MATCH_MAPS, maps + " --overlay " + (dir_ / "room.pgm"), "the same file as the image of --reference");
  expectRefused(MATCH_MAPS, maps + " --json " + (dir_ / "new.png") + " --overlay " + (dir_ / "./new.png"),
                "the same file as --json");
  expectRefused(MAP_QUALITY, "--truth " + map_ + " --session " + map_ + " --overlay " + map_,
                "the same file as --truth");
  expectRefused(MAP_BAG, "--bag " + bag_ + " --output " + bag_, "the same file as --bag");
  expectRefused(MAP_BAG, "--bag " + bag_ + " --output " + (dir_ / "new.yaml") + " --trajectory " + (dir_ / "new.pgm"),
                "the same file as the image of --output");
  expectRefused(GENERATE_BUILDING, "--output " + (dir_ / "new.pgm"), "the same file as --output");

  EXPECT_TRUE(contentOf(bag_) == bag);
  EXPECT_TRUE(contentOf(map_) == map);
  EXPECT_TRUE(contentOf(dir_ / "room.pgm") == image);
}

TEST_F(Outputs, areNotThereWhenTheDiskIsFull) {
  const std::string kept = dir_.write("old.bag", "old");
  dir_.write("old.yaml", "old");
  dir_.write("old.pgm", "old");
  before_ = names();
  const std::string small = std::string("-c \"") + kSmallFiles + " exec ";

  for (const char* name : {"new.bag", "old.bag"}) {
    expectRefused("/bin/sh", small + SIMULATE_DRIVE + " " + drive_ + (dir_ / name) + '"',
                  "bag '" + (dir_ / name) + "' cannot be written: File too large");
    expectRefused("/bin/sh", small + SCRUB_BAG + " --bag " + bag_ + " --scan scan --output " + (dir_ / name) + '"',
                  "bag '" + (dir_ / name) + "' cannot be written: File too large");
  }
  for (const char* name : {"new", "old"}) {
    expectRefused("/bin/sh", small + GENERATE_BUILDING + " --output " + (dir_ / name) + ".yaml\"",
                  std::string(name) + ".pgm' cannot be written: File too large");
  }
  expectRefused("/bin/sh",
                small + MAP_QUALITY + " --truth " + map_ + " --session " + map_ + " --pose 0 0 0 --overlay " +
                    (dir_ / "new.png") + '"',
                "new.png' cannot be written: File too large");
  EXPECT_EQ(contentOf(kept), "old");
  EXPECT_EQ(contentOf(dir_ / "old.yaml"), "old");
  EXPECT_EQ(contentOf(dir_ / "old.pgm"), "old");
}

TEST_F(Outputs, ofADamagedBagLeaveTheOldOnesAlone) {
  std::string bag = contentOf(bag_);
  const std::string damaged = dir_.write("damaged.bag", bag.substr(0, bag.size() / 2));
  const std::string old = dir_.write("old.bag", "old");
  before_ = names();

  expectRefused(SCRUB_BAG, "--bag " + damaged + " --scan scan --output " + old, damaged);

  EXPECT_EQ(contentOf(old), "old");
}

TEST_F(Outputs, areNotThereAfterASignal) {
  const std::string old = dir_.write("old.bag", "old");
  before_ = names();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_DFL);  // nohup leaves one of them ignored
    test::ProgramProcess drive(SIMULATE_DRIVE, {"--map", map_, "--radius", "0.2", "--duration", "36000", "--bag", old});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!fs::exists(old + ".partial") && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::yield();
    }
    ASSERT_TRUE(fs::exists(old + ".partial"));

    EXPECT_EQ(drive.end(signal), 128 + signal);

    EXPECT_EQ(names(), before_);
    ASSERT_EQ(fs::file_size(old), 3U) << "signal " << signal;
    EXPECT_EQ(contentOf(old), "old");
  }
}

TEST_F(Outputs, tellWhenStandardOutputIsFull) {
  const std::string maps = " --reference " + map_ + " --session " + map_;
  for (const std::string& command :
       {std::string(MATCH_MAPS) + maps, std::string(MATCH_MAPS) + maps + " --json -",
        MATCH_MAPS + std::string(" --help"), std::string(GENERATE_BUILDING) + " --output " + (dir_ / "office.yaml")}) {
    const ProgramRun done = runProgram("/bin/sh", "-c \"exec " + command + " > /dev/full\"");

    EXPECT_EQ(done.exit_status, kBadInput) << command;
    EXPECT_NE(done.output.find("standard output cannot be written: No space left on device"), std::string::npos)
        << command << '\n'
        << done.output;
  }
}

}  // namespace
}  // namespace map_matcher
