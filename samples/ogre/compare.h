// Is the picture right? The engine's, against the CPU backend's for the scene as the scene file states it, without the adapter
// and without OGRE's camera.
#pragma once

#include "engine.h"
#include "scene/scene.h"

#include <string>

namespace aureole::ogre {

struct Comparison {
    double sky_share = 0;  ///< Of the pixels, those without land.
    /// Largest relative difference of a channel of a pixel, of those without land and of those with it; below 1e-3 of the
    /// brightest against that.
    double sky_error = 0, land_error = 0;
    double light_error = 0;  ///< Of the colours of OGRE's sun and ambient light, relative to the brightest channel.
    double land_agrees = 0;  ///< Share of probed pixels in which rays meet land, or none, as the engine drew it.
    double depth_error = 0;  ///< Of nine in ten of the probed pixels with land: relative difference of depth, at most.

    [[nodiscard]] std::string text() const;
    /// Empty, or what is beyond its bound (compare.cpp says why those).
    [[nodiscard]] std::string complaint() const;
};

/// Of the frame that the engine has drawn last, whose camera and suns are the scene's. `altitude_m`: the camera's.
[[nodiscard]] Comparison compare(const Engine& engine, const app::Scene& scene, double altitude_m);

}  // namespace aureole::ogre
