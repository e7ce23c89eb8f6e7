#include "command_line.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>
#include <string_view>
#include <utility>

#include "argument_text.hpp"
#include "ending.hpp"
#include "map_matcher/parameters/nearest_name.hpp"
#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::tools {
namespace {

namespace po = boost::program_options;

constexpr std::size_t kMany = 1000000;  // values of a list
constexpr unsigned kHelpWidth = 120;

/// How many values an option takes and what the help calls them. The values themselves are read from the parser: what
/// it would say about a wrong one names neither the value nor what was expected.
class Values : public po::value_semantic {
 public:
  Values(std::string name, std::size_t most) : name_(std::move(name)), most_(static_cast<unsigned>(most)) {}

  std::string name() const override { return name_; }
  unsigned min_tokens() const override { return 0; }  // a missing value is found out, and told, later
  unsigned max_tokens() const override { return most_; }
  bool adjacent_tokens_only() const { return false; }  // no override: some versions of Boost have it, some do not
  bool is_composing() const override { return true; }
  bool is_required() const override { return false; }
  void parse(boost::any& /*store*/, const std::vector<std::string>& /*tokens*/, bool /*utf8*/) const override {}
  bool apply_default(boost::any& /*store*/) const override { return false; }
  void notify(const boost::any& /*store*/) const override {}

