#include "ending.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "map_matcher/files/output_file.hpp"

namespace map_matcher::tools {
namespace {

constexpr int kEndedBySignal = 128;  // and its number, as a shell has it

extern "C" void endOnSignal(int signal) {
  files::removePendingFiles();
  _exit(kEndedBySignal + signal);
}

}  // namespace

void endCleanlyOnSignals() {
  for (const int signal : {SIGHUP, SIGINT, SIGPIPE, SIGTERM}) {
    if (std::signal(signal, endOnSignal) == SIG_IGN) {  // by nohup, or in the background
      std::signal(signal, SIG_IGN);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

void requireWrittenOutput() {
  errno = 0;
  if (!std::cout.flush()) {
    throw std::runtime_error("standard output cannot be written" +
                             (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()));
  }
}

}  // namespace map_matcher::tools
