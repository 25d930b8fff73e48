// Uses the interface and the parameters alone; no backend is linked.
#include <aureole/parameters.h>
#include <aureole/presets.h>
#include <aureole/rhi/error.h>
#include <aureole/rhi/types.h>

#include <cstdio>
#include <cstring>

int main() {
    const aureole::AtmosphereParameters earth = aureole::presets::earth();
    const bool texels = aureole::rhi::bytes_per_texel(aureole::rhi::Format::rgba16_float) == 8;
    const bool names = std::strcmp(aureole::rhi::to_string(aureole::rhi::Format::rgba16_float), "rgba16_float") == 0;
    const bool planet = earth.planet.bottom_radius_m == 6360e3;
    std::printf("rhi and atmosphere without a backend: %s\n", texels && names && planet ? "good" : "wrong");
    return texels && names && planet ? 0 : 1;
}
