// Names of what the work runs on, for reports.
#pragma once

#include <string>

namespace aureole::cpu {

/// The processor's own name, or "CPU" where the system does not tell.
[[nodiscard]] std::string processor_name();
/// Version of the oneTBB library in use, e.g. "2021.8".
[[nodiscard]] std::string tbb_version();

}  // namespace aureole::cpu
