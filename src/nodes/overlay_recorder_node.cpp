// Keeps what the last match of a run looked like.

#include "map_matcher/ros/overlay_recorder.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::OverlayRecorder, map_matcher::OverlayRecorderOptions>(argc, argv,
                                                                                                 "overlay_recorder");
}
