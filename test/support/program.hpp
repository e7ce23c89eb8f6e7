/// \file
/// Runs a program of this package as a user would.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

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

/// A program that runs beside the test, its output thrown away.
class ProgramProcess {
 public:
  ProgramProcess(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
      pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    process_ = fork();
    if (process_ < 0) {
      throw std::runtime_error("'" + program + "' cannot be run");
    }
    if (process_ == 0) {
      for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        std::signal(signal, SIG_DFL);  // which a test in the background ignores
      }
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
      execv(pointers[0], pointers.data());
      _exit(127);
    }
  }
  ~ProgramProcess() {
    if (process_ > 0) {
      end(SIGKILL);
    }
  }
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  /// Sends the signal and returns the exit status, -1 when the signal ended the process.
  int end(int signal) {
    kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
};

}  // namespace map_matcher::test
