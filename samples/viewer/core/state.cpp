#include "viewer/core/state.h"

namespace aureole::viewer {

std::span<const std::string_view> layout_names() {
    static constexpr std::array<std::string_view, 4> names{"a", "b", "split", "difference"};
    return names;
}

State state_of(const app::Scene& scene, const std::string& backend) {
    State state;
    state.scene = scene;
    for (PaneSetup& pane : state.panes) {
        pane.backend = backend;
        pane.model = scene.model;
    }
    return state;
}

app::Scene scene_of(const State& state) {
    app::Scene scene = state.scene;
    scene.model = state.panes[0].model;
    return scene;
}

}  // namespace aureole::viewer
