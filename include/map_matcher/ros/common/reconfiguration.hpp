/// \file
/// Parameters that change while a node runs.
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::ros_common {

/// The parameters with their present values, as dynamic_reconfigure sends them. Lists and maps of texts,
/// which it does not know, are left out.
dynamic_reconfigure::Config configOf(const parameters::ParameterList& parameters);

/// Sets what `config` names, and leaves all else as it is. One sentence for each parameter that has another value now:
/// "name is VALUE now, and was VALUE". Throws std::invalid_argument, with all that is wrong, when a value is out of its
/// range; fields may have changed then.
std::vector<std::string> takeFrom(const dynamic_reconfigure::Config& config,
                                  const parameters::ParameterList& parameters);

/// Logs what changed, or why nothing did.
void tellOfChange(const std::string& change);
void tellOfRefusal(const std::string& reason);

/// Serves the parameters of a node to dynamic_reconfigure: `Config` is the class generated from a file in cfg/, whose
/// names are those of some of parametersOf(Options&).
template <typename Config, typename Options>
class Reconfiguration {
 public:
  /// Makes the node use other options. May throw std::exception that says why it cannot; then all stays as it was.
  using Change = std::function<void(const Options&)>;

  /// `options` are those in use. `change` is called from the node handle's queue.
  Reconfiguration(const ros::NodeHandle& private_node, const Options& options, Change change)
      : options_(options), change_(std::move(change)), server_(private_node) {
    server_.setCallback([this](Config& config, std::uint32_t /*level*/) { onConfig(config); });
  }

 private:
  void onConfig(Config& config) {
    dynamic_reconfigure::Config wanted;
    config.__toMessage__(wanted);
    Options options = options_;
    try {
      const std::vector<std::string> changes = takeFrom(wanted, parametersOf(options));
      if (changes.empty()) {
        return;
      }
      change_(options);
      options_ = options;
      for (const std::string& change : changes) {
        tellOfChange(change);
      }
    } catch (const std::exception& error) {
      tellOfRefusal(error.what());
      dynamic_reconfigure::Config in_use = configOf(parametersOf(options_));
      in_use.groups = wanted.groups;
      config.__fromMessage__(in_use);
    }
  }

  Options options_;
  Change change_;
  dynamic_reconfigure::Server<Config> server_;
};

}  // namespace map_matcher::ros_common
