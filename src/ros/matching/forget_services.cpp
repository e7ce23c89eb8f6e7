#include "map_matcher/ros/matching/forget_services.hpp"

#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {

ForgetServices::ForgetServices(ros::NodeHandle node, ros::NodeHandle private_node,
                               std::function<void(const std::string& service)> forget) {
  using Serve = boost::function<bool(std_srvs::Empty::Request&, std_srvs::Empty::Response&)>;
  const auto serving = [&forget](const std::string& name) -> Serve {
    return [forget, name](std_srvs::Empty::Request& /*request*/, std_srvs::Empty::Response& /*response*/) {
      forget(name);
      return true;
    };
  };
  const std::string global_localization = ros_common::names::kGlobalLocalization;
  const std::string reset = ros_common::names::kReset;
  global_localization_ = node.advertiseService(global_localization, serving(node.resolveName(global_localization)));
  reset_ = private_node.advertiseService(reset, serving(private_node.resolveName(reset)));
}

}  // namespace map_matcher::ros_matching
