#include "viewer/panels/panels.h"

#include <algorithm>
#include <cmath>

namespace aureole::viewer {
namespace {

/// What is plotted along one axis, and between which ends.
struct Axis {
    const char* label;
    double least, most;
    bool logarithmic = false;
    [[nodiscard]] float place(double value) const {
        const double t =
            logarithmic ? std::log(std::max(value, least) / least) / std::log(most / least) : (value - least) / (most - least);
        return static_cast<float>(std::clamp(t, 0.0, 1.0));
    }
};

struct Plot {
    ImVec2 at, size;
    Axis x, y;
    [[nodiscard]] ImVec2 point(double px, double py) const {
        return {at.x + size.x * x.place(px), at.y + size.y * (1 - y.place(py))};
    }
};

Plot begin_plot(const Axis& x, const Axis& y) {
    Plot plot{ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x - 8, 190}, x, y};
    ImGui::GetWindowDrawList()->AddRectFilled(plot.at, {plot.at.x + plot.size.x, plot.at.y + plot.size.y},
                                              IM_COL32(20, 20, 24, 255));
    ImGui::GetWindowDrawList()->AddRect(plot.at, {plot.at.x + plot.size.x, plot.at.y + plot.size.y},
                                        IM_COL32(120, 120, 120, 255));
    return plot;
}

/// Red, green and blue of a list over another.
void lines(const Plot& plot, const std::vector<double>& x, const std::vector<Rgb>& y, bool upright) {
    static constexpr ImU32 colours[3] = {IM_COL32(255, 80, 70, 255), IM_COL32(90, 220, 90, 255), IM_COL32(100, 140, 255, 255)};
    for (int c = 0; c < 3; ++c) {
        std::vector<ImVec2> points;
        for (std::size_t i = 0; i < x.size(); ++i)
            points.push_back(upright ? plot.point(y[i][c], x[i]) : plot.point(x[i], y[i][c]));
        ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colours[c], 0, 1.5F);
    }
}

void end_plot(Session& session, const Plot& plot, const char* name) {
    ImGui::InvisibleButton(name, plot.size);
    session.marks.last(name);
    const auto value = [](const Axis& axis, double t) {
        return axis.logarithmic ? axis.least * std::pow(axis.most / axis.least, t) : axis.least + t * (axis.most - axis.least);
    };
    if (ImGui::IsItemHovered()) {
        const ImVec2 mouse = ImGui::GetMousePos();
        const double tx = static_cast<double>((mouse.x - plot.at.x) / plot.size.x),
                     ty = static_cast<double>(1 - (mouse.y - plot.at.y) / plot.size.y);
        ImGui::SetTooltip("%s %.4g\n%s %.4g", plot.x.label, value(plot.x, tx), plot.y.label, value(plot.y, ty));
    }
    ImGui::Text("across: %s, %.3g to %.3g%s", plot.x.label, plot.x.least, plot.x.most,
                plot.x.logarithmic ? ", by powers of ten" : "");
    ImGui::Text("up: %s, %.3g to %.3g", plot.y.label, plot.y.least, plot.y.most);
}

double greatest(const std::vector<Rgb>& values) {
    double most = 0;
    for (const Rgb& v : values) most = std::max({most, v.r, v.g, v.b});
    return most;
}

}  // namespace

void curves_panel(Session& session) {
    const PanePicture* pane = session.pane(session.state.table_pane);
    if (!pane || !pane->curves) {
        ImGui::TextWrapped("Nothing is drawn yet.");
        return;
    }
    const Curves& curves = *pane->curves;
    ImGui::TextWrapped("Share of the sun's light that reaches the camera, by the sun's elevation: of pane %s's own light pass",
                       session.state.table_pane == 0 ? "A" : "B");
    const Plot light = begin_plot({"elevation (deg)", -2, 90}, {"transmittance", 0, 1});
    lines(light, curves.sun_elevation_deg, curves.transmittance, false);
    end_plot(session, light, "plot.transmittance");

    ImGui::Separator();
    ImGui::TextWrapped("Extinction over altitude");
    const double most = std::max(greatest(curves.extinction_per_m), 1e-12);
    const Plot profile =
        begin_plot({"extinction (1/m)", most * 1e-4, most, true}, {"altitude (m)", 0, std::max(curves.altitude_m.back(), 1.0)});
    lines(profile, curves.altitude_m, curves.extinction_per_m, true);
    end_plot(session, profile, "plot.extinction");
}

}  // namespace aureole::viewer
