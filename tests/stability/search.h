// The worst of whole models, found by search: float against double over scenes in which all that the envelope names is anywhere
// at once (which is more than it states), at random and then uphill from the worst.
#pragma once

#include "stability/sweep.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace aureole::stability {

/// A point of the unit cube, which stands for a scene: base, radius, haze, g, altitude, sun, the ground's albedo.
using ScenePoint = std::array<double, 7>;
[[nodiscard]] Scene scene_at(const ScenePoint& u, Subject subject);
[[nodiscard]] std::string text_of(const Scene& scene);

/// A model in float on the CPU, and in double.
class ModelError {
public:
    explicit ModelError(const Rung& rung);
    /// Of the sky or of geometry, in the direction where it is largest. 0 where the library tells that the scene is outside the
    /// envelope.
    [[nodiscard]] double operator()(const Scene& scene, Subject subject);

private:
    ModelPtr model_;
    Observer seen_, exact_;
};

struct WorstScene {
    double error = 0;
    ScenePoint at{};
};
/// Of `starts` random points, and of as many steps uphill from the four worst.
[[nodiscard]] WorstScene search(ModelError& error, Subject subject, std::uint64_t seed, std::uint64_t starts);

/// A worst scene that is kept, with what may be off there.
struct KeptScene {
    const char* rung;
    Subject subject;
    double bound;
    ScenePoint at;
};
[[nodiscard]] std::span<const KeptScene> kept_scenes();

/// The models of a search, all of which keep floats in their tables, or have none.
[[nodiscard]] std::vector<Rung> searched_rungs();

}  // namespace aureole::stability
