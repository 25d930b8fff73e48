// All that the program does, for a main that need not see the library of its command line.
#pragma once

namespace aureole::app {

/// The exit code: 0, or 2 after one line on stderr.
[[nodiscard]] int run_program(int argc, char** argv);

}  // namespace aureole::app
