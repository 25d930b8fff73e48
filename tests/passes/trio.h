// The same atmosphere and view on CPU float, CPU double and Vulkan, and how far their tables are apart.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "passes/compare.h"
#include "passes/rig.h"

namespace aureole::passes {

/// Opened once for a test. Without a Vulkan device the tests compare the CPU's two precisions, and say so.
struct Backends {
    std::unique_ptr<Backend> single = open_cpu_float(), exact = open_cpu_double(), vulkan = open_vulkan();

    /// Calls `act` with each.
    template <class Act>
    void each(const Act& act) {
        act(*single);
        act(*exact);
        if (vulkan) act(*vulkan);
    }
};

/// One table as each backend has it.
struct Images {
    Image single, exact;
    std::optional<Image> vulkan;

    /// Empty, or what is wrong with one of them (compare.h).
    [[nodiscard]] std::string unsound(bool signed_too = false) const;
};

/// R: AirRig or Rig.
template <class R>
class Trio {
public:
    Trio(Backends& backends, const Setup& setup) : single(*backends.single, setup), exact(*backends.exact, setup) {
        if (backends.vulkan) vulkan.emplace(*backends.vulkan, setup);
    }
    /// Calls `act` with each rig.
    template <class Act>
    void each(const Act& act) {
        act(single);
        act(exact);
        if (vulkan) act(*vulkan);
    }
    void record_air() {
        each([](R& rig) { rig.record_air(); });
    }
    /// Gives all of them the CPU float's tables that follow from the air alone: what is recorded then is a comparison of its
    /// own pass, without what went before.
    void share_air() {
        const Image transmittance = single.transmittance();
        each([&](R& rig) { rig.backend.write(rig.air.transmittance_table(), transmittance); });
        if (!single.air.multi_scatter_table()) return;
        const Image multi_scatter = single.multi_scatter();
        each([&](R& rig) { rig.backend.write(rig.air.multi_scatter_table(), multi_scatter); });
    }
    [[nodiscard]] Images read(Image (R::*table)()) {
        Images images{(single.*table)(), (exact.*table)(), {}};
        if (vulkan) images.vulkan = ((*vulkan).*table)();
        return images;
    }

    R single, exact;
    std::optional<R> vulkan;
};

/// Gives all of them the CPU float's tables of the view.
void share_view(Trio<Rig>& trio);

/// "earth, 2 m, sun at 45 deg"
[[nodiscard]] std::string place_name(std::string_view preset, double altitude_m, double elevation_deg);

/// Records the view at every altitude and hour (rig.h), and calls `visit(where)` after each.
template <class Visit>
void sweep(Trio<Rig>& trio, std::string_view preset, const Visit& visit) {
    const Planet& planet = trio.single.setup.air.planet;
    for (const double altitude : altitudes_m(planet)) {
        for (const double elevation : elevations_deg()) {
            trio.each([&](Rig& rig) { rig.record_view(camera_at(planet, altitude), sun_at(elevation)); });
            visit(place_name(preset, altitude, elevation));
        }
    }
}

/// Worst differences: of Vulkan from CPU float, and of CPU float from CPU double.
struct Precision {
    Worst vulkan, exact;

    /// `with_exact`: how CPU float and CPU double are compared.
    void compare(const Images& images, std::uint32_t begin, std::uint32_t count, const Measure& with_vulkan,
                 const Measure& with_exact, std::string_view where);
    void compare(const Images& images, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                 std::string_view where) {
        compare(images, begin, count, measure, measure, where);
    }
    void compare(const Images& images, const Measure& measure, std::string_view where) {
        compare(images, 0, images.single.extent.height, measure, where);
    }
    /// Prints the row and checks both against their bounds.
    void check(std::string_view pass, std::string_view what, double vulkan_bound, double exact_bound) const;
};

}  // namespace aureole::passes
