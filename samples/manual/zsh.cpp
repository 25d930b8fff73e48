#include "manual/manual.h"

namespace aureole::app::manual {
namespace {

/// In a specification of _arguments brackets end the description and a colon ends the message; a quote would end the word.
std::string escaped(std::string text) {
    for (const char* c : {"\\", "[", "]", ":"}) text = replaced(text, c, "\\" + std::string(c));
    return replaced(text, "'", "'\\''");
}

/// What follows: one of the words, several of them, or a file.
std::string action_of(const OptionInfo& option) {
    if (option.choices.empty()) return "_files";
    const std::string words = joined(option.choices);
    return option.list ? "_values -s , value " + words : "(" + words + ")";
}

std::string specification(const OptionInfo& option) {
    if (option.names.empty()) return "'*:" + escaped(option.place) + ":" + action_of(option) + "'";
    std::string text = "'(" + joined(option.names) + ")'";
    text += option.names.size() > 1 ? "{" + joined(option.names, ",") + "}" : option.names.front();
    text += "'[" + escaped(option.description) + "]";
    if (!option.value.empty()) text += ":value:" + action_of(option);
    return text + "'";
}

std::string arguments(const CommandInfo& command, const std::string& indent) {
    std::string text;
    for (const OptionInfo& option : command.options) text += " \\\n" + indent + specification(option);
    return text;
}

}  // namespace

std::string zsh_completion(const CommandTree& tree) {
    std::string text =
        "#compdef aureole\n# zsh completion for aureole; made by `aureole completion zsh`.\n_aureole() {\n"
        "    local context state line\n    local -a commands=(\n";
    for (const CommandInfo& command : tree.commands)
        text += "        '" + command.name + ":" + replaced(command.description, "'", "'\\''") + "'\n";
    text += "    )\n    _arguments -C" + arguments(tree.program, "        ") +
            " \\\n        '1:command:->command' '*::argument:->argument'\n    case $state in\n"
            "        command) _describe command commands ;;\n        argument)\n            case $words[1] in\n";
    for (const CommandInfo& command : tree.commands)
        text += "                " + command.name + ") _arguments" + arguments(command, "                    ") + " ;;\n";
    return text + "            esac ;;\n    esac\n}\n_aureole \"$@\"\n";
}

}  // namespace aureole::app::manual
