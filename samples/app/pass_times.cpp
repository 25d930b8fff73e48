#include "app/pass_times.h"

#include <algorithm>
#include <cstdio>

namespace aureole::app {

TimestampSlots if_supported(Backend& backend, TimestampSlots slots) {
    return backend.device().capabilities().timestamp_slots >= slot_count ? slots : TimestampSlots{};
}

void collect_times(Backend& backend, std::span<const PassReport> reports, TimestampSlots slots, std::vector<PassTime>& times) {
    if (!if_supported(backend, slots).enabled) return;
    std::vector<double> nanoseconds(slot_count);
    backend.device().read_timestamps(nanoseconds);
    for (std::size_t i = 0; i < reports.size(); ++i) {
        if (!reports[i].recorded) continue;
        const std::size_t first = slots.first + 2 * i;
        times.push_back({std::string(reports[i].name), (nanoseconds[first + 1] - nanoseconds[first]) * 1e-6});
    }
}

void add_times(const std::vector<PassTime>& part, std::vector<PassTime>& times, std::size_t first) {
    for (const PassTime& time : part) {
        const auto found = std::find_if(times.begin() + static_cast<std::ptrdiff_t>(first), times.end(),
                                        [&](const PassTime& other) { return other.name == time.name; });
        if (found == times.end())
            times.push_back(time);
        else
            found->milliseconds += time.milliseconds;
    }
}

std::string print_times(const std::vector<PassTime>& times) {
    std::string text;
    for (const PassTime& time : times) {
        char number[64];
        std::snprintf(number, sizeof number, " %.2f ms", time.milliseconds);
        text += (text.empty() ? "" : ", ") + time.name + number;
    }
    return text.empty() ? "this device has no clock" : text;
}

}  // namespace aureole::app
