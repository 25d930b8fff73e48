// The table of settings in atmosphere/quality/quality.md says what the settings are.
#include <aureole/quality.h>

#include "docs/page_table.h"

#include <doctest/doctest.h>
#include <map>
#include <string>
#include <vector>

using namespace aureole;

namespace {

std::string print(const rhi::Extent& e) {
    const std::string plane = std::to_string(e.width) + "x" + std::to_string(e.height);
    return e.depth > 1 ? plane + "x" + std::to_string(e.depth) : plane;
}

/// Knob by name, as the header names it.
std::map<std::string, std::string> knobs(const QualitySettings& s) {
    return {{"transmittance", print(s.transmittance)},
            {"transmittance_nodes", std::to_string(s.transmittance_nodes)},
            {"multi_scatter", print(s.multi_scatter)},
            {"angular_order", std::to_string(s.angular_order)},
            {"angular_order_as_needed", s.angular_order_as_needed ? "yes" : "no"},
            {"multi_scatter_zenith", std::to_string(s.multi_scatter_zenith)},
            {"multi_scatter_azimuth", std::to_string(s.multi_scatter_azimuth)},
            {"multi_scatter_nodes", std::to_string(s.multi_scatter_nodes)},
            {"multi_scatter_later_nodes", std::to_string(s.multi_scatter_later_nodes)},
            {"multi_scatter_orders", std::to_string(s.multi_scatter_orders)},
            {"ground_light", s.ground_light ? "yes" : "no"},
            {"sky_view", print(s.sky_view)},
            {"sky_view_nodes", std::to_string(s.sky_view_nodes)},
            {"aerial_perspective", print(s.aerial_perspective)},
            {"aerial_perspective_nodes", std::to_string(s.aerial_perspective_nodes)},
            {"table_format", rhi::to_string(s.table_format)},
            {"froxel_format", rhi::to_string(s.froxel_format)}};
}

}  // namespace

TEST_CASE("quality.md: every knob of every setting") {
    auto rows = docs::page_table(AUREOLE_QUALITY_PAGE, "| Knob | low");
    const std::vector<std::string> settings = rows["Knob"];
    REQUIRE(settings == std::vector<std::string>{"low", "default", "high"});
    rows.erase("Knob");
    for (std::size_t i = 0; i < settings.size(); ++i) {
        CAPTURE(settings[i]);
        const auto expected = knobs(QualitySettings::by_name(settings[i]));
        CHECK(rows.size() == expected.size());
        for (const auto& knob : expected) {
            const auto& name = knob.first;
            const auto& value = knob.second;
            CAPTURE(name);
            REQUIRE(rows.count(name) == 1);
            CHECK(rows[name].at(i) == value);
        }
    }
}
