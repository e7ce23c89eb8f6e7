// Records how well the robot is localized, against a ground truth.

#include "map_matcher/ros/localization_recorder.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  using namespace map_matcher;
  return runNode<LocalizationRecorder, LocalizationRecorderOptions>(argc, argv, "localization_recorder");
}
