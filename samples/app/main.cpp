// The command-line application `aureole`.
#include "app/run_program.h"

int main(int argc, char** argv) { return aureole::app::run_program(argc, argv); }
