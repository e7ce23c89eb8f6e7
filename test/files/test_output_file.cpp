#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "map_matcher/files/output_file.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::files {
namespace {

namespace fs = std::filesystem;
using test::thrownText;

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class OutputFileTest : public testing::Test {
 protected:
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(dir_ / "")) {
      found.insert(entry.path().filename().string());
    }
    return found;
  }

  using Names = std::set<std::string>;
  const test::TemporaryDir dir_;
  const std::string path_ = dir_ / "result.txt";
};

TEST_F(OutputFileTest, HasItsNameOnlyWhenItIsComplete) {
  dir_.write("result.txt", "old");
  OutputFile file(path_);
  file.write("new");

  EXPECT_EQ(contentOf(path_), "old");
  EXPECT_EQ(contentOf(path_ + ".partial"), "new");
  file.commit();
  EXPECT_EQ(contentOf(path_), "new");
  EXPECT_EQ(names(), Names{"result.txt"});
}

TEST_F(OutputFileTest, LeavesTheOldFileWhenItIsNotCommitted) {
  dir_.write("result.txt", "old");

  { OutputFile(path_).write("new"); }

  EXPECT_EQ(contentOf(path_), "old");
  EXPECT_EQ(names(), Names{"result.txt"});
}

TEST_F(OutputFileTest, LeavesAloneWhatHasTheNameOfItsPendingFile) {
  dir_.write("result.txt.partial", "somebody's");

  writeFile(path_, "new");

  EXPECT_EQ(contentOf(path_), "new");
  EXPECT_EQ(contentOf(path_ + ".partial"), "somebody's");
  EXPECT_EQ(names(), (Names{"result.txt", "result.txt.partial"}));
}

TEST_F(OutputFileTest, ReplacesWhatALinkPointsAt) {
  fs::create_directory(dir_ / "elsewhere");
  fs::create_symlink("elsewhere/real.txt", path_);

  writeFile(path_, "first");  // the link points at nothing yet
  writeFile(path_, "second");

  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(contentOf(dir_ / "elsewhere/real.txt"), "second");
}

TEST_F(OutputFileTest, KeepsThePermissionsOfTheFileItReplaces) {
  dir_.write("result.txt", "old");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec);

  writeFile(path_, "new");

  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec);
}

TEST_F(OutputFileTest, CanBeMoved) {
  OutputFile file(path_);
  file.write("one");
  OutputFile moved(std::move(file));
  moved.write(" two");
  moved.commit();

  moved = OutputFile(dir_ / "other.txt");

  EXPECT_EQ(contentOf(path_), "one two");
  EXPECT_EQ(names(), (Names{"other.txt.partial", "result.txt"}));
}

TEST_F(OutputFileTest, NamesWhatCannotBeWrittenAndWhy) {
  const std::string in_no_directory = dir_ / "missing/result.txt";

  EXPECT_EQ(thrownText<OutputFileError>([&] { const OutputFile file(in_no_directory); }),
            "file '" + in_no_directory + "' cannot be written: No such file or directory");
  EXPECT_EQ(thrownText<OutputFileError>([&] { const OutputFile file(dir_ / ""); }),
            "file '" + (dir_ / "") + "' cannot be written: Is a directory");
  EXPECT_EQ(thrownText<OutputFileError>([&] { writeFile("/dev/full", "text"); }),
            "file '/dev/full' cannot be written: No space left on device");
}

TEST_F(OutputFileTest, SaysThatAFileGrewTooLargeAndKeepsTheOldOne) {
  dir_.write("result.txt", "old");
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{100, limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);

  const std::string text = thrownText<OutputFileError>([&] { writeFile(path_, std::string(1000, 'x')); });

  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(text, "file '" + path_ + "' cannot be written: File too large");
  EXPECT_EQ(contentOf(path_), "old");
  EXPECT_EQ(names(), Names{"result.txt"});
}

TEST_F(OutputFileTest, IsRemovedForAProcessThatASignalEnds) {
  dir_.write("result.txt", "old");
  OutputFile(dir_ / "done.txt").commit();
  OutputFile pending(path_);
  const OutputFile moved(std::move(pending));

  removePendingFiles();

  EXPECT_EQ(names(), (Names{"done.txt", "result.txt"}));
}

TEST_F(OutputFileTest, IsTheSameByWhateverName) {
  const std::string real = dir_.write("real.txt", "");
  fs::create_directory(dir_ / "inner");
  fs::create_symlink("real.txt", dir_ / "link.txt");
  fs::create_symlink("new.txt", dir_ / "dangling.txt");
  fs::create_hard_link(real, dir_ / "hard.txt");
  fs::create_directory_symlink(dir_ / "", dir_ / "inner/back");

  for (const char* name : {"./real.txt", "inner/../real.txt", "link.txt", "hard.txt", "inner/back/real.txt"}) {
    EXPECT_TRUE(isSameFile(real, dir_ / name)) << name;
    EXPECT_TRUE(isSameFile(dir_ / name, real)) << name;
  }
  for (const char* name : {"./new.txt", "inner/../new.txt", "inner/back/new.txt", "dangling.txt"}) {
    EXPECT_TRUE(isSameFile(dir_ / "new.txt", dir_ / name)) << name;
  }
  EXPECT_FALSE(isSameFile(real, dir_ / "new.txt"));
  EXPECT_FALSE(isSameFile(dir_ / "inner/real.txt", real));
  EXPECT_FALSE(isSameFile("/dev/null", "/dev/null"));
}

}  // namespace
}  // namespace map_matcher::files
