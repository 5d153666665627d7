#include "programs/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mimo/mimo.hpp>

#include "programs/failure.h"
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

}  // namespace cli
