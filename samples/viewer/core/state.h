// What the viewer shows: one scene, two ways to draw it, and how they are laid out. Plain values: no window, no device.
#pragma once

#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace aureole::viewer {

enum class Layout : std::uint8_t {
    a,           ///< Pane A alone.
    b,           ///< Pane B alone.
    split,       ///< A to the left of the divider, B to the right of it: the same camera.
    difference,  ///< B less A, relative, in false colour (difference.h).
};
[[nodiscard]] std::span<const std::string_view> layout_names();  ///< "a", "b", "split", "difference".

/// What draws a pane.
struct PaneSetup {
    std::string backend = "vulkan";  ///< As app::BackendOptions::name.
    app::SceneModel model;           ///< Without `planned`.
    bool planned = false;            ///< The planner chooses the model, for this scene and this tolerance.
    double tolerance = 0.05;         ///< Relative error of radiance, as PlanRequirements::tolerance. In [1e-4, 10].
    [[nodiscard]] bool operator==(const PaneSetup&) const = default;
};

struct State {
    app::Scene scene;  ///< Its model is that of pane A when it is saved; its size is not used.
    std::array<PaneSetup, 2> panes;
    Layout layout = Layout::a;
    double divider = 0.5;           ///< Of a split, as a share of the width. In [0, 1].
    double difference_range = 0.1;  ///< Relative difference that has the full colour. In [1e-6, 10].
    double resolution = 0.5;        ///< Pixels of a picture for each of the window's, along a side. In [0.05, 1].
    bool labels = true;             ///< Over the picture: which pane is which, and where the camera is.
    bool curves = false;            ///< Make them (curves.h).
    bool table = false;             ///< Read a table back (tables.h):
    int table_pane = 0;             ///< of this pane,
    std::string table_name;         ///< of this name (empty: the first),
    int table_slice = 0;            ///< this slice of it.
    [[nodiscard]] bool operator==(const State&) const = default;

    [[nodiscard]] bool shows(int pane) const {
        return layout == Layout::split || layout == Layout::difference || layout == (pane == 0 ? Layout::a : Layout::b);
    }
};

/// For a scene as it was read: both panes draw with its model on `backend`.
[[nodiscard]] State state_of(const app::Scene& scene, const std::string& backend);
/// The scene as it would be saved: with the model of pane A.
[[nodiscard]] app::Scene scene_of(const State& state);

}  // namespace aureole::viewer
