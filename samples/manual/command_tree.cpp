#include "manual/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace aureole::app::manual {
namespace {

/// CLI11 says the words of IsMember in braces, behind the type's name.
std::vector<std::string> choices_in(const std::string& type) {
    const std::size_t begin = type.find('{'), end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
    return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

OptionInfo info_of(const CLI::Option& option) {
    OptionInfo info;
    for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
    if (info.names.empty()) info.place = option.get_name(true);
    if (option.get_items_expected_max() > 0) info.value = option.get_type_name();
    info.choices = choices_in(info.value);
    info.usual = option.get_default_str();
    info.description = option.get_description();
    info.list = option.get_delimiter() == ',';
    info.required = option.get_required();
    return info;
}

CommandInfo info_of(const CLI::App& command) {
    CommandInfo info{command.get_name(), command.get_description(), command.get_footer(), {}};
    const auto all = command.get_options([](const CLI::Option*) { return true; });
    std::transform(all.begin(), all.end(), std::back_inserter(info.options), [](const CLI::Option* o) { return info_of(*o); });
    return info;
}

}  // namespace

CommandTree tree_of(const CLI::App& program) {
    CommandTree tree{info_of(program), {}};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        tree.commands.push_back(info_of(*command));
    return tree;
}

}  // namespace aureole::app::manual
