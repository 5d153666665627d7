#include "interrupt.h"

#include <csignal>
#include <cstdlib>

namespace cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

// Who started the program without Ctrl-C (nohup, in the background) keeps it so.
Interrupt::Interrupt() {
  if (std::signal(SIGINT, note) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

Interrupt::~Interrupt() {
  if (std::signal(SIGINT, SIG_DFL) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

bool Interrupt::requested() { return interrupted != 0; }

void Interrupt::pass_on() {
  std::signal(SIGINT, SIG_DFL);
  std::raise(SIGINT);
  std::_Exit(130);  // where the signal is blocked
}

}  // namespace cli
