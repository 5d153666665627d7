#include <csignal>
#include <cstdlib>

#include "cli/commands.h"

namespace cli {
namespace {

constexpr int kSignals[] = {
    SIGINT,
    SIGTERM,
#ifdef SIGHUP
    SIGHUP,
#endif
};

volatile std::sig_atomic_t interrupted = 0;  // by which signal

void note(int signal) {
  interrupted = signal;
  for (const int any : kSignals) std::signal(any, SIG_DFL);
}

// Who started the program without such a signal (nohup, in the background) keeps it so.
void handle(void (*handler)(int)) {
  for (const int signal : kSignals) {
    if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

}  // namespace

Interrupt::Interrupt() { handle(note); }

Interrupt::~Interrupt() { handle(SIG_DFL); }

bool Interrupt::requested() { return interrupted != 0; }

void Interrupt::pass_on() {
  const int signal = interrupted;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::_Exit(128 + signal);  // where the signal is blocked
}

}  // namespace cli
