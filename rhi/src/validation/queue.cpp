#include <aureole/rhi/validation.h>

#include "device.h"

namespace aureole::rhi {
namespace validation {
namespace {

class WatchingQueue final : public Queue {
public:
    WatchingQueue(WatchingDevice& device, Queue& inner) : device_(device), inner_(inner) {}

    ~WatchingQueue() override { device_.count_submitted(std::nullopt); }
    WatchingQueue(const WatchingQueue&) = delete;
    WatchingQueue& operator=(const WatchingQueue&) = delete;

    CommandList& begin() override {
        if (device_.list_open()) device_.reporter().misuse_and_throw("begin: the list begun before has not been submitted");
        return device_.begin_list(inner_.begin(), submitted_ + 1);
    }

    std::uint64_t submit() override {
        if (!device_.list_open()) device_.reporter().misuse_and_throw("submit: no list has been begun");
        // The inner queue must not be left with an open list, whatever is found here.
        try {
            device_.end_list();
        } catch (...) {
            submit_inner();
            throw;
        }
        submit_inner();
        return submitted_;
    }

    void wait() override {
        inner_.wait();
        device_.complete(submitted_);
    }

private:
    void submit_inner() {
        submitted_ = inner_.submit();
        device_.count_submitted(submitted_);
    }

    WatchingDevice& device_;
    Queue& inner_;
    std::uint64_t submitted_ = 0;
};

}  // namespace
}  // namespace validation

std::unique_ptr<Queue> create_validation_queue(ValidationDevice& device, Queue& inner) {
    return std::make_unique<validation::WatchingQueue>(static_cast<validation::WatchingDevice&>(device), inner);
}

}  // namespace aureole::rhi
