// Texts that are made of the program's command line: what a shell completes words by, and the manual page.
#pragma once

#include "manual/command_tree.h"

#include <string>
#include <string_view>

namespace aureole::app::manual {

/// Functions that complete the words of `aureole`, in the language of each shell.
[[nodiscard]] std::string bash_completion(const CommandTree& tree);
[[nodiscard]] std::string zsh_completion(const CommandTree& tree);
[[nodiscard]] std::string fish_completion(const CommandTree& tree);

/// Section 1 of the manual, in the macros of man(7).
[[nodiscard]] std::string manual_page(const CommandTree& tree, std::string_view version);

/// `text` with each `from` replaced by `to`.
[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);
/// `words` in one line, `between` between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view between = " ");

}  // namespace aureole::app::manual
