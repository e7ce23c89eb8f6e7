/// \file
/// What an error says.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace map_matcher::test {

/// The text of the `Error` that the action throws; a failure of the test when it throws none.
template <typename Error, typename Action>
std::string thrownText(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return "";
}

}  // namespace map_matcher::test
