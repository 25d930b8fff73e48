#include "manual/manual.h"

namespace aureole::app::manual {
namespace {

std::string quoted(const std::string& text) { return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'"; }

std::string line_of(const OptionInfo& option, const std::string& condition) {
    std::string text = "complete -c aureole -n " + quoted(condition);
    if (option.names.empty())  // words by their place are offered beside files, which fish offers itself
        return option.choices.empty() ? "" : text + " -f -a " + quoted(joined(option.choices)) + "\n";
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.choices.empty())
        text += " -x -a " + quoted(joined(option.choices));
    else if (!option.value.empty())
        text += " -r -F";
    return text + " -d " + quoted(option.description) + "\n";
}

}  // namespace

std::string fish_completion(const CommandTree& tree) {
    std::string text = "# fish completion for aureole; made by `aureole completion fish`.\n";
    for (const OptionInfo& option : tree.program.options) text += line_of(option, "__fish_use_subcommand");
    for (const CommandInfo& command : tree.commands) {
        text +=
            "complete -c aureole -n __fish_use_subcommand -f -a " + command.name + " -d " + quoted(command.description) + "\n";
        for (const OptionInfo& option : command.options) text += line_of(option, "__fish_seen_subcommand_from " + command.name);
    }
    return text;
}

}  // namespace aureole::app::manual
