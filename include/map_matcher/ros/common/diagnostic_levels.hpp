/// \file
/// The levels of /diagnostics in the type that diagnostic_updater takes them in.
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace map_matcher::ros_common::diagnostics {

constexpr unsigned char kOk = diagnostic_msgs::DiagnosticStatus::OK;
constexpr unsigned char kWarn = diagnostic_msgs::DiagnosticStatus::WARN;
constexpr unsigned char kError = diagnostic_msgs::DiagnosticStatus::ERROR;

}  // namespace map_matcher::ros_common::diagnostics
