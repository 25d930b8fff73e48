// What each pass of a recording does, counted by the CPU backend.
#pragma once

#include "app/backend.h"

#include <aureole/rhi/shader.h>

#include <functional>
#include <map>
#include <string>

namespace aureole::app {

/// Runs what `record` records, each pass by itself, and returns the work between each pass's markers by the name of the pass
/// (PassReport::name). Of markers within markers the outer one counts. The backend counts (BackendOptions::count_work).
[[nodiscard]] std::map<std::string, rhi::CpuCounts> count_passes(Backend& backend,
                                                                 const std::function<void(rhi::CommandList&)>& record);

}  // namespace aureole::app
