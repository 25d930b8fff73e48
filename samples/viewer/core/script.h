// Scripts: what somebody at the window would do, line by line. The page (viewer.md) lists the commands.
//
//     load noon.toml
//     settle
//     drag right 900 300 700 200   # the sun to another place
//     settle
//     screenshot evening.png
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::viewer {

struct ScriptLine {
    int number = 0;
    std::vector<std::string> words;
};

class Script {
public:
    Script() = default;
    /// Checks commands and the number of their words. Throws Error(invalid_argument) with file, line and what is allowed.
    Script(std::string_view text, std::string name);
    /// Throws Error(io), too.
    [[nodiscard]] static Script read(const std::filesystem::path& file);

    [[nodiscard]] const std::vector<ScriptLine>& lines() const { return lines_; }
    /// "tour.txt:12: drag", for messages.
    [[nodiscard]] std::string where(const ScriptLine& line) const;

private:
    std::string name_;
    std::vector<ScriptLine> lines_;
};

/// What commands act on: the window, or a stand-in for it. What throws ends the script.
class Stage {
public:
    virtual ~Stage() = default;

    virtual void set(const std::string& field, const std::string& value) = 0;
    virtual void print(const std::string& field) = 0;
    virtual void load(const std::filesystem::path& file) = 0;
    virtual void save(const std::filesystem::path& file) = 0;
    virtual void resize(int width, int height) = 0;  ///< The window, pixels.
    /// The panes show the newest state.
    [[nodiscard]] virtual bool settled() = 0;

    // What the next frame of the window finds: in its pixels, from the upper left.
    virtual void mouse(double x, double y) = 0;
    virtual void button(int index, bool down) = 0;  ///< 0 left, 1 right, 2 middle.
    virtual void wheel(double steps) = 0;
    virtual void key(const std::string& name, bool down) = 0;
    virtual void type(const std::string& text) = 0;
    /// The mouse goes to the middle of a widget of the frame before, which is scrolled into sight. Error(invalid_argument)
    /// where there is none of that name.
    virtual void point_at(const std::string& widget) = 0;

    virtual void screenshot(const std::filesystem::path& file) = 0;  ///< Of the whole window, as the last frame drew it.
    virtual void picture(const std::string& which, const std::filesystem::path& file) = 0;  ///< "a", "b" or "shown".
    virtual void texel(int x, int y) = 0;                                                   ///< Of the table that is shown.
    virtual void texel_under_mouse() = 0;                ///< The one whose numbers the panel shows.
    virtual void describe(const std::string& pane) = 0;  ///< "a" or "b": what draws it, and why.
    virtual void record(bool start, const std::filesystem::path& file) = 0;
    virtual void play(const std::filesystem::path& file) = 0;
    [[nodiscard]] virtual bool playing() = 0;
    virtual void quit() = 0;
};

/// Goes through a script: before each frame of the window, as far as it gets without another frame.
class ScriptRunner {
public:
    explicit ScriptRunner(Script script) : script_(std::move(script)) {}
    [[nodiscard]] bool finished() const { return next_ >= script_.lines().size(); }
    /// Throws Error naming file and line, whatever the stage has thrown.
    void before_frame(Stage& stage);

private:
    /// True: the line is done. False: it goes on in the next frame.
    [[nodiscard]] bool step(Stage& stage, const ScriptLine& line);
    [[nodiscard]] bool act_with_mouse(Stage& stage, const ScriptLine& line) const;

    Script script_;
    std::size_t next_ = 0;
    int frame_ = 0;  ///< Of the line: frames that it has had.
};

}  // namespace aureole::viewer
