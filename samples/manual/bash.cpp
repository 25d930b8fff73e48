#include "manual/manual.h"

namespace aureole::app::manual {
namespace {

// Words up to the cursor are looked at: the first that is a command's name, and the one before, which may want a value. bash
// cuts
// "--backend=cpu" in three words at the "=". Files are what it completes itself where there is nothing of ours (-o default).
constexpr std::string_view head = R"(# bash completion for aureole; made by `aureole completion bash`.
_aureole() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= options= choices= list= i
    COMPREPLY=()
    if [[ $word == = ]]; then
        word=
    elif [[ $before == = && $COMP_CWORD -ge 2 ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
            @commands@) command=${COMP_WORDS[i]}; break ;;
        esac
    done
    case $command in
)";

constexpr std::string_view tail = R"(    esac
    if [[ -n $choices ]]; then
        local kept=
        [[ -z $list || $word != *,* ]] || kept=${word%,*},
        COMPREPLY=($(compgen -P "$kept" -W "$choices" -- "${word##*,}"))
    elif [[ $word == -* || -z $command ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    fi
}
complete -o default -F _aureole aureole
)";

/// What follows an option: a choice, or anything (no choices and no options are offered, so bash offers files).
std::string value_case(const OptionInfo& option) {
    std::string text = "                " + joined(option.names, "|") + ") ";
    if (option.choices.empty())
        text += "[[ $word == -* ]] || return ;;\n";
    else
        text += "choices='" + joined(option.choices) + "'" + (option.list ? " list=yes" : "") + " ;;\n";
    return text;
}

std::string command_case(const CommandInfo& command, const std::string& words) {
    std::string text = "        " + (command.name == "aureole" ? "''" : command.name) + ")\n            case $before in\n";
    std::string options = words, places;
    for (const OptionInfo& option : command.options) {
        for (const std::string& name : option.names) options += (options.empty() ? "" : " ") + name;
        if (!option.names.empty() && !option.value.empty()) text += value_case(option);
        if (option.names.empty() && !option.choices.empty()) places = joined(option.choices);
    }
    if (!places.empty()) text += "                *) [[ $word == -* ]] || choices='" + places + "' ;;\n";
    return text + "            esac\n            options='" + options + "' ;;\n";
}

}  // namespace

std::string bash_completion(const CommandTree& tree) {
    std::vector<std::string> names;
    for (const CommandInfo& command : tree.commands) names.push_back(command.name);
    CommandInfo program = tree.program;
    program.name = "aureole";
    std::string text = replaced(std::string(head), "@commands@", joined(names, "|"));
    text += command_case(program, joined(names));
    for (const CommandInfo& command : tree.commands) text += command_case(command, "");
    return text.append(tail);
}

}  // namespace aureole::app::manual
