#include "viewer/core/script.h"

#include "io/file.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace aureole::viewer {
namespace {

struct Command {
    std::string_view name;
    std::size_t least, most;  ///< Words after it.
    std::string_view usage;
};
constexpr std::array<Command, 22> commands{{
    {"set", 2, 2, "set FIELD VALUE"},
    {"print", 1, 1, "print FIELD"},
    {"load", 1, 1, "load FILE"},
    {"save", 1, 1, "save FILE"},
    {"resize", 2, 2, "resize WIDTH HEIGHT"},
    {"wait", 1, 1, "wait FRAMES"},
    {"settle", 0, 0, "settle"},
    {"mouse", 2, 2, "mouse X Y"},
    {"press", 1, 1, "press left|right|middle"},
    {"release", 1, 1, "release left|right|middle"},
    {"drag", 5, 5, "drag left|right|middle X Y X Y"},
    {"click", 1, 2, "click WIDGET [ctrl]"},
    {"hover", 1, 1, "hover WIDGET"},
    {"wheel", 1, 1, "wheel STEPS"},
    {"key", 2, 2, "key NAME FRAMES"},
    {"type", 1, 1, "type TEXT"},
    {"screenshot", 1, 1, "screenshot FILE"},
    {"picture", 2, 2, "picture a|b|shown FILE"},
    {"texel", 0, 2, "texel, or texel X Y"},
    {"describe", 1, 1, "describe a|b"},
    {"record", 1, 2, "record start, or record stop FILE"},
    {"play", 1, 1, "play FILE"},
}};
constexpr std::string_view quit = "quit";
constexpr std::array<std::string_view, 3> buttons{"left", "right", "middle"};
constexpr int drag_steps = 4;
constexpr int scrolled = 2;  ///< Frame in which a widget that was out of sight is where it can be clicked.

/// Words between blanks; quotes keep blanks together; # begins a comment.
std::vector<std::string> words_of(const std::string& line, const std::string& where) {
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, any = false;
    const auto end_word = [&] {
        if (any) words.push_back(word);
        word.clear();
        any = false;
    };
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if (!quoted && c == '#') {
            break;
        } else if (!quoted && (c == ' ' || c == '\t' || c == '\r')) {
            end_word();
        } else {
            word.push_back(c);
            any = true;
        }
    }
    if (quoted) throw Error(ErrorCode::invalid_argument, where + "a quote that is not closed");
    end_word();
    return words;
}

void check(const std::vector<std::string>& words, const std::string& where) {
    if (words[0] == quit && words.size() == 1) return;
    const auto command = std::ranges::find(commands, words[0], &Command::name);
    std::string all;
    for (const Command& c : commands) all.append(c.usage).append("; ");
    if (command == commands.end()) throw Error(ErrorCode::invalid_argument, where + words[0], "this command", all + "quit");
    const std::size_t count = words.size() - 1;
    if (count < command->least || count > command->most)
        throw Error(ErrorCode::invalid_argument, where + words[0], std::to_string(count) + " words after it", command->usage);
}

double number(const std::string& text) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size())
        throw Error(ErrorCode::invalid_argument, "value", '"' + text + '"', "a number");
    return value;
}

int whole(const std::string& text) {
    const double value = number(text);
    if (!(value >= 0 && value <= 1e6) || value != static_cast<int>(value))
        throw Error(ErrorCode::invalid_argument, "value", text, "a whole number in [0, 1e6]");
    return static_cast<int>(value);
}

int button_of(const std::string& name) {
    const auto found = std::ranges::find(buttons, name);
    if (found == buttons.end()) throw Error(ErrorCode::invalid_argument, "button", name, "left, right, middle");
    return static_cast<int>(found - buttons.begin());
}

void texel(Stage& stage, const std::vector<std::string>& words) {
    if (words.size() == 2) throw Error(ErrorCode::invalid_argument, "texel", words[1], "nothing after it, or X Y");
    if (words.size() == 1) return stage.texel_under_mouse();
    stage.texel(whole(words[1]), whole(words[2]));
}

}  // namespace

Script::Script(std::string_view text, std::string name) : name_(std::move(name)) {
    std::istringstream stream{std::string(text)};
    std::string line;
    for (int at = 1; std::getline(stream, line); ++at) {
        const std::string where = name_ + ":" + std::to_string(at) + ": ";
        ScriptLine read{at, words_of(line, where)};
        if (read.words.empty()) continue;
        check(read.words, where);
        lines_.push_back(std::move(read));
    }
}

Script Script::read(const std::filesystem::path& file) { return {app::read_text(file, 1 << 24), file.filename().string()}; }

