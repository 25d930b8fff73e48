#include "viewer/core/script.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::viewer;
using app::complaint, app::contains;

namespace {

/// Writes down what it is told; settles when it is allowed to.
class Diary final : public Stage {
public:
    void set(const std::string& field, const std::string& value) override { write("set " + field + " " + value); }
    void print(const std::string& field) override { write("print " + field); }
    void load(const std::filesystem::path& file) override { write("load " + file.string()); }
    void save(const std::filesystem::path& file) override { write("save " + file.string()); }
    void resize(int width, int height) override { write("resize " + std::to_string(width) + "," + std::to_string(height)); }
    bool settled() override { return settled_at <= frame; }
    void mouse(double x, double y) override { write("mouse " + std::to_string(int(x)) + "," + std::to_string(int(y))); }
    void button(int index, bool down) override { write((down ? "down " : "up ") + std::to_string(index)); }
    void key(const std::string& name, bool down) override { write((down ? "+" : "-") + name); }
    void type(const std::string& text) override { write("type " + text); }
    void point_at(const std::string& widget) override {
        if (widget == "none") throw Error(ErrorCode::invalid_argument, "widget", widget, "others");
        write("at " + widget);
    }
    void screenshot(const std::filesystem::path& file) override { write("screenshot " + file.string()); }
    void picture(const std::string& which, const std::filesystem::path& file) override {
        write("picture " + which + " " + file.string());
    }
    void texel(int x, int y) override { write("texel " + std::to_string(x) + "," + std::to_string(y)); }
    void texel_under_mouse() override { write("texel"); }
    void describe(const std::string& pane) override { write("describe " + pane); }
    void wheel(double steps) override { write("wheel " + std::to_string(int(steps))); }
    void record(bool start, const std::filesystem::path& file) override { write((start ? "record" : "stop ") + file.string()); }
    void play(const std::filesystem::path& file) override { write("play " + file.string()); }
    bool playing() override { return frame < plays_until; }
    void quit() override { write("quit"); }

    /// All frames until the script is done: "frame: what; what | frame: ...".
    std::string run(const std::string& text, int most = 100) {
        ScriptRunner runner(Script(text, "s.txt"));
        for (; frame < most && !runner.finished(); ++frame) runner.before_frame(*this);
        return pages;
    }
    int frame = 0, settled_at = 0, plays_until = 0;
    std::string pages;

private:
    void write(const std::string& what) {
        if (last_ != frame || pages.empty())
            pages.append(pages.empty() ? "" : " | ").append(std::to_string(frame)).append(": ");
        else
            pages += "; ";
        pages += what;
        last_ = frame;
    }
    int last_ = -1;
};

}  // namespace

TEST_CASE("script: lines, words, quotes and comments") {
    const Script script("# nothing\n\n  set a.model \"x y\"  # why\nquit\n", "s.txt");
    REQUIRE(script.lines().size() == 2);
    CHECK(script.lines()[0].words == std::vector<std::string>{"set", "a.model", "x y"});
    CHECK(script.lines()[1].number == 4);
    const auto rejected = [](const char* text) { return complaint([&] { (void)Script(text, "s.txt"); }); };
    CHECK(contains(rejected("settle\njump 3\n"), "s.txt:2: jump: this command is not allowed; allowed: set FIELD VALUE; "));
    CHECK(rejected("set a\n") == "s.txt:1: set: 1 words after it is not allowed; allowed: set FIELD VALUE");
    CHECK(rejected("type \"a\n") == "s.txt:1: a quote that is not closed");
}

TEST_CASE("script: what needs no frame happens at once, input takes its frames") {
    CHECK(Diary().run("set x 1\nprint x\nload a\nsave b\nquit\nset y 2\n") == "0: set x 1; print x; load a; save b; quit");
    CHECK(Diary().run("wait 3\nprint x\n") == "3: print x");
    CHECK(Diary().run("resize 30 40\nprint x\n") == "0: resize 30,40 | 3: print x");
    CHECK(Diary().run("click OK\nprint x\n") == "0: at OK | 1: at OK | 2: at OK | 3: down 0 | 4: up 0 | 6: print x");
    CHECK(Diary().run("click OK ctrl\nwheel -2\nprint x\n") ==
          "0: at OK | 1: at OK | 2: at OK; +ctrl | 3: down 0 | 4: up 0 | 5: -ctrl | 6: wheel -2 | 7: print x");
    CHECK(Diary().run("key w 2\nprint x\n") == "0: +w | 2: -w | 3: print x");
    CHECK(Diary().run("drag right 0 0 8 4\nprint x\n") ==
          "0: mouse 0,0 | 1: down 1 | 2: mouse 2,1 | 3: mouse 4,2 | 4: mouse 6,3 | 5: mouse 8,4 | 6: up 1 | 7: print x");
    Diary slow;
    slow.settled_at = 7;
    CHECK(slow.run("settle\nscreenshot a.png\npicture a b.png\ntexel 3 4\ntexel\ndescribe b\n") ==
          "7: screenshot a.png; picture a b.png; texel 3,4; texel; describe b");
    Diary plays;
    plays.plays_until = 5;
    CHECK(plays.run("record start\nrecord stop p.csv\nplay p.csv\nprint x\n") ==
          "0: record; stop p.csv; play p.csv | 5: print x");
}

TEST_CASE("script: faults name their line") {
    const auto fault = [](const char* text) { return complaint([&] { (void)Diary().run(text); }); };
    CHECK(fault("\nclick none\n") == "s.txt:2: click: widget: none is not allowed; allowed: others");
    CHECK(contains(fault("wait -1\n"), "s.txt:1: wait: value: -1 is not allowed"));
    CHECK(contains(fault("mouse 1 b\n"), "s.txt:1: mouse: value: \"b\" is not allowed; allowed: a number"));
    CHECK(contains(fault("press top\n"), "button: top is not allowed; allowed: left, right, middle"));
    CHECK(contains(fault("texel 3\n"), "allowed: nothing after it, or X Y"));
    CHECK(contains(fault("click OK shift\n"), "click: shift is not allowed; allowed: ctrl, or nothing"));
    CHECK(contains(fault("record stop\n"), "allowed: start, or stop FILE"));
}
