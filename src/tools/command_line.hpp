/// \file
/// What the command-line programs have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::tools {

constexpr int kDone = 0;      ///< Exit status of a program that did what it was asked to.
constexpr int kBadInput = 2;  ///< Exit status when an argument or a file cannot be used.

/// An option "--some-name" for each parameter "some_name", with its meaning, unit, range and default in the help. The
/// fields that the parameters point at must outlive the parsing.
void addOptions(CLI::App& app, const ParameterList& parameters);

/// An option for the seed of random numbers; returned to be described further.
CLI::Option* addSeed(CLI::App& app, const std::string& name, std::uint64_t& seed, const std::string& help);

/// Parses the arguments and runs the program; help goes to standard output, what is wrong to standard error. Returns
/// the exit status, the program's own when it ends.
int run(CLI::App& app, int argc, char** argv, const std::function<int()>& program);

}  // namespace map_matcher::tools
