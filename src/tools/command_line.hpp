/// \file
/// What the command-line programs have in common.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::tools {

constexpr int kDone = 0;      ///< Exit status of a program that did what it was asked to.
constexpr int kBadInput = 2;  ///< Exit status when an argument or a file cannot be used.

/// Arguments that cannot be used; the text has a line for each problem, with the option, its value and what was
/// expected.
class ArgumentError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Where the values of an option go. Lists take one value or more; an option with `bool*` takes "true" or "false".
using OptionTarget = std::variant<bool*, int*, double*, std::uint64_t*, std::optional<double>*, std::string*,
                                  std::vector<std::string>*, std::vector<double>*>;

/// An option of a program, "--name". What is asked of it is added by calls one after the other.
class Option {
 public:
  Option(std::string name, OptionTarget target, std::string help);

  Option& required();                                 ///< The program cannot run without it.
  Option& flag();                                     ///< Takes no value: it is true when it is given.
  Option& count(std::size_t count);                   ///< A list of exactly so many values.
  Option& range(double min, double max);              ///< A number within [min, max].
  Option& choices(std::vector<std::string> choices);  ///< One of these texts.
  Option& needs(const Option& other);                 ///< Makes sense with the other only.
  Option& excludes(const Option& other);              ///< Makes no sense with the other.

  const std::string& name() const { return name_; }
  const std::string& help() const { return help_; }
  bool isGiven() const { return times_given_ > 0; }

  std::size_t mostValues() const;   ///< How many values the option takes.
  std::string placeholder() const;  ///< What stands for the values in the help, with the default.
  std::string problem() const;      ///< Why the options that are given do not go together; "" when they do.
  std::string take(const std::vector<std::string>& values);  ///< Sets the target; returns what is wrong, else "".

 private:
  std::string problemWith(const std::vector<std::string>& values) const;
  std::string expectation() const;

  std::string name_;  // with its dashes
  OptionTarget target_;
  std::string help_;
  bool is_required_ = false;
  bool is_flag_ = false;
  int times_given_ = 0;
  std::optional<std::size_t> count_;
  std::optional<std::pair<double, double>> range_;
  std::vector<std::string> choices_;
  std::vector<const Option*> needed_;
  std::vector<const Option*> excluded_;
};

/// The options of a program. What they are read into must outlive the parsing.
class CommandLine {
 public:
  /// `footer` stands below the options in the help.
  CommandLine(std::string program, std::string description, std::string footer);

  /// Adds the option `name`, which has its two dashes. The reference stays good.
  Option& add(const std::string& name, const OptionTarget& target, const std::string& help);

  /// Adds an option "--some-name" for each parameter "some_name", with its meaning, unit, range and default in the
  /// help.
  void addParameters(const parameters::ParameterList& parameters);

  /// Reads the arguments. False when there is nothing to do but to print help(). Throws ArgumentError.
  bool parse(int argc, char** argv);

  const std::string& program() const { return program_; }
  std::string help() const;

 private:
  std::string program_;
  std::string description_;
  std::string footer_;
  std::deque<Option> options_;
};

/// The first value of an option before anything is parsed, for defaults that depend on it; "" when it has none.
std::string firstValueOf(const std::string& option, int argc, char** argv);

/// Parses the arguments and runs the program; help goes to standard output, what is wrong to standard error. Returns
/// the exit status, the program's own when it ends and its output was written. A signal that ends the process removes
/// what the program has not completed; the exit status is then 128 and the signal's number, 130 for SIGINT.
int run(CommandLine& command_line, int argc, char** argv, const std::function<int()>& program);

}  // namespace map_matcher::tools
