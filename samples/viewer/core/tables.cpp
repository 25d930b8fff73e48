#include "viewer/core/tables.h"

#include <aureole/rhi/texel.h>

#include <algorithm>
#include <cmath>

namespace aureole::viewer {
namespace {

/// All bytes of a texture in State::sampled.
std::vector<std::byte> read_all(app::Backend& backend, rhi::Texture texture, std::size_t bytes) {
    rhi::Device& device = backend.device();
    const rhi::Buffer buffer = device.create_buffer({"table", bytes, rhi::Usage::read_back | rhi::Usage::copy_destination});
    backend.run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier readable{texture, rhi::State::sampled, rhi::State::copy_source};
        const rhi::BufferBarrier writable{buffer, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier({&readable, 1}, {&writable, 1});
        commands.copy(rhi::TextureToBuffer{texture, buffer});
        const rhi::TextureBarrier done{texture, rhi::State::copy_source, rhi::State::sampled};
        commands.barrier({&done, 1}, {});
    });
    std::vector<std::byte> packed(bytes);
    device.read_buffer(buffer, packed);
    device.destroy(buffer, backend.frame());
    return packed;
}

}  // namespace

std::vector<TableInfo> tables_of(const Atmosphere& air, const View& view) {
    std::vector<TableInfo> tables;
    const auto add = [&](const char* name, rhi::Texture texture) {
        const rhi::TextureDesc* desc = texture ? air.device().find(texture) : nullptr;
        if (!desc || !rhi::has(desc->usage, rhi::Usage::copy_source)) return;
        if (desc->extent == rhi::Extent{1, 1, 1}) return;  // stands in for one that is not made
        const int slices = desc->dimension == rhi::Dimension::cube ? 6 : static_cast<int>(desc->extent.depth);
        tables.push_back({name, texture, desc->format, desc->extent, slices});
    };
    add("transmittance", air.transmittance_table());
    add("multi_scatter", air.multi_scatter_table());
    add("sky_view", view.sky_view_table());
    add("aerial_perspective", view.aerial_perspective_table());
    add("film", view.film_table());
    add("light", view.light_table());
    add("phase", view.phase_table());
    add("profile", view.profile_table());
    return tables;
}

const float* TableSlice::texel(std::uint32_t x, std::uint32_t y) const {
    if (x >= width || y >= height)
        throw Error(ErrorCode::invalid_argument, "texel", std::to_string(x) + " " + std::to_string(y),
                    "below " + std::to_string(width) + " and " + std::to_string(height));
    return rgba.data() + 4 * (std::size_t{y} * width + x);
}

TableSlice read_slice(app::Backend& backend, const TableInfo& table, int slice) {
    TableSlice result{table.name, table.format, table.extent.width, table.extent.height, 0, table.slices, {}};
    result.slice = std::clamp(slice, 0, table.slices - 1);
    const std::size_t texels = std::size_t{result.width} * result.height;
    const std::size_t bytes = texels * rhi::bytes_per_texel(table.format);
    const std::vector<std::byte> packed = read_all(backend, table.texture, bytes * static_cast<std::size_t>(table.slices));
    result.rgba.resize(4 * texels);
    rhi::decode_texels(table.format, std::span(packed).subspan(bytes * static_cast<std::size_t>(result.slice), bytes),
                       result.rgba);
    for (std::size_t i = 0; i < result.rgba.size(); ++i)
        if (i % 4 != 3 && std::isfinite(result.rgba[i])) result.greatest = std::max(result.greatest, std::abs(result.rgba[i]));
    return result;
}

}  // namespace aureole::viewer
