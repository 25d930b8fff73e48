// The program's command line as plain data, read from the options that it parses by: what shells complete and what the manual
// says cannot be anything else than what the program takes.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aureole::app::manual {

struct OptionInfo {
    std::vector<std::string> names;    ///< With their dashes, short ones first; none: an argument by its place.
    std::string place;                 ///< What such an argument is called.
    std::string value;                 ///< What is to follow, as "TEXT" or "UINT:1 to 4"; empty: nothing does.
    std::vector<std::string> choices;  ///< What may follow, where that is one of a few words.
    std::string usual;                 ///< What counts if it is not given; empty: the description says.
    std::string description;
    bool list = false;  ///< Several values, separated by commas.
    bool required = false;
};

struct CommandInfo {
    std::string name, description;
    std::string footer;  ///< Said below the options.
    std::vector<OptionInfo> options;
};

struct CommandTree {
    CommandInfo program;
    std::vector<CommandInfo> commands;  ///< In the order of the program's help.
};

[[nodiscard]] CommandTree tree_of(const CLI::App& program);

}  // namespace aureole::app::manual
