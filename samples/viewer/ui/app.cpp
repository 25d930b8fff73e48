#include "viewer/ui/app.h"

#include "viewer/core/flight.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace aureole::viewer {
namespace {

constexpr std::int32_t column_width = 440;
constexpr double scripted_frame_s = 1.0 / 60;

constexpr const char* first_scene = R"(
title = "Morning"
[[sun]]
elevation_deg = 12
bearing_deg = 20
irradiance = "sun"
[camera]
altitude_m = 250
elevation_deg = 12
)";

}  // namespace

App::App(const AppOptions& options)
    : options_(options),
      window_(options.width, options.height, "aureole-viewer"),
      gpu_(window_.handle(), options.gpu),
      screen_(gpu_, window_.size()),
      worker_(options.gpu.validation) {
    const app::Scene scene =
        options.scene.empty() ? app::parse_scene(first_scene, "the viewer's own scene") : app::read_scene(options.scene);
    session_.state = state_of(scene, options.backend);
    if (!options.script.empty()) script_.emplace(Script::read(options.script));
    size_ = window_.size();
}

App::~App() = default;

void App::run() {
    while (!quit_ && !window_.wants_to_close()) {
        window_.poll(!worker_.idle() ? 0.01 : script_ ? 0 : in_motion() ? 0.005 : 0.2);
        const VkExtent2D now = window_.size();
        if (now.width == 0 || now.height == 0) continue;
        if (now.width != size_.width || now.height != size_.height) screen_.resize(now);
        size_ = now;
        frame();
    }
    if (gpu_.findings() > 0)
        throw Error(ErrorCode::internal, "the validation layer has found " + std::to_string(gpu_.findings()) + " faults");
}

/// Something goes on without anybody doing more.
bool App::in_motion() const {
    if (session_.playing_s || session_.recording || drag_ != Drag::none || ImGui::GetIO().WantTextInput) return true;
    if (ImGui::IsAnyMouseDown()) return true;
    return std::ranges::any_of(std::string_view("WASDQE"), [](char key) { return ImGui::IsKeyDown(key); });
}

void App::frame() {
    take_pictures();
    if (script_ && on_screen_frames_++ > 0) {  // widgets are where the first frame puts them
        script_->before_frame(*this);
        if (quit_) return;
        if (script_->finished()) {  // the window is people's from here on
            script_.reset();
            input_ = {};
        }
    }
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    input_.apply();
    if (script_) ImGui::GetIO().DeltaTime = static_cast<float>(scripted_frame_s);
    ImGui::NewFrame();
    session_.marks.forget();
    build_column(static_cast<float>(size_.height));
    use_picture_area();
    advance(std::min<double>(ImGui::GetIO().DeltaTime, 0.1));
    draw_labels();
    ImGui::Render();
    submit();
    screen_.show(area());
    on_screen_ = session_.shown.number;
    save_pictures();
}

/// A new picture where there are new panes, or they are laid out otherwise.
void App::take_pictures() {
    std::optional<Shown> shown = worker_.take();
    const State& state = session_.state;
    const bool other_layout = state.layout != pictured_.layout || state.divider != pictured_.divider ||
                              state.difference_range != pictured_.difference_range;
    if (!shown && !other_layout) return;
    if (shown) {
        if (!shown->problem.empty()) {
            session_.message = shown->problem;
            shown->panes = session_.shown.panes;  // the last good ones stay
        }
        session_.shown = std::move(*shown);
        const PanePicture *a = session_.pane(0), *b = session_.pane(1);
        session_.apart.reset();
        if (a && b && a->linear.width > 0 && a->linear.width == b->linear.width && a->linear.height == b->linear.height)
            session_.apart = difference(a->linear, b->linear);
    }
    pictured_ = state;
    picture_ = picture_of(session_.shown, state);
    screen_.set_picture(picture_);
}

