#include "viewer/ui/app.h"

#include "io/csv.h"

#include <cstdio>
#include <utility>

namespace aureole::viewer {

void App::set(const std::string& field, const std::string& value) { set_field(session_.state, field, value); }

void App::print(const std::string& field) {
    std::printf("%s = %s\n", field.c_str(), get_field(session_.state, field).c_str());
    std::fflush(stdout);
}

bool App::settled() {
    if (submitted_number_ == 0 || on_screen_ != submitted_number_ || !worker_.idle()) return false;
    if (!session_.shown.problem.empty()) throw Error(ErrorCode::internal, session_.shown.problem);
    return true;
}

void App::point_at(const std::string& widget) {
    const auto place = session_.marks.places().find(widget);
    if (place == session_.marks.places().end()) {
        std::string all;
        for (const auto& [name, where] : session_.marks.places()) all.append(all.empty() ? "" : ", ").append(name);
        throw Error(ErrorCode::invalid_argument, "widget", '"' + widget + '"', all);
    }
    session_.marks.scroll_to(widget);
    input_.mouse(static_cast<double>(place->second.x), static_cast<double>(place->second.y));
}

void App::screenshot(const std::filesystem::path& file) { app::write_png(file, screen_.screenshot()); }

void App::picture(const std::string& which, const std::filesystem::path& file) {
    if (which == "shown") return app::write_png(file, picture_);
    if (which != "a" && which != "b") throw Error(ErrorCode::invalid_argument, "picture", which, "a, b, shown");
    const PanePicture* pane = session_.pane(which == "a" ? 0 : 1);
    if (!pane) throw Error(ErrorCode::misuse, "picture: pane " + which + " has not been drawn");
    app::write_png(file, pane->display);
}

void App::texel(int x, int y) {
    const PanePicture* pane = session_.pane(session_.state.table_pane);
    if (!pane || !pane->table) throw Error(ErrorCode::misuse, "texel: no table is shown; set view.table true, then settle");
    const float* t = pane->table->texel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    session_.texel = std::array{x, y};
    std::printf("texel %s %d %d of slice %d: %s %s %s %s; greatest %s\n", pane->table->name.c_str(), x, y, pane->table->slice,
                app::print_number(t[0]).c_str(), app::print_number(t[1]).c_str(), app::print_number(t[2]).c_str(),
                app::print_number(t[3]).c_str(), app::print_number(pane->table->greatest).c_str());
    std::fflush(stdout);
}

void App::texel_under_mouse() {
    if (!session_.texel) throw Error(ErrorCode::misuse, "texel: the mouse has not been over a table");
    texel((*session_.texel)[0], (*session_.texel)[1]);
}

void App::describe(const std::string& which) {
    if (which != "a" && which != "b") throw Error(ErrorCode::invalid_argument, "pane", which, "a, b");
    const PanePicture* pane = session_.pane(which == "a" ? 0 : 1);
    if (!pane) throw Error(ErrorCode::misuse, "describe: pane " + which + " has not been drawn");
    std::printf("pane %s: %s, %s\n%s", which.c_str(), pane->model.c_str(), pane->backend.c_str(),
                pane->plan.empty() ? "" : (pane->plan + "\n").c_str());
    std::fflush(stdout);
}

/// What the file panel's buttons have asked for in this frame.
void App::save_pictures() {
    const auto save = [&](std::filesystem::path& wanted, auto write) {
        const std::filesystem::path file = std::exchange(wanted, {});
        if (file.empty()) return;
        attempt(session_, [&] {
            write(file);
            session_.message = "wrote " + file.string();
        });
    };
    save(session_.screenshot_to, [&](const auto& file) { screenshot(file); });
    save(session_.picture_to, [&](const auto& file) { picture("shown", file); });
}

void App::record(bool start, const std::filesystem::path& file) {
    if (start)
        session_.start_recording();
    else
        session_.stop_recording(file);
}

}  // namespace aureole::viewer
