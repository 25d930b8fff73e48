// A trace from its first round to its last: with a bar, a checkpoint, and signals that end it in good order.
#pragma once

#include "app/trace_checkpoint.h"

#include <filesystem>
#include <string>

namespace aureole::app {

/// All that the numbers depend on. Neither the wanted error nor the most paths: with others a trace goes further, or less far.
[[nodiscard]] TraceParameters parameters_of(const AtmosphereParameters& air, const TraceSettings& settings, Backend& backend);

/// Traces until every direction is done, with a bar on the standard error. `checkpoint`, unless empty, is written every half
/// minute, at the end, and on SIGHUP, SIGINT or SIGTERM, of which the first ends the work: Error(io) says what is done, and how
/// to go on. A second
/// one ends the program.
void trace_all(Tracer& tracer, const TraceParameters& parameters, const std::filesystem::path& checkpoint,
               const std::string& how_to_go_on = "--resume goes on from there");

}  // namespace aureole::app