Area App::area() const {
    const auto width = static_cast<std::int32_t>(size_.width) - column_width;
    return {column_width, 0, static_cast<std::uint32_t>(std::max(width, 1)), size_.height};
}

VkExtent2D App::picture_size() const {
    const auto side = [&](std::uint32_t pixels) {
        return std::max(static_cast<std::uint32_t>(std::lround(pixels * session_.state.resolution)), 8u);
    };
    return {side(area().width), side(area().height)};
}

void App::submit() {
    const VkExtent2D size = picture_size();
    // What only lays the picture out needs no new panes.
    State wanted = session_.state;
    wanted.divider = submitted_.divider;
    wanted.difference_range = submitted_.difference_range;
    wanted.labels = submitted_.labels;
    const bool same_size = size.width == submitted_size_.width && size.height == submitted_size_.height;
    if (submitted_number_ > 0 && same_size && wanted == submitted_) return;
    submitted_ = session_.state;
    submitted_size_ = size;
    submitted_number_ = worker_.submit(session_.state, size.width, size.height);
}

void App::build_column(float height) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({static_cast<float>(column_width), height});
    ImGui::Begin(
        "panels", nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse);
    bool table = false, curves = false;
    if (ImGui::BeginTabBar("tabs")) {
        const auto tab = [&](const char* name, void (*panel)(Session&)) {
            const bool open = ImGui::BeginTabItem(name);
            session_.marks.last(std::string("tab.") + name);
            if (!open) return false;
            ImGui::BeginChild("panel");
            panel(session_);
            ImGui::EndChild();
            ImGui::EndTabItem();
            return true;
        };
        tab("Scene", scene_panel);
        tab("Air", air_panel);
        tab("Panes", panes_panel);
        tab("Passes", passes_panel);
        table = tab("Table", table_panel);
        curves = tab("Curves", curves_panel);
        tab("Files", files_panel);
        ImGui::EndTabBar();
    }
    ImGui::End();
    // Read back and measured only while somebody looks.
    if (table != table_open_) session_.state.table = table_open_ = table;
    if (curves != curves_open_) session_.state.curves = curves_open_ = curves;
}

/// Time goes by: keys fly, paths are flown and recorded.
void App::advance(double seconds) {
    Session& s = session_;
    if (s.playing_s) {
        *s.playing_s += seconds;
        if (s.path.points().empty() || *s.playing_s >= s.path.length_s()) {
            if (!s.path.points().empty()) stand_at(s.state.scene, s.path.points().back());
            s.playing_s.reset();
        } else {
            stand_at(s.state.scene, s.path.at(*s.playing_s));
        }
    } else if (!ImGui::GetIO().WantTextInput) {
        const auto held = [](char key) { return ImGui::IsKeyDown(key) ? 1.0 : 0.0; };  // GLFW's keys are ASCII's capitals
        const Stick stick{held('W') - held('S'), held('D') - held('A'), held('E') - held('Q'), ImGui::GetIO().KeyShift};
        fly(s.state.scene, s.ground_m(), stick, seconds);
    }
    if (!s.recording) return;
    if (s.path.points().empty() || s.recorded_s >= s.path.length_s() + 0.1)
        s.path.add(point_of(s.state.scene, s.altitude_m(), s.recorded_s));
    s.recorded_s += seconds;
}

