#include "app/commands.h"
#include "manual/manual.h"

#include <cstdio>

namespace aureole::app {

void add_man_command(CLI::App& program) {
    CLI::App* command = program.add_subcommand("man", "Print the manual page of this program: aureole man | man -l -");
    command->callback(
        [&program] { std::fputs(manual::manual_page(manual::tree_of(program), AUREOLE_VERSION).c_str(), stdout); });
}

}  // namespace aureole::app
