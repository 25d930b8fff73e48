#include "queue.h"

#include <exception>
#include <new>
#include <string>

namespace aureole::cpu {

rhi::CommandList& CpuQueue::begin() {
    if (recording_) throw Error(ErrorCode::misuse, "begin: the list begun before has not been submitted");
    list_.clear();
    recording_ = true;
    return list_;
}

std::uint64_t CpuQueue::submit() {
    if (!recording_) throw Error(ErrorCode::misuse, "submit: no list has been begun");
    recording_ = false;
    if (list_.incomplete()) throw Error(ErrorCode::out_of_memory, "submit: memory ran out while the list was recorded");
    try {
        executor_.run(list_.commands());
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::out_of_memory, "submit: not enough memory to run the recorded work");
    } catch (const std::exception& error) {
        throw Error(ErrorCode::internal, std::string("submit: a kernel failed: ") + error.what());
    } catch (...) {
        throw Error(ErrorCode::internal, "submit: a kernel failed");
    }
    return ++frame_;
}

void CpuQueue::wait() { device_.collect(frame_); }

}  // namespace aureole::cpu