void App::use_picture_area() {
    const ImGuiIO& io = ImGui::GetIO();
    const Area a = area();
    const double x = (static_cast<double>(io.MousePos.x) - a.x) / a.width,
                 y = (static_cast<double>(io.MousePos.y) - a.y) / a.height;
    const bool inside = x >= 0 && x < 1 && y >= 0 && y < 1 && !io.WantCaptureMouse;
    session_.mouse_pose.reset();
    const double aspect = static_cast<double>(a.width) / a.height;
    if (inside && session_.state.scene.camera.projection == Projection::matrix)
        session_.mouse_pose = pose_at(session_.state.scene, x, y, aspect);
    if (drag_ == Drag::none && inside) {
        const bool at_divider = session_.state.layout == Layout::split && std::abs(x - session_.state.divider) * a.width < 8;
        if (ImGui::IsMouseClicked(0)) drag_ = at_divider ? Drag::divider : Drag::look;
        if (ImGui::IsMouseClicked(1)) drag_ = Drag::sun;
    }
    if (drag_ != Drag::none && !ImGui::IsMouseDown(drag_ == Drag::sun ? 1 : 0)) drag_ = Drag::none;
    if (drag_ != Drag::none) drag_in_picture(x, y);
    app::SceneCamera& camera = session_.state.scene.camera;
    if (inside && io.MouseWheel != 0 && camera.projection == Projection::matrix)
        camera.vertical_fov_deg =
            std::clamp(camera.vertical_fov_deg * std::pow(0.9, static_cast<double>(io.MouseWheel)), 0.1, 170.0);
}

void App::drag_in_picture(double x, double y) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const Area a = area();
    app::Scene& scene = session_.state.scene;
    if (drag_ == Drag::divider) {
        session_.state.divider = std::clamp(x, 0.0, 1.0);
    } else if (drag_ == Drag::look) {
        const double degrees =
            scene.camera.projection == Projection::matrix ? scene.camera.vertical_fov_deg / a.height : 180.0 / a.height;
        turn(scene.camera.pose, -static_cast<double>(moved.x) * degrees, static_cast<double>(moved.y) * degrees);
    } else if (moved.x != 0 || moved.y != 0) {
        const double aspect = static_cast<double>(a.width) / a.height;
        drag_sun(scene, std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0), aspect,
                 {static_cast<double>(moved.x) / a.height, static_cast<double>(moved.y) / a.height});
    }
}

void App::draw_labels() {
    if (!session_.state.labels) return;
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    const Area a = area();
    const auto label = [&](float x, float y, const std::string& text) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        draw->AddRectFilled({x - 3, y - 2}, {x + size.x + 3, y + size.y + 2}, IM_COL32(0, 0, 0, 150));
        draw->AddText({x, y}, IM_COL32_WHITE, text.c_str());
    };
    const auto left = static_cast<float>(a.x) + 8;
    for (int i = 0; i < 2; ++i) {
        const PanePicture* pane = session_.state.shows(i) ? session_.pane(i) : nullptr;
        if (!pane) continue;
        const std::string text =
            std::string(i == 0 ? "A: " : "B: ") + pane->model + ", " + pane->backend.substr(0, pane->backend.find(" on "));
        label(left, 8 + static_cast<float>(20 * i), text);
    }
    char line[256];
    const app::Scene& scene = session_.state.scene;
    const auto bottom = static_cast<float>(a.height);
    std::snprintf(line, sizeof line, "%.4g m up, %.3g m/s; bearing %.1f deg, %.1f deg up", session_.altitude_m(),
                  flight_speed(session_.altitude_m() - session_.ground_m()), scene.camera.pose.bearing_deg,
                  scene.camera.pose.elevation_deg);
    label(left, bottom - 20, line);
    if (!scene.suns.empty()) {
        std::snprintf(line, sizeof line, "sun: bearing %.2f deg, %.2f deg up", scene.suns.front().pose.bearing_deg,
                      scene.suns.front().pose.elevation_deg);
        label(left, bottom - 40, line);
    }
    if (session_.mouse_pose) {
        std::snprintf(line, sizeof line, "mouse: bearing %.2f deg, %.2f deg up", session_.mouse_pose->bearing_deg,
                      session_.mouse_pose->elevation_deg);
        label(left, bottom - 60, line);
    }
    const bool drawing = submitted_number_ != session_.shown.number;
    if (drawing || !session_.message.empty())
        label(left, bottom - 80, drawing ? "drawing ... " + session_.message : session_.message);
}

}  // namespace aureole::viewer
