#include <aureole/rhi/validation.h>

#include "device.h"

namespace aureole::rhi {
namespace validation {
namespace {

class WatchingQueue final : public Queue {
public:
    WatchingQueue(WatchingDevice& device, Queue& inner) : device_(device), inner_(inner) {}

    CommandList& begin() override {
        if (device_.list_open()) device_.reporter().misuse_and_throw("begin: the list begun before has not been submitted");
        device_.set_frames(submitted_ + 1, completed_);
        return device_.begin_list(inner_.begin());
    }

    std::uint64_t submit() override {
        if (!device_.list_open()) device_.reporter().misuse_and_throw("submit: no list has been begun");
        // The inner queue must not be left with an open list, whatever is found here.
        try {
            device_.end_list();
        } catch (...) {
            (void)inner_.submit();
            throw;
        }
        const std::uint64_t frame = inner_.submit();
        submitted_ = frame;
        return frame;
    }

    void wait() override {
        inner_.wait();
        completed_ = submitted_;
        device_.set_frames(submitted_ + 1, completed_);
        device_.finish_all();
    }

private:
    WatchingDevice& device_;
    Queue& inner_;
    std::uint64_t submitted_ = 0, completed_ = 0;
};

}  // namespace
}  // namespace validation

std::unique_ptr<Queue> create_validation_queue(ValidationDevice& device, Queue& inner) {
    return std::make_unique<validation::WatchingQueue>(static_cast<validation::WatchingDevice&>(device), inner);
}

}  // namespace aureole::rhi
