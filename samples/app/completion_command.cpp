#include "app/commands.h"
#include "manual/manual.h"

#include <cstdio>

namespace aureole::app {

void add_completion_command(CLI::App& program) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("completion", "Print what a shell completes the words of this program by");
    command->add_option("SHELL", *shell, "The shell")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->callback([shell, &program] {
        const manual::CommandTree tree = manual::tree_of(program);
        const std::string text = *shell == "bash"  ? manual::bash_completion(tree)
                                 : *shell == "zsh" ? manual::zsh_completion(tree)
                                                   : manual::fish_completion(tree);
        std::fputs(text.c_str(), stdout);
    });
}

}  // namespace aureole::app
