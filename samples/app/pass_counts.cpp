#include "app/pass_counts.h"

#include <exception>
#include <utility>

namespace aureole::app {
namespace {

/// Hands on what it is given; where a pass begins or ends, what there is so far is run, and its work is read.
class CountedList final : public rhi::CommandList {
public:
    explicit CountedList(Backend& backend) : backend_(backend), list_(&backend.queue().begin()) { backend.cpu()->reset_work(); }

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override {
        list_->update_constants(buffer, bytes);
    }
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override {
        list_->barrier(textures, buffers);
    }
    void dispatch(const rhi::DispatchDesc& desc) override { list_->dispatch(desc); }
    void draw_fullscreen(const rhi::DrawDesc& desc) override { list_->draw_fullscreen(desc); }
    void copy(const rhi::CopyDesc& desc) override { list_->copy(desc); }
    void timestamp(std::uint32_t index) override { list_->timestamp(index); }

    void begin_marker(const char* name) override {
        if (depth_++ == 0) enter(name);
        list_->begin_marker(name);
    }
    void end_marker() override {
        list_->end_marker();
        if (--depth_ == 0) enter("");
    }

    /// Runs the rest. Throws what a run has thrown.
    std::map<std::string, rhi::CpuCounts> finish() {
        submit();
        if (problem_) std::rethrow_exception(problem_);
        return std::move(counts_);
    }

private:
    void enter(const std::string& pass) {
        submit();
        pass_ = pass;
        list_ = &backend_.queue().begin();
    }
    /// Recording must not throw: what goes wrong is kept.
    void submit() {
        try {
            backend_.queue().submit();
        } catch (...) {
            if (!problem_) problem_ = std::current_exception();
        }
        backend_.queue().wait();
        for (const cpu::PipelineWork& work : backend_.cpu()->work()) counts_[pass_] += work.counts;
        backend_.cpu()->reset_work();
    }

    Backend& backend_;
    rhi::CommandList* list_;
    int depth_ = 0;
    std::string pass_;  // empty: between passes
    std::map<std::string, rhi::CpuCounts> counts_;
    std::exception_ptr problem_;
};

}  // namespace

std::map<std::string, rhi::CpuCounts> count_passes(Backend& backend, const std::function<void(rhi::CommandList&)>& record) {
    CountedList list(backend);
    record(list);
    return list.finish();
}

}  // namespace aureole::app
