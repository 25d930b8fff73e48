// What costs are measured over: a camera, and what a host would hand over.
#pragma once

#include "app/backend.h"
#include "app/pass_costs.h"

#include <cstdint>

namespace aureole::app {

/// Into what `options` wants; of a picture over a host's colour and depth, or of sky alone.
[[nodiscard]] CompositeSettings cost_composite(const PassCostOptions& options, bool geometry);

/// 500 m above the ground, level.
[[nodiscard]] Camera cost_camera(const Planet& planet, const PassCostOptions& options);

/// Targets, and a host's colour, depth and shadow map: a plain under the camera up to the middle of the picture, then a ridge,
/// then sky; and stripes of shade, each as wide as the light between.
class CostTextures {
public:
    CostTextures(Backend& backend, const PassCostOptions& options);

    [[nodiscard]] const CompositeTargets& targets(bool geometry) const { return geometry ? geometry_ : plain_; }
    /// Of the first sun, over a planet.
    [[nodiscard]] ShadowMap shadow_map(const Planet& planet) const;

private:
    void make_scene(const PassCostOptions& options);
    void make_shadow_map();

    DeviceTextures own_;
    CompositeTargets plain_, geometry_;
    rhi::Texture shadow_map_{};
};

}  // namespace aureole::app
