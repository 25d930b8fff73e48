// The multi-scatter pass on every backend, and its fixed point spread over frames.
#include <doctest/doctest.h>

#include "models/aureole/aureole.h"
#include "module/air.h"
#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

struct Variant {
    rhi::Extent size;
    int order, zenith, azimuth, nodes, orders;
};

Setup setup_of(const char* preset, const Variant& variant) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.quality.transmittance = {40, 12, 1};
    setup.quality.multi_scatter = variant.size;
    setup.quality.angular_order = variant.order;
    setup.quality.multi_scatter_zenith = variant.zenith;
    setup.quality.multi_scatter_azimuth = variant.azimuth;
    setup.quality.multi_scatter_nodes = setup.quality.multi_scatter_later_nodes = variant.nodes;
    setup.quality.multi_scatter_orders = variant.orders;
    return setup;
}

/// Mean radiance, ratios of moments, irradiance of the ground.
struct Parts {
    Precision mean, ratios, ground;

    void compare(const Images& tables, const Variant& variant, const std::string& where) {
        const std::uint32_t rows = variant.size.height, last = tables.single.extent.height - 1;
        mean.compare(tables, 0, rows, {Measure::Kind::logarithm}, where);
        // Moments over the mean, of order 1: what they contribute is compared with what the mean does.
        ratios.compare(tables, rows, last - rows, {Measure::Kind::absolute}, where);
        ground.compare(tables, last, 1, {Measure::Kind::logarithm}, where);
    }
    void check(const std::string& how, double vulkan_bound, double exact_bound, double exact_ratio_bound) const {
        mean.check("multi-scatter", "mean radiance, " + how, vulkan_bound, exact_bound);
        if (ratios.exact.compared())
            ratios.check("multi-scatter", "moments over the mean, " + how, vulkan_bound, exact_ratio_bound);
        ground.check("multi-scatter", "irradiance of the ground, " + how, vulkan_bound, exact_bound);
    }
};

constexpr Variant usual{{10, 6, 1}, 2, 3, 3, 6, 3};
constexpr Variant others[] = {{{7, 9, 1}, 0, 3, 3, 6, 2}, {{8, 8, 1}, 4, 5, 5, 8, 2}, {{17, 3, 1}, 8, 5, 9, 8, 2}};

/// `shared`: the pass alone, from the same transmittance table; else each backend goes on from its own.
void measure(Parts& parts, Backends& backends, std::span<const char* const> presets, const Variant& variant, bool shared) {
    for (const char* preset : presets) {
        const std::string where = std::string(preset) + ", order " + std::to_string(variant.order);
        CAPTURE(where);
        Trio<AirRig> trio(backends, setup_of(preset, variant));
        trio.record_air();
        if (shared) {
            trio.share_air();
            trio.each([](AirRig& rig) {
                dynamic_cast<detail::AureoleAir&>(*rig.air.impl().tables->model).multi_scatter()->restart();
                CHECK(rig.record_air().dispatches > 0);
                CHECK(!rig.air.reports()[0].recorded);
            });
        }
        const Images tables = trio.read(&AirRig::multi_scatter);
        CHECK(tables.unsound(true) == "");
        parts.compare(tables, variant, where);
    }
}

}  // namespace

TEST_CASE("multi-scatter: every backend makes the same table from the same transmittance") {
    Backends backends;
    Parts parts;
    measure(parts, backends, preset_names(), usual, true);
    constexpr const char* earth[] = {"earth"};
    for (const Variant& variant : others) measure(parts, backends, earth, variant, true);
    parts.check("alone", 1e-4, 3e-4, 3e-3);
}

TEST_CASE("multi-scatter: every backend makes the same table from its own transmittance") {
    Backends backends;
    Parts parts;
    measure(parts, backends, preset_names(), usual, false);
    parts.check("own transmittance", 1e-4, 3e-4, 3e-3);
}

