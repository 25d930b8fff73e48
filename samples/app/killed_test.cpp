// Programs that are killed at any moment: under each name stands what was written before, whole, or what comes after, whole.
#include "app/trace_checkpoint.h"
#include "io/file.h"
#include "io/image.h"
#include "io/test_files.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace aureole;
using namespace aureole::app;

namespace {

/// Writes one of two versions to "killed/file".
struct Writer {
    std::string name;
    std::function<void(bool second)> write;
};

constexpr std::uint32_t side = 150;

void write_picture(const std::string& kind, bool second) {
    std::vector<std::uint8_t> display;
    std::vector<float> linear;
    for (std::uint32_t i = 0, noise = second ? 2 : 1; i < 3 * side * side; ++i, noise = noise * 1664525 + 1013904223) {
        display.push_back(static_cast<std::uint8_t>(noise >> 24));
        linear.push_back(static_cast<float>(noise >> 8));
    }
    if (kind == "png")
        write_png("killed/file", {side, side, display});
    else
        write_exr("killed/file", {side, side, linear});
}

/// As `aureole measure` writes them.
void write_measurements(bool second) {
    nlohmann::json measurements{{"version", 1}, {"results", nlohmann::json::array()}};
    for (int i = 0; i < 2000; ++i)
        measurements["results"].push_back({{"setting", "aureole default"}, {"median", second ? i : -i}});
    write_text("killed/file", measurements.dump(1) + "\n");
}

/// Lets a process write one version after the other until it is killed.
void kill_while_writing(const Writer& writer, std::chrono::microseconds after) {
    int ready[2];
    REQUIRE(pipe(ready) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        for (bool second = true;; second = !second) {
            writer.write(second);
            if (write(ready[1], "x", 1) != 1) _exit(1);
        }
    }
    char byte = 0;
    REQUIRE(read(ready[0], &byte, 1) == 1);
    std::this_thread::sleep_for(after);
    REQUIRE(kill(child, SIGKILL) == 0);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    close(ready[0]);
    close(ready[1]);
}

}  // namespace

TEST_CASE("killed while writing: pictures, checkpoints and measurements are whole, the old ones or the new") {
    const auto backend = open_backend({.name = "cpu", .threads = 1});
    std::vector<ProbeRow> rows;
    rows.reserve(300);
    for (int i = 0; i < 300; ++i) rows.push_back({60, 0.2, 30, 0.5 * i});
    const TraceSettings settings{.error = 1};
    Tracer fresh(*backend, presets::airless(), rows, settings), traced(*backend, presets::airless(), rows, settings);
    while (traced.step()) {
    }
    const TraceParameters parameters = describe(presets::airless());
    const Writer writers[] = {
        {"png", [](bool second) { write_picture("png", second); }},
        {"exr", [](bool second) { write_picture("exr", second); }},
        {"checkpoint", [&](bool second) { write_checkpoint("killed/file", parameters, second ? traced : fresh); }},
        {"measurements", write_measurements},
    };
    for (const Writer& writer : writers) {
        CAPTURE(writer.name);
        std::filesystem::remove_all("killed");
        std::filesystem::create_directory("killed");
        writer.write(false);
        const std::string first = get("killed/file");
        writer.write(true);
        const std::string second = get("killed/file");
        REQUIRE(first != second);
        REQUIRE(first.size() > 10000);  // it takes more than one call to write
        for (int i = 0; i < 12; ++i) {
            kill_while_writing(writer, std::chrono::microseconds(700 * i));
            const std::string left = get("killed/file");
            CHECK((left == first || left == second));
        }
        writer.write(false);  // what the killed ones left behind is in nobody's way
        CHECK(get("killed/file") == first);
    }
    std::filesystem::remove_all("killed");
}
