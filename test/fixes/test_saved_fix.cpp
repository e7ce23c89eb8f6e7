#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "map_matcher/files/output_file.hpp"
#include "map_matcher/fixes/saved_fix.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::fixes {
namespace {

using test::thrownText;

SavedFix exampleFix() {
  SavedFix fix;
  fix.reference_map = "floor \"1\": the old wing # of 2";
  fix.reference_digest = 0x00c0ffee12345678;
  fix.pose.T_reference_base = {12.25, -3.1, -2.75};
  fix.pose.covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01;
  fix.pose.stamp = 1700000000.25;
  return fix;
}

class SavedFixTest : public testing::Test {
 protected:
  std::string text() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// What is said of the file with `from` replaced by `to`.
  std::string problemAfterChange(const std::string& from, const std::string& to) {
    saveFix(exampleFix(), path_);
    std::string changed = text();
    const std::size_t begin = changed.find(from);
    EXPECT_NE(begin, std::string::npos) << from;
    changed.replace(begin, from.size(), to);
    dir_.write("fix.yaml", changed);
    return thrownText<FixFileError>([this] { loadFix(path_); });
  }

  const test::TemporaryDir dir_;
  const std::string path_ = dir_ / "fix.yaml";
};

TEST_F(SavedFixTest, IsReadAsItWasWritten) {
  saveFix(exampleFix(), path_);

  const SavedFix fix = loadFix(path_);

  EXPECT_EQ(fix.reference_map, exampleFix().reference_map);
  EXPECT_EQ(fix.reference_digest, exampleFix().reference_digest);
  EXPECT_EQ(fix.pose.T_reference_base.x, 12.25);
  EXPECT_EQ(fix.pose.T_reference_base.y, -3.1);
  EXPECT_EQ(fix.pose.T_reference_base.yaw, -2.75);
  EXPECT_EQ(fix.pose.covariance, exampleFix().pose.covariance);
  EXPECT_EQ(fix.pose.stamp, 1700000000.25);
}

TEST_F(SavedFixTest, CutAnywhereIsNoFix) {
  saveFix(exampleFix(), path_);
  const std::string whole = text();
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {  // the last character ends the line, no more
    dir_.write("fix.yaml", whole.substr(0, length));
    EXPECT_THROW(loadFix(path_), FixFileError) << "cut after " << length << " of " << whole.size() << " characters";
  }
}

TEST_F(SavedFixTest, ThatIsNotThereIsNamed) {
  const std::string problem = thrownText<FixFileError>([this] { loadFix(path_); });

  EXPECT_NE(problem.find(path_), std::string::npos) << problem;
  EXPECT_NE(problem.find("does not exist"), std::string::npos) << problem;
}

TEST_F(SavedFixTest, IsRefusedByTheNameOfWhatIsWrong) {
  EXPECT_NE(problemAfterChange("version: 1", "version: 2").find("version is 2, expected 1"), std::string::npos);
  EXPECT_NE(problemAfterChange("00c0ffee", "00c0ffeX").find("reference_digest is"), std::string::npos);
  EXPECT_NE(problemAfterChange("12.25", ".nan").find("pose is [.nan"), std::string::npos);
  EXPECT_NE(problemAfterChange("pose:", "pos:").find("pose is missing"), std::string::npos);
  EXPECT_NE(problemAfterChange("0.04", "0").find("the variance of x is 0"), std::string::npos);
  EXPECT_NE(problemAfterChange("0.04, ", "").find("covariance is ["), std::string::npos);
  EXPECT_NE(problemAfterChange("1700000000.25", "soon").find("stamp is"), std::string::npos);
}

TEST_F(SavedFixTest, ThatCannotBeWrittenIsNamed) {
  EXPECT_THROW(saveFix(exampleFix(), dir_ / "nowhere/fix.yaml"), files::OutputFileError);
}

}  // namespace
}  // namespace map_matcher::fixes