 private:
  std::string name_;
  unsigned most_;
};

template <typename Options>
po::options_description described(const Options& options) {
  po::options_description description("Options", kHelpWidth, kHelpWidth / 2);
  description.add_options()("help", new Values("", 0), "Print this help and exit");
  for (const Option& option : options) {
    // The description takes the ownership of the Values.
    description.add_options()(option.name().substr(2).c_str(), new Values(option.placeholder(), option.mostValues()),
                              option.help().c_str());
  }
  return description;
}

/// The arguments as options with their values, in their order. Throws ArgumentError.
std::vector<po::option> parsed(const po::options_description& description, int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::replace(arguments.begin(), arguments.end(), std::string("-h"), std::string("--help"));
  try {
    // No short options: "-1.5" is a number. No guessing: what an abbreviation means changes with a new option.
    constexpr int kStyle = po::command_line_style::allow_long | po::command_line_style::long_allow_adjacent |
                           po::command_line_style::long_allow_next;
    return po::command_line_parser(arguments).options(description).style(kStyle).allow_unregistered().run().options;
  } catch (const po::error& error) {
    throw ArgumentError(error.what());
  }
}

std::string optionName(const std::string& parameter) {
  std::string name = "--" + parameter;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

Option::Option(std::string name, OptionTarget target, std::string help)
    : name_(std::move(name)), target_(target), help_(std::move(help)) {}

Option& Option::required() {
  is_required_ = true;
  return *this;
}

Option& Option::flag() {
  is_flag_ = true;
  return *this;
}

Option& Option::count(std::size_t count) {
  count_ = count;
  return *this;
}

Option& Option::range(double min, double max) {
  range_ = {min, max};
  return *this;
}

Option& Option::choices(std::vector<std::string> choices) {
  choices_ = std::move(choices);
  return *this;
}

Option& Option::needs(const Option& other) {
  needed_.push_back(&other);
  return *this;
}

Option& Option::excludes(const Option& other) {
  excluded_.push_back(&other);
  return *this;
}

std::size_t Option::mostValues() const {
  if (is_flag_) {
    return 0;
  }
  return isList(target_) ? kMany : 1;
}

std::string Option::placeholder() const {
  if (is_flag_) {
    return "";
  }
  const std::string text = textOf(target_);
  return kindOf(target_) + (text.empty() ? "" : " (=" + text + ")");
}

std::string Option::expectation() const {
  std::string expected;
  for (const std::string& choice : choices_) {
    expected += (expected.empty() ? "" : " or ") + choice;
  }
  if (range_) {
    expected = parameters::numberText(range_->first) + " to " + parameters::numberText(range_->second);
  }
  if (expected.empty()) {
    expected = expectedFor(target_);
  }
  return count_ ? std::to_string(*count_) + " of them, " + expected + " each" : expected;
}

std::string Option::problemWith(const std::vector<std::string>& values) const {
  if (values.empty()) {
    return name_ + " has no value, expected " + expectation();
  }
  const bool is_chosen =
      choices_.empty() || std::find(choices_.begin(), choices_.end(), values.front()) != choices_.end();
  if (!is_chosen || (count_ && values.size() != *count_) || !isReadable(values, target_)) {
    return name_ + " is " + joined(values) + ", expected " + expectation();
  }
  return "";
}

std::string Option::take(const std::vector<std::string>& values) {
  ++times_given_;
  if (is_flag_) {
    *std::get<bool*>(target_) = true;
    return "";
  }
  if (times_given_ > 1 && (!isList(target_) || count_)) {
    return name_ + " is given " + std::to_string(times_given_) + " times, expected once";
  }
  std::string problem = problemWith(values);
  if (!problem.empty()) {
    return problem;
  }
  read(values, target_, times_given_ == 1);
  const double* number = std::holds_alternative<double*>(target_) ? std::get<double*>(target_) : nullptr;
  if (range_ && number != nullptr && !(*number >= range_->first && *number <= range_->second)) {
    return name_ + " is " + joined(values) + ", expected " + expectation();
  }
  return "";
}

std::string Option::problem() const {
  if (!isGiven()) {
    return is_required_ ? name_ + " is missing, expected " + expectation() + ": " + help_ : "";
  }
  for (const Option* other : needed_) {
    if (!other->isGiven()) {
      return name_ + " is given without " + other->name() + ", expected both or none";
    }
  }
  for (const Option* other : excluded_) {
    if (other->isGiven()) {
      return name_ + " and " + other->name() + " are given, expected one of them at most";
    }
  }
  return "";
}

CommandLine::CommandLine(std::string program, std::string description, std::string footer)
    : program_(std::move(program)), description_(std::move(description)), footer_(std::move(footer)) {}

Option& CommandLine::add(const std::string& name, const OptionTarget& target, const std::string& help) {
  return options_.emplace_back(name, target, help);
}

void CommandLine::addParameters(const parameters::ParameterList& parameters) {
  for (const parameters::Parameter& parameter : parameters) {
    const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
    const std::string help = parameter.description + " [" + parameters::rangeText(parameter) + unit + "]";
    std::visit(
        [&](auto* value) {
          if constexpr (std::is_constructible_v<OptionTarget,
                                                decltype(value)>) {  // there is no option of texts by name
            add(optionName(parameter.name), value, help);
          }
        },
        parameter.value);
  }
}

bool CommandLine::parse(int argc, char** argv) {
  const std::vector<po::option> given = parsed(described(options_), argc, argv);
  const auto is_help = [](const po::option& option) { return option.string_key == "help"; };
  if (std::any_of(given.begin(), given.end(), is_help)) {
    return false;
  }
  std::vector<std::string> problems;
  std::vector<std::string> names;
  for (const Option& option : options_) {
    names.push_back(option.name());
  }
  bool follows_unknown = false;
  for (const po::option& argument : given) {
    const std::string name = "--" + argument.string_key;
    const auto option =
        std::find_if(options_.begin(), options_.end(), [&name](const Option& known) { return known.name() == name; });
    if (option != options_.end()) {
      problems.push_back(option->take(argument.value));
      follows_unknown = false;
    } else if (!argument.string_key.empty()) {
      const std::optional<std::string> nearest = parameters::nearestName(name, names);
      problems.push_back("there is no option " + name + (nearest ? "; did you mean " + *nearest + "?" : ""));
      follows_unknown = true;
    } else if (!follows_unknown) {  // it may be the unknown option's value
      problems.push_back("'" + joined(argument.original_tokens) + "' belongs to no option");
    }
  }
  for (const Option& option : options_) {
    problems.push_back(option.problem());
  }
  problems.erase(std::remove(problems.begin(), problems.end(), ""), problems.end());
  if (!problems.empty()) {
    throw ArgumentError(joined(problems, "\n"));
  }
  return true;
}

std::string CommandLine::help() const {
  std::ostringstream text;
  text << description_ << "\n\nUsage: " << program_ << " OPTIONS\n\n" << described(options_) << '\n' << footer_ << '\n';
  return text.str();
}

std::string firstValueOf(const std::string& option, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == option && i + 1 < argc) {
      return argv[i + 1];
    }
    if (argument.substr(0, option.size() + 1) == option + "=") {
      return std::string(argument.substr(option.size() + 1));
    }
  }
  return "";
}

int run(CommandLine& command_line, int argc, char** argv, const std::function<int()>& program) {
  endCleanlyOnSignals();
  try {
    int status = kDone;
    if (command_line.parse(argc, argv)) {
      status = program();
    } else {
      std::cout << command_line.help();
    }
    requireWrittenOutput();
    return status;
  } catch (const ArgumentError& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      std::cerr << command_line.program() << ": " << problem << '\n';
    }
    std::cerr << command_line.program() << " --help lists the options\n";
  } catch (const std::exception& error) {
    std::cerr << command_line.program() << ": " << error.what() << '\n';
  }
  return kBadInput;
}

}  // namespace map_matcher::tools
