#include "planned_sky/crossfade.h"

#include <doctest/doctest.h>

#include "passes/backend.h"
#include "passes/dropped_list.h"

#include <cmath>
#include <limits>

using namespace aureole;
using namespace aureole::passes;
using detail::CrossfadePass;

namespace {

constexpr rhi::Extent extent{5, 3, 1};

Image picture(double offset) {
    Image image{extent, {}};
    for (std::uint32_t i = 0; i < extent.width * extent.height; ++i)
        image.texels.emplace_back(offset + 0.25 * i, offset * offset, 1e4 * offset, 1 - 0.125 * i);
    return image;
}

/// The pass, a target, and both pictures filled.
struct Fading {
    Fading(Backend& backend_in, bool raster, const Image& before, const Image& after)
        : backend(backend_in), pass(backend.device(), frame, rhi::Format::rgba32_float, raster) {
        target = backend.make_target(rhi::Format::rgba32_float, extent, pass.written());
        pass.prepare(target, extent);
        CrossfadePass::Pictures& pictures = *pass.pictures(target);
        backend.run([&](rhi::CommandList& commands) {
            detail::move(commands, {{&pictures.before, rhi::State::sampled}, {&pictures.after, rhi::State::sampled}});
        });
        backend.write(pictures.before.handle, before);
        backend.write(pictures.after.handle, after);
    }
    Image at(double share) {
        backend.run([&](rhi::CommandList& commands) { pass.record(commands, target, share); });
        return backend.read(target, pass.written());
    }
    Backend& backend;
    std::uint64_t frame = 0;
    CrossfadePass pass;
    rhi::Texture target;
};

}  // namespace

TEST_CASE("crossfade: each texel goes from what it was to what it will be, and ends there exactly, on every backend") {
    const Image before = picture(-1), after = picture(3);
    for (const auto& backend : {open_cpu_float(), open_cpu_double(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        for (const bool raster : {false, true}) {
            CAPTURE(raster);
            Fading fading(*backend, raster, before, after);
            CHECK(fading.at(0) == before);
            CHECK(fading.at(1) == after);
            const Image half = fading.at(0.25);
            for (std::size_t i = 0; i < half.texels.size(); ++i)
                for (int c = 0; c < 4; ++c)
                    CHECK(half.texels[i][c] ==
                          doctest::Approx(0.75 * before.texels[i][c] + 0.25 * after.texels[i][c]).epsilon(1e-6).scale(1e-300));
        }
    }
}

TEST_CASE("crossfade: what is infinite in both stays so, and is no NaN") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Image before = picture(0), after = picture(1);
    before.texels[4] = after.texels[4] = glm::dvec4(infinite);
    const auto backend = open_cpu_float();
    Fading fading(*backend, false, before, after);
    for (const double share : {0.2, 0.5, 0.9}) CHECK(fading.at(share).texels[4].g == infinite);
}

TEST_CASE("crossfade: a target of another size gets other pictures; one that is released has none") {
    const auto backend = open_cpu_float();
    Fading fading(*backend, false, picture(0), picture(1));
    CHECK_FALSE(fading.pass.prepare(fading.target, extent));
    CHECK(fading.pass.prepare(fading.target, {4, 3, 1}));
    CHECK(fading.pass.pictures(fading.target)->before.extent.width == 4);
    fading.pass.release(fading.target);
    CHECK(fading.pass.pictures(fading.target) == nullptr);
    const std::uint64_t live = backend->device().live();
    backend->device().fail_after(1);
    CHECK_THROWS_AS(fading.pass.prepare(fading.target, extent), Error);
    CHECK(backend->device().live() == live);
    CHECK(fading.pass.pictures(fading.target) == nullptr);
}
