#include "processor.h"

#include <oneapi/tbb/version.h>

#include <fstream>

namespace aureole::cpu {

std::string processor_name() {
    // Linux tells it here; elsewhere the file is missing.
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "CPU";
}

std::string tbb_version() {
    // The library counts its interfaces: 12080 is 2021.8.
    const int interface = TBB_runtime_interface_version();
    return std::to_string(2021 + (interface / 1000 - 12)) + "." + std::to_string(interface % 1000 / 10);
}

}  // namespace aureole::cpu
