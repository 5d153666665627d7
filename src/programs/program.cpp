#include "programs/program.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "common/nearest.h"
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

std::vector<std::string> options_of(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::Option* option : program.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> commands_of(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string did_you_mean(const std::string& wanted, const std::vector<std::string>& names) {
  const std::string meant = mimo::nearest(wanted, names);
  return meant.empty() ? "" : "; did you mean " + meant + "?";
}

// About the first argument that nobody took: CLI11 would quote all of them, the last one first.
std::string unexpected(const CLI::App& program) {
  const std::vector<CLI::App*> given = program.get_subcommands();
  const CLI::App& at = given.empty() ? program : *given.back();
  const std::string argument = at.remaining().empty() ? "" : at.remaining().front();
  const std::string option = argument.substr(0, argument.find('='));
  const auto has_option = [&](const CLI::App* command) { return command->get_option_no_throw(option) != nullptr; };
  const std::vector<const CLI::App*> commands = at.get_subcommands({});
  if (option.rfind('-', 0) != 0) {
    return commands.empty() ? "'" + argument + "' is not an option; this command takes only options"
                            : "there is no command " + argument + did_you_mean(argument, commands_of(at));
  }
  if (const auto found = std::find_if(commands.begin(), commands.end(), has_option); found != commands.end()) {
    return option + " belongs behind a command, such as " + (*found)->get_name();
  }
  return "there is no option " + option + did_you_mean(option, options_of(at));
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
    const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    const std::string what = extra ? unexpected(program) : error.what();
    return complain(program, what + " (see " + command_name(program) + " --help)", kWrongUsage);
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
