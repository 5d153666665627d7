// Ctrl-C, and what batch systems and closing terminals send: the first such signal asks for an early end, which leaves
// time to report and to close files; the second one ends the program at once.
#pragma once

namespace cli {

class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested();
  // Ends the program as the signal would have, so that a script that called it ends, too.
  [[noreturn]] static void pass_on();
};

}  // namespace cli
