/// \file
/// The body of every nodelet: parameters and server.
#pragma once

#include <nodelet/nodelet.h>

#include <memory>
#include <stdexcept>

#include "map_matcher/ros/common/run_node.hpp"

namespace map_matcher {

/// Serves as ros_common::runNode() does, in the process of a nodelet manager.
template <typename Server, typename Options>
class ServerNodelet : public nodelet::Nodelet {
  // Throws when a parameter cannot be used; the manager then refuses to load the nodelet.
  void onInit() override {
    Options options;
    if (!ros_common::loadParameters(getPrivateNodeHandle(), parametersOf(options))) {
      throw std::invalid_argument(getName() + ": parameters that cannot be used, see above");
    }
    server_ = std::make_unique<Server>(getNodeHandle(), getPrivateNodeHandle(), options);
  }

  std::unique_ptr<Server> server_;
};

}  // namespace map_matcher
