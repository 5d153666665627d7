#include "programs/program.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mimo/mimo.hpp>
#include <string>

#include "programs/text.h"

namespace cli {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

// Messages quote what files hold.
int complain(const CLI::App& program, const std::string& message, int code) {
  std::fprintf(stderr, "%s: %s\n", command_name(program).c_str(), one_line(message).c_str());
  return code;
}

// A full disk shows only here.
void flush_output() {
  std::cout.flush();
  if (!std::cout) throw Failure("cannot write to the standard output");
}

std::string version_text(const CLI::App& program) {
  return program.get_name() + " " + mimo_version() + " (MuJoCo " + mimo_mujoco_version() + ")";
}

constexpr std::size_t kWidth = 40;
constexpr auto kInterval = std::chrono::milliseconds(100);

}  // namespace

std::string command_name(const CLI::App& program) {
  std::string name = program.get_name();
  for (const CLI::App* command : program.get_subcommands()) name += " " + command->get_name();
  return name;
}

int run_program(CLI::App& program, const std::function<void()>& describe, const std::function<void()>& check, int argc,
                char** argv) {
  try {
    if (mimo_abi_version() != MIMO_ABI_VERSION) {
      throw Failure("libmimo " + std::string(mimo_version()) + " was found, not the one this program needs");
    }
    program.set_version_flag(
        "--version", [&] { return version_text(program); }, "Print the versions of libmimo and MuJoCo and exit");
    program.set_help_flag("-h,--help", "Print help and exit");
    program.get_formatter()->column_width(26);
    describe();
    program.parse(argc, argv);
    check();
    flush_output();
    return 0;
  } catch (const CLI::Success& request) {  // --help, --version
    return program.exit(request);
  } catch (const CLI::ParseError& error) {
    return complain(program, std::string(error.what()) + " (see " + command_name(program) + " --help)", kWrongUsage);
  } catch (const std::exception& error) {
    return complain(program, error.what(), kFailed);
  }
}

Progress::Progress(std::size_t total) : total_(std::max<std::size_t>(total, 1)), visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done) {
  if (!visible_) return;
  const auto now = Clock::now();
  if (now < next_ && done < total_) return;
  next_ = now + kInterval;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done == 0 ? 0 : elapsed * static_cast<double>(total_ - done) / static_cast<double>(done);
  const std::size_t filled = kWidth * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %3zu %%  %.0f s left \033[K", bar.c_str(), 100 * done / total_, left);
}

}  // namespace cli
