// What each pass took, from the device's own clock.
#pragma once

#include "app/backend.h"

#include <aureole/atmosphere.h>

#include <string>
#include <vector>

namespace aureole::app {

struct PassTime {
    std::string name;
    double milliseconds = 0;
};

/// Time stamps of one atmosphere and one view: at most 16 passes and 8 passes.
inline constexpr TimestampSlots air_slots{true, 0};
inline constexpr TimestampSlots view_slots{true, 32};
inline constexpr std::size_t slot_count = 48;

/// Slots if the device has a clock, none otherwise.
[[nodiscard]] TimestampSlots if_supported(Backend& backend, TimestampSlots slots);
/// Appends the times of those passes that the latest run has recorded; nothing if the device has no clock.
void collect_times(Backend& backend, std::span<const PassReport> reports, TimestampSlots slots, std::vector<PassTime>& times);
/// Adds times of passes to those of the same name from `first` on, or appends them.
void add_times(const std::vector<PassTime>& part, std::vector<PassTime>& times, std::size_t first);
/// "transmittance 0.21 ms, multi_scatter 3.02 ms, ..."
[[nodiscard]] std::string print_times(const std::vector<PassTime>& times);

}  // namespace aureole::app
