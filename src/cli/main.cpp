// mimo: the infant from the command line. Written against mimo.hpp only, like any user's program.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mimo/mimo.hpp>
#include <string>

#include "commands.h"
#include "failure.h"
#include "text.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

// "mimo" or "mimo bench".
std::string command_name(const CLI::App& program) {
  std::string name = program.get_name();
  for (const CLI::App* command : program.get_subcommands()) name += " " + command->get_name();
  return name;
}

// Messages quote what files hold.
int complain(const CLI::App& program, const std::string& message, int code) {
  std::fprintf(stderr, "%s: %s\n", command_name(program).c_str(), cli::one_line(message).c_str());
  return code;
}

// Here and not by require_subcommand(1), which hides what it met instead of a command.
void require_command(const CLI::App& program) {
  if (program.get_subcommands().empty())
    throw CLI::RequiredError("a command (run, bench, info, render, rollout, export, record or replay)");
}

// A full disk shows only here.
void flush_output() {
  std::cout.flush();
  if (!std::cout) throw cli::Failure("cannot write to the standard output");
}

std::string version_text() { return std::string("mimo ") + mimo_version() + " (MuJoCo " + mimo_mujoco_version() + ")"; }

void describe(CLI::App& program) {
  program.set_version_flag("--version", version_text, "Print the versions of libmimo and MuJoCo and exit");
  program.set_help_flag("-h,--help", "Print help and exit");
  program.get_formatter()->column_width(26);
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("REQUIRED", "(required)");
  program.require_subcommand(0, 1);
  cli::add_run(program);
  cli::add_bench(program);
  cli::add_info(program);
  cli::add_render(program);
  cli::add_rollout(program);
  cli::add_export(program);
  cli::add_record(program);
  cli::add_replay(program);
  for (CLI::App* command : program.get_subcommands({})) command->group("Commands");
  program.footer(
      "'mimo COMMAND --help' explains a command.\n"
      "Examples:\n"
      "  mimo run                         ten seconds of random movement; pictures go to mimo_run/\n"
      "  mimo info                        what the infant consists of and what it senses\n"
      "  mimo bench --vision off --json   how fast it runs here");
}

int run(CLI::App& program, int argc, char** argv) {
  try {
    if (mimo_abi_version() != MIMO_ABI_VERSION) {
      throw cli::Failure("libmimo " + std::string(mimo_version()) + " was found, not the one this program needs");
    }
    describe(program);
    program.parse(argc, argv);
    require_command(program);
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

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("MIMo, the multimodal infant model, simulated on MuJoCo", "mimo");
  return run(program, argc, argv);
}
