// The viewer as it runs: window, session, script, and the thread that draws the panes.
#pragma once

#include "viewer/core/script.h"
#include "viewer/panels/panels.h"
#include "viewer/ui/screen.h"
#include "viewer/ui/window.h"

#include <memory>

namespace aureole::viewer {

struct AppOptions {
    std::filesystem::path scene, script;  ///< Empty: a scene of its own; none.
    std::uint32_t width = 1280, height = 760;
    std::string backend = "vulkan";
    GpuOptions gpu;  ///< `validation` is of the panes' devices, too.
};

class App final : public Stage {
public:
    explicit App(const AppOptions& options);
    ~App() override;

    /// Until the window is closed. Throws Error: what a script has met, faults of the window's device.
    void run();

    void set(const std::string& field, const std::string& value) override;
    void print(const std::string& field) override;
    void load(const std::filesystem::path& file) override { session_.load(file); }
    void save(const std::filesystem::path& file) override { session_.save(file); }
    void resize(int width, int height) override { window_.resize(width, height); }
    [[nodiscard]] bool settled() override;
    void mouse(double x, double y) override { input_.mouse(x, y); }
    void button(int index, bool down) override { input_.button(index, down); }
    void wheel(double steps) override { input_.wheel(steps); }
    void key(const std::string& name, bool down) override { input_.key(name, down); }
    void type(const std::string& text) override { input_.type(text); }
    void point_at(const std::string& widget) override;
    void screenshot(const std::filesystem::path& file) override;
    void picture(const std::string& which, const std::filesystem::path& file) override;
    void texel(int x, int y) override;
    void texel_under_mouse() override;
    void describe(const std::string& which) override;
    void record(bool start, const std::filesystem::path& file) override;
    void play(const std::filesystem::path& file) override { session_.play(file); }
    [[nodiscard]] bool playing() override { return session_.playing_s.has_value(); }
    void quit() override { quit_ = true; }

private:
    void frame();
    [[nodiscard]] bool in_motion() const;
    void take_pictures();
    void build_column(float height);
    void advance(double seconds);
    void use_picture_area();
    void drag_in_picture(double x, double y);
    void draw_labels();
    void save_pictures();
    void submit();
    [[nodiscard]] Area area() const;
    [[nodiscard]] VkExtent2D picture_size() const;

    AppOptions options_;
    Window window_;
    Gpu gpu_;
    Screen screen_;
    ScriptedInput input_;
    std::optional<ScriptRunner> script_;
    Session session_;
    Worker worker_;
    VkExtent2D size_{};
    State submitted_;
    VkExtent2D submitted_size_{};
    std::uint64_t submitted_number_ = 0, on_screen_ = 0;
    int on_screen_frames_ = 0;  ///< Of a script.
    State pictured_;            ///< What the picture on the screen was made for.
    app::DisplayImage picture_;
    enum class Drag { none, look, sun, divider } drag_ = Drag::none;
    bool table_open_ = false, curves_open_ = false, quit_ = false;
};

}  // namespace aureole::viewer
