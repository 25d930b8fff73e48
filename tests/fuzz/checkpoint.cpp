// What an interrupted `aureole trace` leaves behind.
#include "fuzz.h"

#include "app/trace_checkpoint.h"

#include <aureole/presets.h>

using namespace aureole;

namespace {

/// Everything that is read, but for the states, must be what the tracer has: few words, so that inputs are short.
const app::TraceParameters parameters{{"seed", "3"}, {"orders", "2"}};

app::Tracer make_tracer() {
    static const std::unique_ptr<app::Backend> backend = app::open_backend({.name = "cpu", .threads = 1});
    return {*backend, presets::airless(), {{60, 0.2, 120, 90}, {92, 10, 85, 0}}, {.error = 1, .orders = 2}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static app::Tracer tracer = make_tracer(), again = make_tracer();
    const std::filesystem::path path = fuzz::file_of(data, size, "trace.json");
    const std::vector<app::TraceState> before = tracer.states();
    if (!fuzz::accepts([&] { app::read_checkpoint(path, parameters, tracer); })) {
        fuzz::require(tracer.states() == before, "what is refused changes nothing");
        return 0;
    }
    for (std::size_t row = 0; row < tracer.rows().size(); ++row) {
        (void)tracer.result(row);
        (void)tracer.reached(row);
    }
    fuzz::require(tracer.share() >= 0 && tracer.share() <= 1, "a share is one");
    app::write_checkpoint(path, parameters, tracer);
    app::read_checkpoint(path, parameters, again);
    fuzz::require(again.states() == tracer.states(), "what was read is written to the bit");
    return 0;
}
