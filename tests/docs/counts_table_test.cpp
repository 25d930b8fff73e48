// The table of atmosphere/quality/quality.md that says what each thing left out saves: counted by the CPU backend.
#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/models/aureole.h>
#include <aureole/presets.h>

#include "docs/page_table.h"

#include <doctest/doctest.h>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace aureole;

namespace {

/// What is left out, as the page's rows are named.
struct Without {
    const char* name;
    AtmosphereParameters air = presets::earth();
    QualitySettings quality = QualitySettings::standard();
};

Without without_term(const char* term) {
    Without result{term};
    std::erase_if(result.air.terms, [&](const DensityTerm& t) { return t.name == term; });
    return result;
}
template <class Change>
Without with(const char* name, const Change& change) {
    Without result{name};
    change(result.quality);
    return result;
}

std::vector<Without> rows() {
    return {{"nothing"},
            with("multi_scatter_orders=0", [](QualitySettings& q) { q.multi_scatter_orders = 0; }),
            with("ground_light=false", [](QualitySettings& q) { q.ground_light = false; }),
            with("angular_order=0", [](QualitySettings& q) { q.angular_order = 0; }),
            without_term("ozone"),
            without_term("mie")};
}

/// By table: evaluations of the medium and look-ups; and what all tables take.
struct Work {
    std::map<std::string, rhi::CpuCounts> by_table;
    std::uint64_t bytes = 0;
};

/// One rebuild of everything: a camera at 200 m, a sun at 30 degrees.
Work work_of(const Without& what) {
    const auto cpu = cpu::create_cpu_device({.count_work = true});
    Atmosphere air(cpu->device(), what.air, what.quality);
    View view(air);
    Sun sun;
    sun.direction = {std::sqrt(0.75), 0, 0.5};
    view.update(look(what.air.planet.bottom_radius_m, 200, 0, 0, std::numbers::pi / 3, 16.0 / 9), {&sun, 1});
    rhi::CommandList& commands = cpu->queue().begin();
    air.record(commands);
    view.record(commands);
    cpu->queue().submit();
    cpu->queue().wait();
    Work work;
    for (const cpu::PipelineWork& each : cpu->work()) {
        const bool solves = each.pipeline.starts_with("multi_scatter");
        work.by_table[solves ? "multi_scatter" : each.pipeline] += each.counts;
    }
    work.bytes = air.table_bytes() + view.table_bytes();
    return work;
}

}  // namespace

TEST_CASE("quality.md: what each thing left out saves") {
    auto page = docs::page_table(AUREOLE_QUALITY_PAGE, "| Left out |");
    CHECK(page.size() == rows().size() + 1);
    for (const Without& what : rows()) {
        CAPTURE(what.name);
        const Work work = work_of(what);
        std::vector<double> counts{static_cast<double>(what.air.terms.size())};
        for (const char* table : {"multi_scatter", "sky_view", "aerial_perspective"}) {
            const auto found = work.by_table.find(table);
            const rhi::CpuCounts done = found != work.by_table.end() ? found->second : rhi::CpuCounts{};
            counts.push_back(static_cast<double>(done.evaluations));
            counts.push_back(static_cast<double>(done.samples + done.fetches));
        }
        const std::uint64_t kib = work.bytes / 1024;
        counts.push_back(static_cast<double>(kib));
        std::printf("| %s |", what.name);
        for (const double count : counts) std::printf(" %.0f |", count);
        std::printf("\n");
        CHECK(page.contains(what.name));
        if (!page.contains(what.name)) continue;
        const std::vector<std::string> written = page[what.name];
        REQUIRE(written.size() == counts.size());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            CAPTURE(i);
            // Another compiler's arithmetic may cut a ray elsewhere.
            CHECK(std::abs(std::stod(written[i]) - counts[i]) <= 1e-3 * counts[i]);
        }
    }
}
