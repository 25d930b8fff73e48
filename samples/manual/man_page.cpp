#include "manual/manual.h"

namespace aureole::app::manual {
namespace {

/// Text as it stands: what roff would take for a request, an escape or a hyphen is none.
std::string plain(const std::string& text) {
    std::string result = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    result = replaced(result, "\n", "\n.br\n");
    if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
    return replaced(replaced(result, "\n'", "\n\\&'"), "`", "\\(ga");
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

/// What is to be written for a value: the words it is one of, or what CLI11 calls it.
std::string value_of(const OptionInfo& option) {
    if (!option.choices.empty()) return joined(option.choices, "|");
    const std::size_t colon = option.value.find(':');
    return colon == std::string::npos ? option.value : option.value.substr(colon + 1);
}

std::string entry(const OptionInfo& option) {
    std::string text = ".TP\n";
    for (std::size_t i = 0; i < option.names.size(); ++i) text += (i > 0 ? ", " : "") + bold(option.names[i]);
    if (option.names.empty())
        text += italic(option.place);
    else if (!option.value.empty())
        text += " " + italic(value_of(option));
    text += "\n" + plain(option.description);
    if (option.required) text += " (required)";
    if (!option.usual.empty()) text += " (default: " + plain(option.usual) + ")";
    return text + "\n";
}

/// As it is called: arguments by their place and what cannot be left out.
std::string call_of(const CommandInfo& command) {
    std::string text = bold("aureole " + command.name);
    for (const OptionInfo& option : command.options)
        if (option.required && !option.names.empty()) text += " " + bold(option.names.front()) + " " + italic("VALUE");
    text += " [" + italic("OPTION") + "]...";
    for (const OptionInfo& option : command.options)
        if (option.names.empty()) text += option.required ? " " + italic(option.place) : " [" + italic(option.place) + "]";
    return text;
}

std::string section(const CommandInfo& command) {
    std::string text = ".SS " + plain(command.name) + "\n" + call_of(command) + "\n.PP\n" + plain(command.description) + "\n";
    for (const OptionInfo& option : command.options) text += entry(option);
    return text;
}

}  // namespace

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
    return text;
}

std::string manual_page(const CommandTree& tree, std::string_view version) {
    std::string text =
        ".\\\" Made by `aureole man`.\n.TH AUREOLE 1 \"\" \"aureole " + std::string(version) + "\" \"User Commands\"\n";
    text += ".SH NAME\naureole \\- real\\-time planetary atmospheres on the command line\n";
    text += ".SH SYNOPSIS\n" + bold("aureole") + " [" + italic("OPTION") + "]... " + italic("COMMAND") + " [" +
            italic("ARGUMENT") + "]...\n.br\n" + bold("aureole") + " " + italic("COMMAND") + " " + bold("--help") + "\n";
    text += ".SH DESCRIPTION\n" + plain(tree.program.description) + "\n";
    text += ".SH OPTIONS\n";
    for (const OptionInfo& option : tree.program.options) text += entry(option);
    text += ".SH COMMANDS\n";
    for (const CommandInfo& command : tree.commands) text += section(command);
    text += ".SH NOTES\n.nf\n" + replaced(plain(tree.program.footer), "\n.br\n", "\n") + "\n.fi\n";
    text += ".SH EXIT STATUS\n0, or 2 with one line on standard error that names what is wrong.\n";
    return text;
}

}  // namespace aureole::app::manual
