// Both panes, and what the window shows of them; in a thread of its own, so that a window stays awake while pictures take their
// time: the newest state is drawn next, and states in between are skipped.
#pragma once

#include "viewer/core/difference.h"
#include "viewer/core/pane.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace aureole::viewer {

/// What has been drawn of a state.
struct Shown {
    std::uint64_t number = 0;  ///< Of the state, as it was given.
    std::array<std::optional<PanePicture>, 2> panes;
    std::string problem;  ///< Why there is no picture: one line; else empty.
};

/// Draws the panes that a state shows, each `width` x `height` pixels. B is exposed as A where both are shown.
class Studio {
public:
    explicit Studio(bool validation = false) : panes_{Pane(validation), Pane(validation)} {}

    /// Never throws: what goes wrong is Shown::problem.
    [[nodiscard]] Shown draw(const State& state, std::uint32_t width, std::uint32_t height, std::uint64_t number,
                             const std::atomic<bool>* stop = nullptr);

private:
    std::array<Pane, 2> panes_;
};

/// What the window shows: of a layout that needs a picture which is not there, the other one, or nothing (0 x 0).
[[nodiscard]] app::DisplayImage picture_of(const Shown& shown, const State& state);

class Worker {
public:
    explicit Worker(bool validation = false);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// The state to draw next; one that still waits is dropped. Returns its number.
    std::uint64_t submit(const State& state, std::uint32_t width, std::uint32_t height);
    /// What has been drawn since the last call; none if nothing has.
    [[nodiscard]] std::optional<Shown> take();
    /// Everything submitted has been drawn, or dropped, and taken.
    [[nodiscard]] bool idle();

private:
    struct Job {
        State state;
        std::uint32_t width = 0, height = 0;
        std::uint64_t number = 0;
    };
    void work();

    bool validation_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Job> waiting_;
    std::optional<Shown> done_;
    std::uint64_t last_ = 0;
    bool busy_ = false, ending_ = false;
    std::atomic<bool> stop_ = false;  ///< A newer state waits: paths may end.
    std::thread thread_;
};

}  // namespace aureole::viewer