std::string Script::where(const ScriptLine& line) const {
    return name_ + ":" + std::to_string(line.number) + ": " + line.words[0];
}

void ScriptRunner::before_frame(Stage& stage) {
    while (!finished()) {
        const ScriptLine& line = script_.lines()[next_];
        bool done = false;
        try {
            done = step(stage, line);
        } catch (const Error& problem) {
            throw Error(problem.code(), script_.where(line) + ": " + problem.what());
        }
        ++frame_;
        if (!done) return;
        ++next_;
        frame_ = 0;
        if (line.words[0] == quit) next_ = script_.lines().size();
    }
}

bool ScriptRunner::step(Stage& stage, const ScriptLine& line) {
    const std::vector<std::string>& w = line.words;
    const std::string& command = w[0];
    if (command == "set") return stage.set(w[1], w[2]), true;
    if (command == "print") return stage.print(w[1]), true;
    if (command == "load") return stage.load(w[1]), true;
    if (command == "save") return stage.save(w[1]), true;
    if (command == "resize") {
        if (frame_ == 0) stage.resize(whole(w[1]), whole(w[2]));
        return frame_ > 2;  // the window system has its own pace
    }
    if (command == "wait") return frame_ >= whole(w[1]);
    if (command == "settle") return frame_ >= 2 && stage.settled();  // the state of a frame is submitted at its end
    if (command == "type") return frame_ == 0 ? (stage.type(w[1]), false) : true;
    if (command == "screenshot") return stage.screenshot(w[1]), true;
    if (command == "picture") return stage.picture(w[1], w[2]), true;
    if (command == "texel") return texel(stage, w), true;
    if (command == "describe") return stage.describe(w[1]), true;
    if (command == "record") {
        if (w[1] != "start" && !(w[1] == "stop" && w.size() == 3))
            throw Error(ErrorCode::invalid_argument, "record", w[1], "start, or stop FILE");
        return stage.record(w[1] == "start", w.size() == 3 ? w[2] : ""), true;
    }
    if (command == "play") {
        if (frame_ == 0) stage.play(w[1]);
        return frame_ > 0 && !stage.playing();
    }
    if (command == "key") {
        const int frames = std::max(whole(w[2]), 1);
        if (frame_ == 0) stage.key(w[1], true);
        if (frame_ == frames) stage.key(w[1], false);
        return frame_ > frames;
    }
    if (command == quit) return stage.quit(), true;
    return act_with_mouse(stage, line);
}

/// A press and a release each have a frame of their own, as at a window.
bool ScriptRunner::act_with_mouse(Stage& stage, const ScriptLine& line) const {
    const std::vector<std::string>& w = line.words;
    if (w[0] == "mouse") {
        if (frame_ == 0) stage.mouse(number(w[1]), number(w[2]));
        return frame_ > 0;
    }
    if (w[0] == "press" || w[0] == "release") {
        if (frame_ == 0) stage.button(button_of(w[1]), w[0] == "press");
        return frame_ > 0;
    }
    if (w[0] == "hover") {
        if (frame_ <= scrolled) stage.point_at(w[1]);
        return frame_ > scrolled + 1;
    }
    if (w[0] == "click") {
        const bool with_key = w.size() == 3;
        if (with_key && w[2] != "ctrl") throw Error(ErrorCode::invalid_argument, "click", w[2], "ctrl, or nothing");
        if (frame_ <= scrolled) stage.point_at(w[1]);
        if (frame_ == scrolled && with_key) stage.key(w[2], true);
        if (frame_ == scrolled + 1) stage.button(0, true);
        if (frame_ == scrolled + 2) stage.button(0, false);
        if (frame_ == scrolled + 3 && with_key) stage.key(w[2], false);
        return frame_ > scrolled + 3;
    }
    if (w[0] == "wheel") {
        if (frame_ == 0) stage.wheel(number(w[1]));
        return frame_ > 0;
    }
    // drag: to the first point, press, in some steps to the second, release
    const double x0 = number(w[2]), y0 = number(w[3]), x1 = number(w[4]), y1 = number(w[5]);
    const int button = button_of(w[1]);
    if (frame_ == 0) stage.mouse(x0, y0);
    if (frame_ == 1) stage.button(button, true);
    if (frame_ >= 2 && frame_ < 2 + drag_steps) {
        const double t = static_cast<double>(frame_ - 1) / drag_steps;
        stage.mouse(x0 + t * (x1 - x0), y0 + t * (y1 - y0));
    }
    if (frame_ == 2 + drag_steps) stage.button(button, false);
    return frame_ > 2 + drag_steps;
}

}  // namespace aureole::viewer
