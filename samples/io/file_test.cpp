#include "io/file.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

using namespace aureole::app;

TEST_CASE("read_file: what it cannot read it names") {
    CHECK(complaint([] { (void)read_file("no_such_file"); }) == "no_such_file: there is no such file");
    CHECK(complaint([] { (void)read_file("."); }) == ".: not a regular file");
    put("ten_bytes", "0123456789");
    CHECK(read_text("ten_bytes") == "0123456789");
    CHECK(read_file("ten_bytes").size() == 10);
    CHECK(contains(complaint([] { (void)read_file("ten_bytes", 9); }), "10 bytes is not allowed; allowed: at most 9 bytes"));
}

TEST_CASE("NewFile: complete or not at all") {
    std::filesystem::remove_all("new_files");
    std::filesystem::create_directory("new_files");
    put("new_files/old", "old");
    {
        const NewFile file("new_files/old");
        put(file.temporary().string(), "half of the ne");
        CHECK(get("new_files/old") == "old");
    }
    CHECK(get("new_files/old") == "old");
    CHECK(files_in("new_files") == 1);

    write_text("new_files/old", "new");
    CHECK(get("new_files/old") == "new");
    write_text("new_files/other", "");
    CHECK(get("new_files/other").empty());
    CHECK(files_in("new_files") == 2);
}

TEST_CASE("NewFile: a signal that ends the program leaves nothing behind") {
    static volatile std::sig_atomic_t noted = 0;
    struct sigaction own {};  // notes the first signal, and gives the second back to the system
    own.sa_handler = [](int) {
        noted = 1;
        remove_unfinished_on_signals();
    };
    own.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const auto& one : {std::pair(SIGHUP, false), {SIGINT, false}, {SIGTERM, false}, {SIGINT, true}, {SIGTERM, true}}) {
        const auto& signal = one.first;
        const auto& has_handler = one.second;
        CAPTURE(signal);
        CAPTURE(has_handler);
        std::filesystem::remove_all("interrupted");
        std::filesystem::create_directory("interrupted");
        put("interrupted/old", "old");
        int ready[2];
        REQUIRE(pipe(ready) == 0);
        const pid_t child = fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            std::signal(signal, SIG_DFL);  // doctest listens, too, and whoever runs the tests may ignore it
            if (has_handler) sigaction(signal, &own, nullptr);
            const NewFile replaced("interrupted/old"), fresh("interrupted/new");
            put(replaced.temporary().string(), "half of the ne");
            if (has_handler) raise(signal);
            if (has_handler != (noted == 1) || write(ready[1], "x", 1) != 1) _exit(1);
            while (true) pause();
        }
        char byte = 0;
        REQUIRE(read(ready[0], &byte, 1) == 1);
        CHECK(files_in("interrupted") == 3);
        REQUIRE(kill(child, signal) == 0);
        int status = 0;
        REQUIRE(waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(files_in("interrupted") == 1);
        CHECK(get("interrupted/old") == "old");
        close(ready[0]);
        close(ready[1]);
    }
}

TEST_CASE("NewFile: places that take no file") {
    std::filesystem::remove_all("folder");
    std::filesystem::create_directory("folder");
    CHECK(contains(complaint([] { write_text("folder", "x"); }), "is a folder"));
    CHECK(contains(complaint([] { write_text("folder/", "x"); }), "is a folder"));
    CHECK(complaint([] { write_text("no_folder/file", "x"); }) ==
          "no_folder/file: cannot be written: there is no folder no_folder");
    put("plain", "text");
    CHECK(complaint([] { write_text("plain/file", "x"); }) == "plain/file: cannot be written: there is no folder plain");
    CHECK(complaint([] { (void)read_text("plain/file"); }) == "plain/file: there is no such file");
    CHECK(complaint([] { write_text("/proc/file", "x"); }) == "/proc/file: cannot be written");  // not even for root
    CHECK(files_in("folder") == 0);
}
