#include "app/speed.h"

#include "app/pass_costs.h"

#include <aureole/presets.h>

#include <algorithm>
#include <cmath>

namespace aureole::app {

DeviceSpeed measure_speed(Backend& backend, double seconds) {
    Prepared prepared = prepare(speed_setting(), presets::earth()).value();
    const CostSubject subject{"calibration", std::move(prepared.air), std::move(prepared.model)};
    PassCostOptions options;
    options.geometry = options.counts = false;
    const auto run = [&](std::uint32_t frames, std::uint32_t warm_up) {
        options.frames = frames;
        options.warm_up = warm_up;
        return pass_costs(backend, {&subject, 1}, options, [] {}).at(0);
    };
    const PassCosts first = run(1, 1);
    const double round_ms = std::max(first.rebuild.median + first.pass("composite").milliseconds.median, 1e-3);
    const PassCosts found =
        run(static_cast<std::uint32_t>(std::clamp(std::floor(1000 * seconds / round_ms) - 2, 3.0, 1000.0)), 1);
    return calibrated({found.pass("composite").milliseconds.median, found.rebuild.median});
}

}  // namespace aureole::app
