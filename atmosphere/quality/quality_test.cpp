#include "common/rejects.h"

#include <aureole/quality.h>

#include <doctest/doctest.h>
#include <functional>

using namespace aureole;
using detail::rejected_field;

namespace {

/// A field, how to set it, and the ends of its range: both must pass, one beyond either must not.
struct Field {
    std::string name;
    std::function<void(QualitySettings&, int)> set;
    int low, high;
};

std::vector<Field> sizes() {
    using Q = QualitySettings;
    const auto u = [](int v) { return static_cast<std::uint32_t>(v); };
    return {
        {"aureole.transmittance.width", [u](Q& q, int v) { q.transmittance.width = u(v); }, 2, 4096},
        {"aureole.transmittance.height", [u](Q& q, int v) { q.transmittance.height = u(v); }, 2, 4096},
        {"aureole.transmittance.depth", [u](Q& q, int v) { q.transmittance.depth = u(v); }, 1, 1},
        {"aureole.multi_scatter.width", [u](Q& q, int v) { q.multi_scatter.width = u(v); }, 2, 256},
        {"aureole.multi_scatter.height", [u](Q& q, int v) { q.multi_scatter.height = u(v); }, 2, 256},
        {"aureole.multi_scatter.depth", [u](Q& q, int v) { q.multi_scatter.depth = u(v); }, 1, 1},
        {"aureole.multi_scatter_zenith", [](Q& q, int v) { q.multi_scatter_zenith = v; }, 2, 16},
        {"aureole.multi_scatter_azimuth", [](Q& q, int v) { q.multi_scatter_azimuth = v; }, 2, 32},
        {"aureole.multi_scatter_orders", [](Q& q, int v) { q.multi_scatter_orders = v; }, 2, 64},
        {"aureole.sky_view.width", [u](Q& q, int v) { q.sky_view.width = u(v); }, 4, 4096},
        {"aureole.sky_view.height", [u](Q& q, int v) { q.sky_view.height = u(v); }, 4, 4096},
        {"aureole.sky_view.depth", [u](Q& q, int v) { q.sky_view.depth = u(v); }, 1, 1},
        {"aureole.aerial_perspective.width", [u](Q& q, int v) { q.aerial_perspective.width = u(v); }, 2, 256},
        {"aureole.aerial_perspective.height", [u](Q& q, int v) { q.aerial_perspective.height = u(v); }, 2, 256},
        {"aureole.aerial_perspective.depth", [u](Q& q, int v) { q.aerial_perspective.depth = u(v); }, 2, 256},
        {"aureole.aerial_perspective_nodes", [](Q& q, int v) { q.aerial_perspective_nodes = v; }, 1, 8},
    };
}

std::vector<Field> samples() {
    using Q = QualitySettings;
    constexpr int low = 2, high = 16;
    return {{"aureole.transmittance_nodes", [](Q& q, int v) { q.transmittance_nodes = v; }, low, high},
            {"aureole.multi_scatter_nodes", [](Q& q, int v) { q.multi_scatter_nodes = v; }, low, high},
            {"aureole.multi_scatter_later_nodes", [](Q& q, int v) { q.multi_scatter_later_nodes = v; }, low, high},
            {"aureole.sky_view_nodes", [](Q& q, int v) { q.sky_view_nodes = v; }, low, high}};
}

void check_range(const std::vector<Field>& fields) {
    const QualitySettings valid;
    for (const Field& f : fields) {
        CAPTURE(f.name);
        const auto rejected = [&](int value) {
            QualitySettings q = valid;
            f.set(q, value);
            return rejected_field([&] { validate(q); });
        };
        CHECK(rejected(f.low) == "nothing");
        CHECK(rejected(f.high) == "nothing");
        CHECK(rejected(f.low - 1) == f.name);
        CHECK(rejected(f.high + 1) == f.name);
        CHECK(rejected(-7) == f.name);
    }
}

}  // namespace

TEST_CASE("quality: the named settings are valid and carry their names") {
    for (const std::string_view name : quality_names()) {
        const QualitySettings q = QualitySettings::by_name(name);
        CHECK(q.name == name);
        CHECK_NOTHROW(validate(q));
    }
    for (const char* wrong : {"", "Default", "ultra", "published-2020"})
        CHECK(rejected_field([&] { (void)QualitySettings::by_name(wrong); }) == "quality");
}

TEST_CASE("quality: every number has its range") {
    check_range(sizes());
    check_range(samples());
}

TEST_CASE("quality: every choice") {
    const auto rejected = [](const std::function<void(QualitySettings&)>& spoil) {
        QualitySettings q;
        spoil(q);
        return rejected_field([&] { validate(q); });
    };
    for (const std::uint32_t odd : {5u, 191u, 4095u})
        CHECK(rejected([&](auto& q) { q.sky_view.height = odd; }) == "aureole.sky_view.height");
    for (const int order : {-1, 1, 3, 5, 7, 9, 16})
        CHECK(rejected([&](auto& q) { q.angular_order = order; }) == "aureole.angular_order");
    for (const int order : {0, 2, 4, 6, 8}) CHECK(rejected([&](auto& q) { q.angular_order = order; }) == "nothing");
    for (const int orders : {-1, 1, 65})
        CHECK(rejected([&](auto& q) { q.multi_scatter_orders = orders; }) == "aureole.multi_scatter_orders");
    CHECK(rejected([](auto& q) { q.multi_scatter_orders = 0; }) == "nothing");
    for (const bool light : {false, true}) CHECK(rejected([&](auto& q) { q.ground_light = light; }) == "nothing");
    for (const rhi::Format format : {rhi::Format::undefined, rhi::Format::r32_float, rhi::Format::rgba8_unorm}) {
        CHECK(rejected([&](auto& q) { q.table_format = format; }) == "aureole.table_format");
        CHECK(rejected([&](auto& q) { q.froxel_format = format; }) == "aureole.froxel_format");
    }
    for (const rhi::Format format : {rhi::Format::rgba16_float, rhi::Format::rgba32_float}) {
        CHECK(rejected([&](auto& q) { q.table_format = format; }) == "nothing");
        CHECK(rejected([&](auto& q) { q.froxel_format = format; }) == "nothing");
    }
}
