// Compares the robot's pose on tf with the true one.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/evaluation/pose_evaluator_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_evaluation::PoseEvaluatorServer,
                                          map_matcher::ros_evaluation::PoseEvaluatorOptions>(argc, argv,
                                                                                             "pose_evaluator");
}
