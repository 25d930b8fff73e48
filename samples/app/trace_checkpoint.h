// What an interrupted trace leaves behind.
#pragma once

#include "app/trace.h"

#include <aureole/parameters.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace aureole::app {

/// Names and values of all that a trace's numbers depend on, in order.
using TraceParameters = std::vector<std::pair<std::string, std::string>>;
/// Every number of the air, lengths in km; in wavelengths, of the air in RGB that they are made of.
[[nodiscard]] TraceParameters describe(const AtmosphereParameters& parameters);
/// "name=value name=value ..." in one line.
[[nodiscard]] std::string print_parameters(const TraceParameters& parameters);

/// Replaces the file as a whole, or not at all. Throws Error(io).
void write_checkpoint(const std::filesystem::path& path, const TraceParameters& parameters, const Tracer& tracer);
/// Lets `tracer` go on from there, to the bit as if it had never stopped. Throws Error: io; invalid_argument for a file that is
/// no checkpoint, and for one of other parameters or directions, naming the first that differs.
void read_checkpoint(const std::filesystem::path& path, const TraceParameters& parameters, Tracer& tracer);

}  // namespace aureole::app
