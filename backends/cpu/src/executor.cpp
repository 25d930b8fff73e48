#include "executor.h"

#include <chrono>
#include <cstring>
#include <mutex>

namespace aureole::cpu {
namespace {

/// Boxes of invocations that one thread runs at a time. A kernel object is set up for each, so they are not too small; and
/// there are several for each thread, so that cheap and dear regions even out.
class Tiling {
public:
    Tiling(const std::uint32_t size[3], unsigned threads) {
        const std::uint64_t wanted = threads > 1 ? 8ull * threads : 1;
        for (int i = 0; i < 3; ++i) size_[i] = size[i], tile_[i] = std::min(size[i], i < 2 ? 32u : 1u);
        while (count() < wanted && (tile_[0] > 1 || tile_[1] > 1)) {
            std::uint32_t& side = tile_[0] > tile_[1] ? tile_[0] : tile_[1];  // rows first: neighbours along x share memory
            side = (side + 1) / 2;
        }
    }

    [[nodiscard]] std::uint64_t count() const { return std::uint64_t{along(0)} * along(1) * along(2); }

    [[nodiscard]] rhi::CpuRange range(std::uint64_t index) const {
        const std::uint64_t position[3] = {index % along(0), index / along(0) % along(1), index / along(0) / along(1)};
        rhi::CpuRange r;
        for (int i = 0; i < 3; ++i) {
            r.begin[i] = static_cast<std::uint32_t>(position[i]) * tile_[i];
            r.end[i] = std::min(r.begin[i] + tile_[i], size_[i]);
        }
        return r;
    }

private:
    [[nodiscard]] std::uint32_t along(int i) const { return (size_[i] + tile_[i] - 1) / tile_[i]; }

    std::uint32_t size_[3], tile_[3];
};

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

void Executor::run(const CommandArena& commands) {
    ++run_;
    touched_.clear();
    commands.visit([&](const auto& command, std::span<const std::byte> payload) { execute(command, payload); });
    for (TextureObject* texture : touched_)
        if (texture->written) texture->store_to_host(device_.workers());
}

template <class Pool, class Handle>
auto& Executor::get(const Pool& pool, Handle handle, const char* kind) const {
    auto* object = pool.any(handle);
    if (!object) throw Error(ErrorCode::misuse, std::string("a recorded ") + kind + " was freed before the work was submitted");
    return *object;
}

void Executor::touch(TextureObject& texture, bool written, bool overwritten) {
    if (!texture.of_host()) return;
    if (texture.loaded_by != run_) {
        if (!overwritten) texture.load_from_host(device_.workers());
        texture.loaded_by = run_;
        texture.written = false;
        touched_.push_back(&texture);
    }
    texture.written = texture.written || written;
}

void Executor::touch_bindings(const BindingsObject& bindings) {
    for (const auto& host : bindings.host_textures()) touch(*host.texture, host.written);
}

void Executor::execute(const UpdateCommand& command, std::span<const std::byte> bytes) {
    BufferObject& buffer = get(device_.buffers(), command.buffer, "buffer");
    std::memcpy(buffer.bytes().data(), bytes.data(), bytes.size());
}

void Executor::execute(const DispatchCommand& command, std::span<const std::byte> push_constants) {
    PipelineObject& pipeline = get(device_.pipelines(), command.pipeline, "pipeline");
    const BindingsObject* bindings = command.bindings ? &get(device_.binding_sets(), command.bindings, "binding set") : nullptr;
    if (bindings) touch_bindings(*bindings);
    std::uint32_t size[3];
    for (int i = 0; i < 3; ++i) size[i] = command.groups[i] * pipeline.shader().local_size[i];
    run_kernel(pipeline, bindings, push_constants, size, nullptr);
}

void Executor::execute(const DrawCommand& command, std::span<const std::byte> push_constants) {
    PipelineObject& pipeline = get(device_.pipelines(), command.pipeline, "pipeline");
    TextureObject& target = get(device_.textures(), command.target, "texture");
    const BindingsObject* bindings = command.bindings ? &get(device_.binding_sets(), command.bindings, "binding set") : nullptr;
    if (bindings) touch_bindings(*bindings);
    touch(target, true, true);
    const rhi::CpuBinding binding = target.binding();
    const std::uint32_t size[3] = {target.desc().extent.width, target.desc().extent.height, 1};
    run_kernel(pipeline, bindings, push_constants, size, &binding);
}

void Executor::run_kernel(PipelineObject& pipeline, const BindingsObject* bindings, std::span<const std::byte> push_constants,
                          const std::uint32_t size[3], const rhi::CpuBinding* target) {
    rhi::CpuArguments arguments;
    arguments.specialization = pipeline.specialization();
    if (bindings) arguments.bindings = bindings->bindings();
    arguments.push_constants = push_constants;

    const Tiling tiling(size, device_.workers().count());
    rhi::CpuCounts total;
    std::mutex total_mutex;
    const double start = pipeline.work ? seconds_now() : 0;
    device_.workers().for_each(tiling.count(), 1, [&](std::size_t begin, std::size_t end) {
        rhi::CpuArguments own = arguments;
        rhi::CpuCounts counts;
        if (pipeline.work) own.counts = &counts;
        for (std::size_t i = begin; i < end; ++i) pipeline.run()(own, tiling.range(i), target);
        if (pipeline.work) {
            const std::lock_guard lock(total_mutex);
            total += counts;
        }
    });
    if (!pipeline.work) return;
    ++pipeline.work->dispatches;
    pipeline.work->invocations += std::uint64_t{size[0]} * size[1] * size[2];
    pipeline.work->counts += total;
    pipeline.work->seconds += seconds_now() - start;
}

void Executor::execute(const rhi::TextureToBuffer& command, std::span<const std::byte>) {
    TextureObject& source = get(device_.textures(), command.source, "texture");
    BufferObject& destination = get(device_.buffers(), command.destination, "buffer");
    touch(source, false);
    source.encode_to(destination.bytes(), device_.workers());
}

void Executor::execute(const rhi::BufferToTexture& command, std::span<const std::byte>) {
    BufferObject& source = get(device_.buffers(), command.source, "buffer");
    TextureObject& destination = get(device_.textures(), command.destination, "texture");
    touch(destination, true, true);
    destination.decode_from(source.bytes(), device_.workers());
}

void Executor::execute(const rhi::TextureToTexture& command, std::span<const std::byte>) {
    TextureObject& source = get(device_.textures(), command.source, "texture");
    TextureObject& destination = get(device_.textures(), command.destination, "texture");
    touch(source, false);
    touch(destination, true, true);
    destination.copy_from(source);
}

void Executor::execute(const DiscardCommand& command, std::span<const std::byte>) {
    get(device_.textures(), command.texture, "texture").discard(device_.workers());
}

void Executor::execute(const TimestampCommand& command, std::span<const std::byte>) {
    device_.set_timestamp(command.index, seconds_now() * 1e9);
}

}  // namespace aureole::cpu
