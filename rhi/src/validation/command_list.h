// Watches what is recorded and passes it on.
#pragma once

#include <aureole/rhi/device.h>

#include <string>
#include <vector>

#include "hazards.h"

namespace aureole::rhi::validation {

class WatchingDevice;

class WatchingCommandList final : public CommandList {
public:
    explicit WatchingCommandList(WatchingDevice& device) : device_(device) {}

    void update_constants(Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const TextureBarrier> textures, std::span<const BufferBarrier> buffers) override;
    void dispatch(const DispatchDesc& desc) override;
    void draw_fullscreen(const DrawDesc& desc) override;
    void copy(const CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

    [[nodiscard]] bool open() const { return inner_ != nullptr; }
    void begin(CommandList& inner);
    /// Reports markers that are still open.
    void end();

private:
    /// False, and a report, if no list is open.
    [[nodiscard]] bool recording(const char* function);
    /// Reports the complaint, if there is one, and tells whether all is well.
    [[nodiscard]] bool fine(const std::string& complaint);
    /// The accesses of a binding set's slots; false, and a report, if one of its objects is gone.
    [[nodiscard]] bool collect(const BindingSetRecord& set, const char* function);
    [[nodiscard]] bool collect(Texture texture, State state, bool write, const char* function);
    [[nodiscard]] bool collect(Buffer buffer, State state, bool write, const char* function);
    void check_accesses(const std::string& who);

    WatchingDevice& device_;
    CommandList* inner_ = nullptr;
    std::vector<std::string> markers_;
    std::vector<TextureAccess> texture_accesses_;  // of the command being recorded
    std::vector<BufferAccess> buffer_accesses_;
};

}  // namespace aureole::rhi::validation
