#include "map_matcher/evaluation/localization_run.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace map_matcher {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 10;  // a microsecond in a drive of hours, and far below a micrometre in a building

/// Writes a text file. Throws std::runtime_error.
void writeFile(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) {
    throw std::runtime_error("file '" + path + "' cannot be written");
  }
}

Json toJson(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json toJson(const std::optional<Rigid2>& pose) {
  return pose ? Json{{"x", pose->x}, {"y", pose->y}, {"yaw", pose->yaw}} : Json();
}

Json toJson(const std::optional<ErrorStatistics>& statistics) {
  if (!statistics) {
    return {};
  }
  return {{"mean", statistics->mean},
          {"standard_deviation", statistics->standard_deviation},
          {"median", statistics->median},
          {"rms", statistics->rms},
          {"worst", statistics->worst}};
}

Json finalErrorOf(const std::vector<PoseSample>& samples) {
  const auto last =
      std::find_if(samples.rbegin(), samples.rend(), [](const PoseSample& sample) { return sample.estimate; });
  if (last == samples.rend()) {
    return {};
  }
  const PoseError error = errorOf(*last->estimate, last->truth);
  return {{"translation", error.translation}, {"rotation", error.rotation}};
}

}  // namespace

void writeErrors(const LocalizationRun& run, const std::string& csv_path) {
  std::ostringstream text;
  text << std::setprecision(kDigits) << "time,true_x,true_y,true_yaw,x,y,yaw,translation_error,rotation_error\n";
  for (const PoseSample& sample : run.samples) {
    text << sample.time - run.samples.front().time << ',' << sample.truth.x << ',' << sample.truth.y << ','
         << sample.truth.yaw << ',';
    if (sample.estimate) {
      const PoseError error = errorOf(*sample.estimate, sample.truth);
      text << sample.estimate->x << ',' << sample.estimate->y << ',' << sample.estimate->yaw << ',' << error.translation
           << ',' << error.rotation << '\n';
    } else {
      text << ",,,,\n";
    }
  }
  writeFile(csv_path, text.str());
}

void writeSummary(const LocalizationRun& run, const std::string& json_path) {
  const TrajectoryError error = evaluateTrajectory(run.samples);
  Json json;
  json["samples"] = error.samples;
  json["localized_samples"] = error.estimates;
  json["localized_after"] = toJson(error.time_to_first_estimate);
  json["transform"] = toJson(run.T_reference_session);
  json["ratio"] = run.T_reference_session ? Json(run.ratio) : Json();
  json["translation_error"] = toJson(error.translation);
  json["rotation_error"] = toJson(error.rotation);
  json["final_error"] = finalErrorOf(run.samples);
  writeFile(json_path, json.dump(2) + "\n");
}

}  // namespace map_matcher
