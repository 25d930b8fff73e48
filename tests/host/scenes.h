// Places and hours at which a host looks things up.
#pragma once

#include <string>
#include <vector>

#include "host/questions.h"

namespace aureole::host {

struct Scene {
    std::string name{};
    passes::Setup setup{};
    double altitude_m = 2;
    std::vector<Sun> suns{};
    Camera camera{};
};

/// Day, dawn, dusk, space, two suns, no air; a tabulated phase function behind a fisheye; another model.
[[nodiscard]] std::vector<Scene> scenes();
[[nodiscard]] Scene noon();

/// Aerosols whose phase function is a table.
[[nodiscard]] AtmosphereParameters tabulated_haze();

/// A scene on a backend, recorded.
struct Shown {
    Shown(std::unique_ptr<passes::Backend> open, const Scene& scene);
    /// Replaces the tables by those of another backend, so that the look-ups alone differ.
    void take_tables(Shown& other);

    std::unique_ptr<passes::Backend> backend;
    passes::Rig rig;
};

}  // namespace aureole::host
