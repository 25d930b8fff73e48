#include "viewer/ui/app.h"

#include "io/csv.h"

#include <cstdio>

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
    std::printf("texel %s %d %d of slice %d: %s %s %s %s\n", pane->table->name.c_str(), x, y, pane->table->slice,
                app::print_number(t[0]).c_str(), app::print_number(t[1]).c_str(), app::print_number(t[2]).c_str(),
                app::print_number(t[3]).c_str());
    std::fflush(stdout);
}

void App::record(bool start, const std::filesystem::path& file) {
    if (start)
        session_.start_recording();
    else
        session_.stop_recording(file);
}

}  // namespace aureole::viewer
