// Disks that fill up, and programs that are killed: what stands under a file's name is whole, be it old or new.
#include "io/file.h"
#include "io/image.h"
#include "io/test_files.h"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

using namespace aureole::app;

namespace {

/// Runs `action` in a process of its own and returns how that ended.
int status_of(const std::function<bool()>& action) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) _exit(action() ? 0 : 1);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return status;
}

/// In a process that has no more than `most` of something.
std::string complaint_within(decltype(RLIMIT_FSIZE) resource, rlim_t most, const std::function<void()>& action) {
    std::filesystem::remove("complaint");
    const int status = status_of([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        getrlimit(resource, &limit);
        const rlimit whole = limit;
        limit.rlim_cur = most;
        setrlimit(resource, &limit);
        const std::string said = complaint(action);
        setrlimit(resource, &whole);
        put("complaint", said);
        return true;
    });
    CHECK(status == 0);
    return get("complaint");
}

/// Files that cannot grow: to those who write it looks like a full disk.
std::string complaint_on_full_disk(rlim_t bytes, const std::function<void()>& action) {
    return complaint_within(RLIMIT_FSIZE, bytes, action);
}

struct Writer {
    std::string name;
    std::function<void()> write;  ///< Of "full/old".
};

/// Pictures of a few bytes are written when they are closed, larger ones on the way.
std::vector<Writer> writers(std::uint32_t side) {
    std::vector<std::uint8_t> display;
    std::vector<float> linear;
    for (std::uint32_t i = 0, noise = 1; i < 3 * side * side; ++i, noise = noise * 1664525 + 1013904223) {
        display.push_back(static_cast<std::uint8_t>(noise >> 24));
        linear.push_back(static_cast<float>(noise >> 8));
    }
    return {{"text", [=] { write_text("full/old", std::string(3 * side * side, 'x')); }},
            {"png",
             [=] {
                 write_png("full/old", {side, side, display});
             }},
            {"exr", [=] {
                 write_exr("full/old", {side, side, linear});
             }}};
}

}  // namespace

TEST_CASE("a full disk: every writer says so, leaves the old file and nothing else, and can go on") {
    for (const std::uint32_t side : {4U, 200U})
        for (const Writer& writer : writers(side)) {
            CAPTURE(writer.name);
            CAPTURE(side);
            std::filesystem::remove_all("full");
            std::filesystem::create_directory("full");
            put("full/old", "old");
            writer.write();
            const auto size = static_cast<rlim_t>(std::filesystem::file_size("full/old"));
            for (const rlim_t bytes : {rlim_t{0}, rlim_t{1}, size / 2, size - 1}) {
                CAPTURE(bytes);
                put("full/old", "old");
                const std::string said = complaint_on_full_disk(bytes, writer.write);
                CHECK(contains(said, "full/old: cannot be written"));
                CHECK(get("full/old") == "old");
                CHECK(files_in("full") == 1);
            }
            CHECK(complaint_on_full_disk(size, writer.write) == "nothing");
            CHECK(std::filesystem::file_size("full/old") == size);
        }
}

TEST_CASE("files that cannot be opened: reader and writers name them, and nothing is left") {
    constexpr rlim_t none = 3;  // what is open already
    put("closed", "text");
    CHECK(complaint_within(RLIMIT_NOFILE, none, [] { (void)read_text("closed"); }) == "closed: cannot be read");
    for (const Writer& writer : writers(4)) {
        CAPTURE(writer.name);
        std::filesystem::remove_all("full");
        std::filesystem::create_directory("full");
        put("full/old", "old");
        CHECK(complaint_within(RLIMIT_NOFILE, none, writer.write) == "full/old: cannot be written");
        CHECK(get("full/old") == "old");
        CHECK(files_in("full") == 1);
    }
}

TEST_CASE("a program that is killed while it writes leaves the old file, or none") {
    for (const bool old : {true, false}) {
        std::filesystem::remove_all("killed");
        std::filesystem::create_directory("killed");
        if (old) put("killed/file", "old");
        const int status = status_of([] {
            const NewFile file("killed/file");
            put(file.temporary().string(), "half of the ne");
            return kill(getpid(), SIGKILL) == 0;
        });
        CHECK(WIFSIGNALED(status));
        CHECK(get("killed/file") == (old ? "old" : ""));
        CHECK(std::filesystem::exists("killed/file") == old);
        write_text("killed/file", "new");  // what the other left behind is in nobody's way
        CHECK(get("killed/file") == "new");
    }
}
