// Textures of the host's: packed memory that is read before the work and written after it.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "test_kernels.h"

using namespace aureole;
using namespace aureole::cpu;
using rhi::Format;

namespace {

rhi::Texture wrap(CpuDevice& d, Format format, rhi::Extent extent, std::vector<std::byte>& memory) {
    memory.resize(extent.width * extent.height * rhi::bytes_per_texel(format));
    rhi::ExternalTexture external;
    external.desc = {"host", rhi::Dimension::d2, format, extent, any_usage};
    external.cpu_texels = memory.data();
    return d.device().wrap_texture(external);
}

}  // namespace

TEST_CASE("a kernel reads and writes the host's memory in the host's format") {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
        const auto d = create_cpu_device({.precision = precision});
        const rhi::Extent extent{3, 2, 1};
        std::vector<std::byte> source_memory, target_memory;
        const auto source = wrap(*d, Format::rgba8_unorm, extent, source_memory);
        const auto target = wrap(*d, Format::bgra8_unorm, extent, target_memory);
        for (std::size_t i = 0; i < source_memory.size(); ++i)
            source_memory[i] = static_cast<std::byte>(3 * i);  // after wrapping
        const auto before = source_memory;
        run_thirds(*d, source, target, extent);
        CHECK(source_memory == before);
        constexpr std::size_t swapped[4] = {2, 1, 0, 3};
        for (std::size_t i = 0; i < target_memory.size(); ++i)
            CHECK(target_memory[i] == static_cast<std::byte>(i / 4 * 4 + swapped[i % 4]));

        // The host changes its texels between frames.
        for (auto& b : source_memory) b = std::byte(30);
        run_thirds(*d, source, target, extent);
        for (const auto b : target_memory) CHECK(b == std::byte(10));
        d->device().destroy(source, 0);
        d->device().destroy(target, 0);
        d->queue().wait();
        CHECK(target_memory[0] == std::byte(10));
    }
}

TEST_CASE("draws and copies reach the host's memory too") {
    const auto d = create_cpu_device({});
    std::vector<std::byte> memory;
    const auto target = wrap(*d, Format::r32_float, {5, 4, 1}, memory);
    const auto pipeline = d->device().create_raster_pipeline({"pixel pass", &pixel_shader, {}, Format::r32_float});
    auto& list = d->queue().begin();
    list.draw_fullscreen({pipeline, {}, {}, target});
    d->queue().submit();
    float texels[20];
    std::memcpy(texels, memory.data(), memory.size());
    for (std::size_t i = 0; i < 20; ++i) CHECK(texels[i] == static_cast<float>(i % 5) / 8);

    std::vector<std::byte> copied;
    const auto other = wrap(*d, Format::r32_float, {5, 4, 1}, copied);
    d->queue().begin().copy(rhi::TextureToTexture{target, other});
    d->queue().submit();
    CHECK(copied == memory);
}

TEST_CASE("what one command writes into the host's texture the next one reads, and it still arrives") {
    const auto d = create_cpu_device({});
    std::vector<std::byte> memory;
    const rhi::Extent extent{5, 4, 1};
    const auto host = wrap(*d, Format::r32_float, extent, memory);
    const auto own = make_texture(*d, Format::r32_float, extent);
    const auto pipeline = d->device().create_raster_pipeline({"pixel pass", &pixel_shader, {}, Format::r32_float});
    auto& list = d->queue().begin();
    list.draw_fullscreen({pipeline, {}, {}, host});
    list.copy(rhi::TextureToTexture{host, own});
    d->queue().submit();
    float texels[20];
    std::memcpy(texels, memory.data(), memory.size());
    const auto copied = d->read_texels_double(own);
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(texels[i] == static_cast<float>(i % 5) / 8);
        CHECK(copied[4 * i] == static_cast<double>(texels[i]));
    }
}

TEST_CASE("work that fails leaves the host's memory as it was") {
    const auto d = create_cpu_device({});
    std::vector<std::byte> memory;
    const auto target = wrap(*d, Format::rgba8_unorm, {8, 8, 1}, memory);
    const rhi::Specialization how[] = {{0, 1}};
    const auto pipeline = d->device().create_compute_pipeline({"failing pass", &failing_shader, how});
    const auto set = d->device().create_binding_set({"set", pipeline, std::array{rhi::Binding{0, target, {}, {}}}});
    d->queue().begin().dispatch({pipeline, set, {}, {1, 2, 1}});
    CHECK_THROWS_AS(d->queue().submit(), Error);
    for (const auto b : memory) CHECK(b == std::byte(0));
}

TEST_CASE("a barrier from undefined throws contents away, but not those of the host's memory") {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
        const auto d = create_cpu_device({.precision = precision});
        const rhi::Extent extent{3, 2, 1};
        std::vector<std::byte> memory;
        const auto host = wrap(*d, Format::r32_float, extent, memory);
        const auto own = make_texture(*d, Format::rg32_float, extent), kept = make_texture(*d, Format::r32_float, extent);
        const auto upload = d->device().create_buffer({"upload", 6 * 8, rhi::Usage::upload});
        std::vector<float> ones(12, 1.0f);
        d->device().write_buffer(upload, std::as_bytes(std::span(ones)));
        auto& list = d->queue().begin();
        for (const auto texture : {host, own, kept}) list.copy(rhi::BufferToTexture{upload, texture});
        const rhi::TextureBarrier barriers[] = {{host, rhi::State::undefined, rhi::State::sampled},
                                                {own, rhi::State::undefined, rhi::State::sampled},
                                                {kept, rhi::State::copy_destination, rhi::State::sampled}};
        list.barrier(barriers, {});
        d->queue().submit();
        const auto of_own = d->read_texels_double(own), of_kept = d->read_texels_double(kept);
        for (std::size_t i = 0; i < 6; ++i) {
            CHECK(std::isnan(of_own[4 * i]));
            CHECK(std::isnan(of_own[4 * i + 1]));
            CHECK(of_own[4 * i + 3] == 1);  // alpha, which the format has not
            CHECK(of_kept[4 * i] == 1);
        }
        float texels[6];
        std::memcpy(texels, memory.data(), memory.size());
        for (const float texel : texels) CHECK(texel == 1);
    }
}

TEST_CASE("a host texture without memory is refused") {
    const auto d = create_cpu_device({});
    rhi::ExternalTexture external;
    external.desc = {"host", rhi::Dimension::d2, Format::rgba8_unorm, {8, 8, 1}, any_usage};
    try {
        (void)d->device().wrap_texture(external);
        FAIL("was accepted");
    } catch (const Error& error) {
        CHECK(error.field() == "texture \"host\" cpu_texels");
    }
}
