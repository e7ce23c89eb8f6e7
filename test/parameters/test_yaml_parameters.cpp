#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/search/search_options.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher::parameters {
namespace {

class YamlParameters : public testing::Test {
 protected:
  /// Reads a file of this content; returns what is wrong with it.
  std::string load(const std::string& content) {
    const std::string path = dir_ / "parameters.yaml";
    std::ofstream(path) << content;
    try {
      loadYamlParameters(path, parametersOf(options_));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryDir dir_;
  search::SearchOptions options_;
};

TEST_F(YamlParameters, FillTheFieldsTheyNameAndLeaveTheOthers) {
  EXPECT_EQ(load("acceptance_ratio: 0.7\nhits_sample_threshold: 1000\n"), "");

  EXPECT_EQ(options_.coarse.acceptance_ratio, 0.7);
  EXPECT_EQ(options_.hits_sample_threshold, 1000);
  EXPECT_EQ(options_.coarse_resolution, search::SearchOptions{}.coarse_resolution);
}

TEST_F(YamlParameters, OfAnEmptyFileChangeNothing) { EXPECT_EQ(load("# nothing\n"), ""); }

TEST_F(YamlParameters, AreRefusedWithEverythingThatIsWrong) {
  const std::string text = load("acceptance_ratio: -1\nhits_sample_threshold: many\nocupied_threshold: 50\n");

  EXPECT_NE(text.find("parameters.yaml"), std::string::npos) << text;
  EXPECT_NE(text.find("acceptance_ratio is -1, expected 0 to 1"), std::string::npos) << text;
  EXPECT_NE(text.find("hits_sample_threshold is many, expected 0 to"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean occupied_threshold?"), std::string::npos) << text;
}

TEST_F(YamlParameters, OfAFileThatIsNoMapAreRefused) {
  EXPECT_NE(load("- 1\n- 2\n").find("holds no 'name: value' lines"), std::string::npos);
  EXPECT_NE(load("a: [1\n").find("cannot be read"), std::string::npos);
}

TEST_F(YamlParameters, OfAMissingFileAreRefusedByItsName) {
  EXPECT_THROW(loadYamlParameters(dir_ / "nothing.yaml", parametersOf(options_)), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::parameters
