#include "viewer/core/studio.h"

#include <exception>
#include <utility>

namespace aureole::viewer {
namespace {

struct Overtaken : std::exception {};

PaneRequest request_of(const State& state, int pane, std::uint32_t width, std::uint32_t height) {
    PaneRequest request;
    request.setup = state.panes[static_cast<std::size_t>(pane)];
    request.scene = state.scene;
    request.width = width;
    request.height = height;
    request.linear = state.layout == Layout::difference;
    request.curves = state.curves && pane == state.table_pane;
    request.table = state.table && pane == state.table_pane;
    request.table_name = state.table_name;
    request.table_slice = state.table_slice;
    return request;
}

}  // namespace

Shown Studio::draw(const State& state, std::uint32_t width, std::uint32_t height, std::uint64_t number,
                   const std::atomic<bool>* stop) {
    Shown shown;
    shown.number = number;
    try {
        for (int i = 0; i < 2; ++i) {
            if (!state.shows(i)) continue;
            PaneRequest request = request_of(state, i, width, height);
            if (i == 1 && shown.panes[0]) request.exposure = shown.panes[0]->exposure;
            const auto pane = static_cast<std::size_t>(i);
            shown.panes[pane] = panes_[pane].render(request, [&] {
                if (stop && *stop) throw Overtaken();
            });
        }
    } catch (const Overtaken&) {
        shown.panes = {};
    } catch (const std::exception& problem) {
        shown.problem = problem.what();
    }
    return shown;
}

app::DisplayImage picture_of(const Shown& shown, const State& state) {
    const std::optional<PanePicture>&a = shown.panes[0], &b = shown.panes[1];
    if (a && b && state.layout == Layout::split) return split(a->display, b->display, state.divider);
    if (a && b && state.layout == Layout::difference && a->linear.width > 0 && b->linear.width > 0)
        return false_colours(difference(a->linear, b->linear), state.difference_range);
    if (b && (state.layout == Layout::b || !a)) return b->display;
    return a ? a->display : app::DisplayImage{};
}

Worker::Worker(bool validation) : validation_(validation), thread_([this] { work(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::uint64_t Worker::submit(const State& state, std::uint32_t width, std::uint32_t height) {
    const std::lock_guard lock(mutex_);
    waiting_ = Job{state, width, height, ++last_};
    stop_ = true;
    wake_.notify_one();
    return last_;
}

std::optional<Shown> Worker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

bool Worker::idle() {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !busy_ && !done_;
}

void Worker::work() {
    Studio studio(validation_);  // devices live and die in this thread
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [&] { return waiting_ || ending_; });
        if (ending_) return;
        const Job job = std::move(*waiting_);
        waiting_.reset();
        stop_ = false;
        busy_ = true;
        lock.unlock();
        Shown shown = studio.draw(job.state, job.width, job.height, job.number, &stop_);
        lock.lock();
        busy_ = false;
        const bool overtaken = !shown.panes[0] && !shown.panes[1] && shown.problem.empty();
        if (!overtaken) done_ = std::move(shown);
    }
}

}  // namespace aureole::viewer
