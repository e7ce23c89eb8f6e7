/// \file
/// Runs a program of this package as a user would.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace map_matcher::test {

/// What a program did.
struct ProgramRun {
  int exit_status = -1;  ///< -1 when it was ended by a signal.
  std::string output;    ///< Standard output and standard error.
};

/// Runs `program` with these arguments, written as for a shell.
inline ProgramRun runProgram(const std::string& program, const std::string& arguments) {
  FILE* pipe = popen(("'" + program + "' " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error("'" + program + "' cannot be run");
  }
  ProgramRun run;
  std::array<char, 4096> buffer{};
  for (std::size_t size = 0; (size = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    run.output.append(buffer.data(), size);
  }
  const int status = pclose(pipe);
  run.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

}  // namespace map_matcher::test