namespace {

/// As a device that cannot filter 32-bit floats: some phones.
void pretend_half(Backend& backend) {
    rhi::FormatSupport support = backend.device().format_support(rhi::Format::rgba32_float, rhi::Dimension::d2);
    support.linear_filter = false;
    backend.device().pretend(std::pair(rhi::Format::rgba32_float, support));
}

constexpr std::optional<std::pair<rhi::Format, rhi::FormatSupport>> no_pretence;

/// Night is left out: clears all channels in which the mean of `by`, a table of `rows` rows a layer, is below e^-16 of the
/// sun's light.
void clear_night(Image& image, const Image& by, std::uint32_t rows) {
    const std::uint32_t width = image.extent.width, last = image.extent.height - 1;
    for (std::uint32_t y = 0; y <= last; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                if (by.at(x, y == last ? y : y % rows)[channel] < -16) image.texels[std::size_t{y} * width + x][channel] = 0;
}

}  // namespace

TEST_CASE(
    "multi-scatter: on a device that cannot filter 32-bit floats the table is in half, and close to what it is elsewhere") {
    Backends backends;
    Precision logarithms, ratios;
    Worst lost_light, lost_ratio;
    const std::uint32_t rows = usual.size.height;
    for (const char* preset : preset_names()) {
        Setup setup = setup_of(preset, usual);
        setup.quality.table_format = setup.quality.froxel_format = rhi::Format::rgba16_float;
        AirRig whole(*backends.single, setup);
        whole.record_air();
        Image full = whole.multi_scatter();
        const Image by = full;
        backends.each(pretend_half);
        Trio<AirRig> trio(backends, setup);
        backends.each([](Backend& backend) { backend.device().pretend(no_pretence); });
        trio.each([](AirRig& rig) {
            CHECK(rig.backend.device().desc(rig.air.multi_scatter_table()).format == rhi::Format::rgba16_float);
        });
        trio.record_air();
        Images tables = trio.read(&AirRig::multi_scatter);
        CHECK(tables.unsound(true) == "");
        for (Image* image : {&tables.single, &tables.exact, tables.vulkan ? &*tables.vulkan : &full, &full})
            clear_night(*image, by, rows);
        const std::uint32_t last = full.extent.height - 1;
        for (const auto& [begin, count] : {std::pair(0U, rows), std::pair(last, 1U)}) {
            logarithms.compare(tables, begin, count, {Measure::Kind::half_steps}, preset);
            lost_light.compare(tables.single, full, begin, count, {Measure::Kind::logarithm}, preset);
        }
        ratios.compare(tables, rows, last - rows, {Measure::Kind::absolute}, preset);
        lost_ratio.compare(tables.single, full, rows, last - rows, {Measure::Kind::absolute}, preset);
    }
    // Orders are in half too: where one rounds the other way, the next ones start from there.
    logarithms.check("multi-scatter", "logarithms in half, steps", 2, 1.2);
    ratios.check("multi-scatter", "moments over the mean, in half", 8e-3, 4e-3);
    INFO(lost_light.text(), "; ", lost_ratio.text());
    CHECK(lost_light.error() < 1e-2);
    CHECK(lost_light.error() > 1e-3);  // rounded it is
    CHECK(lost_ratio.error() < 3e-3);
}

namespace {

AtmosphereParameters with_albedo(double albedo) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(albedo);
    return air;
}

/// Passes of the fixed point, two dispatches each, that a rig records at once; thick or bright air takes more than is asked
/// for.
int passes_at_once(AirRig& rig) { return static_cast<int>(rig.record_air().dispatches - 1) / 2; }

/// The table for a brighter ground, n passes of the fixed point a frame; meanwhile the old one stays as it is.
void check_spreading(Backend& backend, int orders, int per_frame) {
    CAPTURE(orders);
    CAPTURE(per_frame);
    Setup before;
    before.air = with_albedo(0.1);
    before.quality.multi_scatter_orders = orders;
    Setup after = before;
    after.air = with_albedo(0.9);
    AirRig wanted(backend, after);
    const int passes = passes_at_once(wanted);
    CHECK(passes >= orders);
    const int frames = per_frame == 0 ? 1 : (passes + per_frame - 1) / per_frame;

    AirRig rig(backend, before);
    rig.air.set_multi_scatter_passes_per_frame(per_frame);
    rig.record_air();  // at once: there is no older table to show meanwhile
    const Image old_table = rig.multi_scatter();
    CHECK(rig.record_air().total() == 0);
    REQUIRE(old_table != wanted.multi_scatter());

    rig.air.set_parameters(after.air);
    for (int frame = 1; frame <= frames; ++frame) {
        CAPTURE(frame);
        CHECK(rig.record_air().total() > 0);
        CHECK(rig.air.reports()[1].recorded);
        CHECK(rig.multi_scatter() == (frame < frames ? old_table : wanted.multi_scatter()));
    }
    CHECK(rig.record_air().total() == 0);
    CHECK(!rig.air.reports()[1].recorded);
}

void check_spreading(Backend& backend) {
    for (const int orders : {2, 3, 4})
        for (const int per_frame : {0, 1, 2, 64}) check_spreading(backend, orders, per_frame);
}

}  // namespace

TEST_CASE("multi-scatter: spread over frames it ends in the very same table, and the old one is whole until then") {
    check_spreading(*open_cpu_float());
    if (const auto vulkan = open_vulkan()) check_spreading(*vulkan);
}

TEST_CASE("multi-scatter: refused numbers of passes change nothing") {
    const auto cpu = open_cpu_float();
    AirRig rig(*cpu, {});
    CHECK_THROWS_AS(rig.air.set_multi_scatter_passes_per_frame(-1), Error);
    CHECK_THROWS_AS(rig.air.set_multi_scatter_passes_per_frame(65), Error);
    rig.record_air();
    rig.air.set_parameters(with_albedo(0.7));
    rig.record_air();
    CHECK(rig.record_air().total() == 0);  // still solved at once
}
