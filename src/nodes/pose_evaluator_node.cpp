// Compares the robot's pose on tf with the true one.

#include "map_matcher/ros/pose_evaluator_server.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::PoseEvaluatorServer, map_matcher::PoseEvaluatorOptions>(argc, argv,
                                                                                                   "pose_evaluator");
}
