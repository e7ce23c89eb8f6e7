#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "map_matcher/evaluation/localization_run.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::TemporaryDir;

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A robot that stands at (1, 2) and is localized from 12 s on, 3 cm and then 5 cm beside itself.
LocalizationRun smallRun() {
  const Rigid2 truth{1.0, 2.0, 0.0};
  LocalizationRun run;
  run.samples = {{10.0, truth, std::nullopt},
                 {12.0, truth, Rigid2{1.03, 2.0, 0.01}},
                 {13.5, truth, Rigid2{1.0, 2.05, -0.02}},
                 {14.0, truth, std::nullopt}};
  run.T_reference_session = Rigid2{4.0, 5.0, 0.5};
  run.ratio = 0.75;
  return run;
}

TEST(WriteErrors, WritesALineForEachSampleAndLeavesOutWhatIsNotKnown) {
  const TemporaryDir dir;

  writeErrors(smallRun(), dir / "errors.csv");

  EXPECT_EQ(textOf(dir / "errors.csv"),
            "time,true_x,true_y,true_yaw,x,y,yaw,translation_error,rotation_error\n"
            "0,1,2,0,,,,,\n"
            "2,1,2,0,1.03,2,0.01,0.03,0.01\n"
            "3.5,1,2,0,1,2.05,-0.02,0.05,0.02\n"
            "4,1,2,0,,,,,\n");
}

TEST(WriteErrors, WritesOnlyTheHeaderOfAnEmptyRun) {
  const TemporaryDir dir;

  writeErrors({}, dir / "errors.csv");

  EXPECT_EQ(textOf(dir / "errors.csv"), "time,true_x,true_y,true_yaw,x,y,yaw,translation_error,rotation_error\n");
}

TEST(WriteSummary, HoldsTheFiguresOfTheRun) {
  const TemporaryDir dir;

  writeSummary(smallRun(), dir / "summary.json");

  const auto json = nlohmann::json::parse(textOf(dir / "summary.json"));
  EXPECT_EQ(json["samples"], 4);
  EXPECT_EQ(json["localized_samples"], 2);
  EXPECT_DOUBLE_EQ(json["localized_after"], 2.0);
  EXPECT_EQ(json["transform"], (nlohmann::json{{"x", 4.0}, {"y", 5.0}, {"yaw", 0.5}}));
  EXPECT_DOUBLE_EQ(json["ratio"], 0.75);
  EXPECT_NEAR(json["translation_error"]["mean"], 0.04, 1e-12);
  EXPECT_NEAR(json["translation_error"]["worst"], 0.05, 1e-12);
  EXPECT_NEAR(json["rotation_error"]["mean"], 0.015, 1e-12);
  EXPECT_NEAR(json["final_error"]["translation"], 0.05, 1e-12);
  EXPECT_NEAR(json["final_error"]["rotation"], 0.02, 1e-12);
}

TEST(WriteSummary, HasNullForWhatNeverCameToBe) {
  const TemporaryDir dir;
  LocalizationRun run;
  run.samples = {{10.0, Rigid2{}, std::nullopt}};

  writeSummary(run, dir / "summary.json");

  const auto json = nlohmann::json::parse(textOf(dir / "summary.json"));
  EXPECT_EQ(json["samples"], 1);
  for (const char* key :
       {"localized_after", "transform", "ratio", "translation_error", "rotation_error", "final_error"}) {
    EXPECT_TRUE(json.at(key).is_null()) << key << " is " << json.at(key);
  }
}

TEST(WriteSummary, NamesAFileThatCannotBeWritten) {
  const TemporaryDir dir;
  try {
    writeSummary(smallRun(), dir / "absent/summary.json");
    FAIL() << "it was written";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(dir / "absent/summary.json"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace map_matcher
