#include <doctest/doctest.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstring>

#include "test_kernels.h"

using namespace aureole;
using namespace aureole::cpu;
using rhi::Format;

namespace {

/// Lets a test use more threads than this machine has.
struct ManyThreads {
    oneapi::tbb::global_control control{oneapi::tbb::global_control::max_allowed_parallelism, 64};
};

}  // namespace

TEST_CASE("a CPU device tells what it is") {
    const unsigned all = create_cpu_device({})->threads();
    CHECK(all >= 1);
    CHECK(create_cpu_device({.threads = 1024})->threads() == all);  // as many as there are
    const ManyThreads many;
    const auto d = create_cpu_device({.threads = 3});
    CHECK(d->threads() == 3);
    CHECK(d->device().capabilities().threads == 3);
    CHECK(d->device().capabilities().backend == "cpu");
    CHECK(d->device().capabilities().driver.find("oneTBB 20") != std::string::npos);
    const auto reference = create_cpu_device({.precision = Precision::float64});
    CHECK(reference->precision() == Precision::float64);
    CHECK(reference->device().capabilities().device != d->device().capabilities().device);
    try {
        (void)create_cpu_device({.threads = 1025});
        FAIL("1025 threads were accepted");
    } catch (const Error& error) {
        CHECK(error.field() == "threads");
        CHECK(error.value() == "1025");
    }
}

TEST_CASE("float rounds what it stores, double keeps every bit") {
    const rhi::Extent extent{2, 1, 1};
    const std::vector<float> texels = {1, 2, 0.1f, 4, 5, -6, 7e-6f, 1e4f};
    for (const Format format : {Format::rgba16_float, Format::rg16_float, Format::rgba32_float, Format::rgba8_unorm}) {
        CAPTURE(std::string(to_string(format)));
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            const auto d = create_cpu_device({.precision = precision});
            const auto source = make_texture(*d, Format::rgba32_float, extent);
            const auto target = make_texture(*d, format, extent);
            fill(*d, source, texels);
            run_thirds(*d, source, target, extent);
            const auto got = d->read_texels_double(target);
            REQUIRE(got.size() == 8);
            for (std::size_t i = 0; i < 8; i += 4) {
                double exact[4];
                float rounded[4];
                for (std::size_t c = 0; c < 4; ++c) {
                    exact[c] = static_cast<double>(texels[i + c]) / 3;
                    rounded[c] = texels[i + c] / 3;
                }
                rhi::confine(format, exact);
                rhi::quantize(format, rounded);
                for (std::size_t c = 0; c < 4; ++c)
                    CHECK(got[i + c] == (precision == Precision::float64 ? exact[c] : static_cast<double>(rounded[c])));
            }
        }
    }
}

TEST_CASE("results do not depend on the number of threads") {
    const ManyThreads many;
    const rhi::Extent extent{61, 47, 1};
    std::vector<float> texels(4 * 61 * 47);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = std::sin(static_cast<float>(i));
    std::vector<double> first;
    for (const unsigned threads : {1u, 2u, 3u, 7u, 32u}) {
        const auto d = create_cpu_device({.threads = threads});
        const auto source = make_texture(*d, Format::rgba32_float, extent),
                   target = make_texture(*d, Format::rgba32_float, extent);
        fill(*d, source, texels);
        run_thirds(*d, source, target, extent);
        const auto got = d->read_texels_double(target);
        if (first.empty()) first = got;
        CAPTURE(threads);
        CHECK(got == first);
        CHECK(got[100] == static_cast<double>(texels[100] / 3));
    }
}

TEST_CASE("every invocation runs once, whatever the shape and the number of threads") {
    const ManyThreads many;
    for (const unsigned threads : {1u, 2u, 64u}) {
        const auto d = create_cpu_device({.threads = threads});
        const auto pipeline = d->device().create_compute_pipeline({"visit pass", &visit_shader, {}});
        for (const std::array<std::uint32_t, 3> size :
             {std::array{1u, 1u, 1u}, std::array{64u, 1u, 1u}, std::array{1u, 63u, 2u}, std::array{33u, 41u, 5u},
              std::array{64u, 64u, 64u}}) {
            for (auto& v : kernels::visits) v = 0;
            d->queue().begin().dispatch({pipeline, {}, {}, {size[0], size[1], size[2]}});
            d->queue().submit();
            int wrong = 0;
            for (std::uint32_t z = 0; z < 64; ++z)
                for (std::uint32_t y = 0; y < 64; ++y)
                    for (std::uint32_t x = 0; x < 64; ++x)
                        wrong += kernels::visits[(z * 64 + y) * 64 + x] != (x < size[0] && y < size[1] && z < size[2] ? 1 : 0);
            CAPTURE(threads);
            CAPTURE(size[0]);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("work is counted when asked for, the same for every number of threads") {
    const ManyThreads many;
    const rhi::Extent extent{13, 9, 1};
    for (const unsigned threads : {1u, 5u}) {
        const auto d = create_cpu_device({.threads = threads, .count_work = true});
        const auto source = make_texture(*d, Format::rgba32_float, extent),
                   target = make_texture(*d, Format::rg16_float, extent);
        fill(*d, source, std::vector<float>(4 * 13 * 9, 1.0f));
        run_thirds(*d, source, target, extent);
        run_thirds(*d, source, target, extent);
        const auto work = d->work();
        REQUIRE(work.size() == 1);
        CHECK(work[0].pipeline == "thirds pass");
        CHECK(work[0].dispatches == 2);
        CHECK(work[0].invocations == 2 * 16 * 12);  // whole groups
        CHECK(work[0].counts.evaluations == 2 * 2 * 16 * 12);
        CHECK(work[0].counts.samples == 2 * 16 * 12);
        CHECK(work[0].counts.fetches == 2 * 16 * 12);
        CHECK(work[0].counts.stores == 2 * 13 * 9);  // those that hit the image
        CHECK(work[0].counts.bytes == 2 * 13 * 9 * 4);
        CHECK(work[0].seconds > 0);
        d->reset_work();
        CHECK(d->work().at(0).dispatches == 0);
        CHECK(d->work().at(0).counts.samples == 0);
    }
    const auto silent = create_cpu_device({});
    const auto texture = make_texture(*silent, Format::rgba32_float, extent);
    fill(*silent, texture, std::vector<float>(4 * 13 * 9, 1.0f));
    CHECK(silent->work().empty());
}

TEST_CASE("fresh textures of float formats show that nothing has been written") {
    const auto d = create_cpu_device({});
    for (const double texel : d->read_texels_double(make_texture(*d, Format::rgba16_float, {3, 2, 1})))
        CHECK(std::isnan(texel));
    const auto narrow = d->read_texels_double(make_texture(*d, Format::r16_float, {1, 1, 1}));
    CHECK(std::isnan(narrow[0]));
    CHECK(narrow[1] == 0);
    CHECK(narrow[3] == 1);
    for (const double texel : d->read_texels_double(make_texture(*d, Format::rgba8_unorm, {3, 2, 1}))) CHECK(texel == 0);
    CHECK_THROWS_AS((void)d->read_texels_double(rhi::Texture{77}), Error);
}

TEST_CASE("a shader without a CPU kernel is refused") {
    const auto d = create_cpu_device({.precision = Precision::float64});
    rhi::Shader bare = pixel_shader;
    bare.cpu.run_double = nullptr;
    try {
        (void)d->device().create_raster_pipeline({"bare pass", &bare, {}, Format::rgba8_unorm});
        FAIL("was accepted");
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::unsupported);
        CHECK(error.field() == "pipeline \"bare pass\" shader");
        CHECK(error.value() == "pixel");
    }
}
