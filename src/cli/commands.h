// The commands of the program. Each function adds one to the parser; it runs when the parser has met it.
#pragma once

namespace CLI {
class App;
}

namespace cli {

void add_run(CLI::App& program);
void add_info(CLI::App& program);
void add_render(CLI::App& program);
void add_rollout(CLI::App& program);
void add_export(CLI::App& program);
void add_record(CLI::App& program);
void add_replay(CLI::App& program);

}  // namespace cli
