// Keeps what the last match of a run looked like.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/evaluation/overlay_recorder.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_evaluation::OverlayRecorder,
                                          map_matcher::ros_evaluation::OverlayRecorderOptions>(argc, argv,
                                                                                               "overlay_recorder");
}
