#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::tools {
namespace {

using test::thrownText;
using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

/// A program with an option of every kind.
struct Program {
  Program() : command_line_("program", "Does something.", "Exit status: 0.") {
    const Option& map = command_line_.add("--map", &map_, "a map");
    const Option& bag = command_line_.add("--bag", &bag_, "a bag").excludes(map);
    command_line_.add("--scan", &scan_, "its topic").needs(bag);
    command_line_.add("--seed", &seed_, "of what is random");
    command_line_.add("--rate", &rate_, "how often").range(0.5, 20.0);
    command_line_.add("--beams", &beams_, "how many");
    command_line_.add("--from", &from_, "when");
    command_line_.add("--search", &search_, "how").choices({"exact", "two_stage"});
    command_line_.add("--pose", &pose_, "where").count(3);
    command_line_.add("--topics", &topics_, "which");
    command_line_.add("--scrub", &scrub_, "whether").flag();
    command_line_.add("--intensity", &intensity_, "whether");
  }

  bool parse(Texts arguments) {
    arguments.insert(arguments.begin(), "program");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
      pointers.push_back(argument.data());
    }
    return command_line_.parse(static_cast<int>(pointers.size()), pointers.data());
  }

  CommandLine command_line_;
  std::string map_;
  std::string bag_;
  std::string scan_;
  std::uint64_t seed_ = 1;
  double rate_ = 15.0;
  int beams_ = 811;
  std::optional<double> from_;
  std::string search_;
  Numbers pose_;
  Texts topics_{"/detections"};
  bool scrub_ = false;
  bool intensity_ = true;
};

class CommandLineTest : public testing::Test, protected Program {
 protected:
  /// What a program says that is run with these arguments.
  static std::string problemWith(const Texts& arguments) {
    return thrownText<ArgumentError>([&] { Program().parse(arguments); });
  }
};

TEST_F(CommandLineTest, readsValuesOfEveryKind) {
  EXPECT_TRUE(parse({"--bag", "a b.bag", "--seed=18446744073709551615", "--rate", "1e1", "--beams=-3", "--from", "-0.5",
                     "--search", "exact", "--pose", "-1", "2.5", "-3e-1", "--scrub", "--intensity", "false", "--scan",
                     "/scan"}));

  EXPECT_EQ(bag_, "a b.bag");
  EXPECT_EQ(scan_, "/scan");
  EXPECT_EQ(seed_, 18446744073709551615U);
  EXPECT_EQ(rate_, 10.0);
  EXPECT_EQ(beams_, -3);
  EXPECT_EQ(from_, -0.5);
  EXPECT_EQ(search_, "exact");
  EXPECT_EQ(pose_, (Numbers{-1.0, 2.5, -0.3}));
  EXPECT_TRUE(scrub_);
  EXPECT_FALSE(intensity_);
}

TEST_F(CommandLineTest, leavesWhatIsNotGivenAsItIs) {
  EXPECT_TRUE(parse({}));

  EXPECT_EQ(seed_, 1U);
  EXPECT_EQ(from_, std::nullopt);
  EXPECT_EQ(topics_, Texts{"/detections"});
  EXPECT_FALSE(scrub_);
}

TEST_F(CommandLineTest, takesAListInOneGoOrInSeveral) {
  EXPECT_TRUE(parse({"--topics", "/a", "/b", "--topics=/c"}));

  EXPECT_EQ(topics_, (Texts{"/a", "/b", "/c"}));
}

TEST_F(CommandLineTest, namesTheOptionItsValueAndWhatWasExpected) {
  EXPECT_EQ(problemWith({"--beams", "many"}), "--beams is many, expected a whole number");
  EXPECT_EQ(problemWith({"--beams", "3.5"}), "--beams is 3.5, expected a whole number");
  EXPECT_EQ(problemWith({"--seed", "-3"}), "--seed is -3, expected a whole number from 0");
  EXPECT_EQ(problemWith({"--from", "1x"}), "--from is 1x, expected a number");
  EXPECT_EQ(problemWith({"--rate", "nan"}), "--rate is nan, expected 0.5 to 20");
  EXPECT_EQ(problemWith({"--rate=21"}), "--rate is 21, expected 0.5 to 20");
  EXPECT_EQ(problemWith({"--search", "magic"}), "--search is magic, expected exact or two_stage");
  EXPECT_EQ(problemWith({"--intensity", "maybe"}), "--intensity is maybe, expected true or false");
  EXPECT_EQ(problemWith({"--pose", "1", "2"}), "--pose is 1 2, expected 3 of them, a number each");
  EXPECT_EQ(problemWith({"--pose", "1", "2", "north"}), "--pose is 1 2 north, expected 3 of them, a number each");
}

TEST_F(CommandLineTest, tellsOfMissingAndRepeatedValues) {
  EXPECT_EQ(problemWith({"--map", "--seed", "1"}), "--map has no value, expected a text");
  EXPECT_EQ(problemWith({"--map", "a", "--map", "b"}), "--map is given 2 times, expected once");
}

TEST_F(CommandLineTest, suggestsTheNearestOption) {
  EXPECT_EQ(problemWith({"--beems", "3"}), "there is no option --beems; did you mean --beams?");
  EXPECT_EQ(problemWith({"--beems=3"}), "there is no option --beems; did you mean --beams?");
  EXPECT_EQ(problemWith({"--nothing-like-it"}), "there is no option --nothing-like-it");
  EXPECT_EQ(problemWith({"--bea", "3"}), "there is no option --bea");
  EXPECT_EQ(problemWith({"--map", "a", "b"}), "'b' belongs to no option");
  EXPECT_EQ(problemWith({"-b", "a"}), "'-b' belongs to no option\n'a' belongs to no option");
}

TEST_F(CommandLineTest, tellsWhatDoesNotGoTogether) {
  EXPECT_EQ(problemWith({"--map", "a", "--bag", "b"}), "--bag and --map are given, expected one of them at most");
  EXPECT_EQ(problemWith({"--scan", "a"}), "--scan is given without --bag, expected both or none");
}

TEST_F(CommandLineTest, tellsAllProblemsAtOnce) {
  std::string output;
  command_line_.add("--output", &output, "file to write").required();

  EXPECT_EQ(thrownText<ArgumentError>([&] {
              parse({"--beams", "many", "--seeed", "1"});
            }),
            "--beams is many, expected a whole number\nthere is no option --seeed; did you mean --seed?\n"
            "--output is missing, expected a text: file to write");
}

TEST_F(CommandLineTest, asksForHelpWhateverElseIsGiven) {
  EXPECT_FALSE(parse({"--beams", "many", "--help"}));
  EXPECT_FALSE(parse({"-h"}));

  const std::string help = command_line_.help();
  for (const char* text : {"Does something.", "Usage: program", "--beams INT (=811)",
                           "--topics TEXT ... (=/detections)", "--map TEXT ", "how many", "Exit status: 0."}) {
    EXPECT_NE(help.find(text), std::string::npos) << text << " is not in:\n" << help;
  }
}

TEST(FirstValue, isFoundBeforeAnythingIsParsed) {
  std::vector<std::string> arguments{"program", "--unknown", "--robot", "pepper", "--robot=pioneer"};
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }

  EXPECT_EQ(firstValueOf("--robot", 5, pointers.data()), "pepper");
  EXPECT_EQ(firstValueOf("--robot", 3, pointers.data()), "");
}

}  // namespace
}  // namespace map_matcher::tools
