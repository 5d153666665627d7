// mimo: the infant from the command line. Written against mimo.hpp only, like any user's program.
#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "programs/program.h"

namespace {

void describe(CLI::App& program) {
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("REQUIRED", "(required)");
  program.require_subcommand(0, 1);
  cli::add_run(program);
  cli::add_info(program);
  cli::add_render(program);
  cli::add_rollout(program);
  cli::add_export(program);
  cli::add_record(program);
  cli::add_replay(program);
  cli::add_new(program);
  cli::add_bench(program);
  for (CLI::App* command : program.get_subcommands({})) command->group("Commands");
  program.footer(
      "'mimo COMMAND --help' explains a command.\n"
      "Examples:\n"
      "  mimo run                         ten seconds of random movement; pictures go to mimo_run/\n"
      "  mimo info                        what the infant consists of and what it senses\n"
      "  mimo render --out mimo.png       a picture of the infant");
}

// Here and not by require_subcommand(1), which hides what it met instead of a command.
void require_command(const CLI::App& program) {
  if (!program.get_subcommands().empty()) return;
  std::string names;
  for (const CLI::App* command : program.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  throw CLI::RequiredError("a command (" + names + ")");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("MIMo, the multimodal infant model, simulated on MuJoCo", "mimo");
  return cli::run_program(
      program, [&] { describe(program); }, [&] { require_command(program); }, argc, argv);
}
