// The panels: each draws one subject of the session into the column on the left.
#pragma once

#include "viewer/core/fields.h"
#include "viewer/core/path.h"
#include "viewer/core/studio.h"
#include "viewer/ui/marks.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace aureole::viewer {

/// What the window and its panels work on.
struct Session {
    State state;
    Shown shown;                      ///< The latest pictures.
    std::optional<Difference> apart;  ///< Of them, where both have radiance.
    std::uint64_t drawn = 0;          ///< Pictures so far.
    Marks marks;
    std::string message;                              ///< The latest fault or deed, for the line at the bottom.
    std::array<char, 512> file{};                     ///< Name in the file panel.
    float table_gain = 1;                             ///< Of the picture of a table.
    std::optional<std::array<int, 2>> texel;          ///< Under the mouse, or as a script asked.
    std::filesystem::path screenshot_to, picture_to;  ///< Asked for by a button; written once the frame is drawn.
    bool recording = false;
    double recorded_s = 0;                     ///< Time since it began.
    Path path;                                 ///< Recorded, or read.
    std::optional<double> playing_s;           ///< Time on it.
    std::optional<app::ScenePose> mouse_pose;  ///< Where the mouse points in the picture.

    void load(const std::filesystem::path& path_of_scene);
    void save(const std::filesystem::path& path_of_scene) const;
    void start_recording();
    void stop_recording(const std::filesystem::path& path_of_csv);
    void play(const std::filesystem::path& path_of_csv);
    /// Above the ground radius, as last drawn where the scene says it by its clearance.
    [[nodiscard]] double altitude_m() const;
    [[nodiscard]] double ground_m() const;
    [[nodiscard]] const PanePicture* pane(int index) const;
};

/// Runs what may throw; its fault becomes the message.
template <class Action>
void attempt(Session& session, Action action) {
    try {
        action();
    } catch (const std::exception& problem) {
        session.message = problem.what();
    }
}

/// A field's widget, named in the marks. True: something was chosen, and the state may have other fields now.
bool edit_field(Session& session, const Field& field);
/// Widgets for all fields of a group.
void edit_group(Session& session, const std::string& group);
/// A line for each row of a term's tables, with buttons to add and take out rows.
void edit_samples(Session& session, std::size_t term);

void scene_panel(Session& session);
void air_panel(Session& session);
void panes_panel(Session& session);
void passes_panel(Session& session);
void table_panel(Session& session);
void curves_panel(Session& session);
void files_panel(Session& session);

}  // namespace aureole::viewer
