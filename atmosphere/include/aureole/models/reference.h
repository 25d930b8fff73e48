// Path tracing: radiance of all orders of scattering, for truth and for stills. Noise, of which it says how much; and with
// Tracking::quadrature the error of Gauss nodes, with Tracking::ratio none. See models/reference/reference.md.
#pragma once

#include <aureole/model.h>

#include <span>
#include <vector>

namespace aureole::models {

/// How many paths, and what is shown of them.
struct ReferenceSettings {
    /// What the composite shows: `show`.
    enum class Show : std::uint8_t {
        radiance,
        standard_error,  ///< Of the radiance that the same settings give, before CompositeSettings: 0 where nothing is random.
    };
    Show show = Show::radiance;  ///< What the composite shows.

    /// How transmittances are found.
    enum class Tracking : std::uint8_t {
        quadrature,  ///< By `nodes` Gauss nodes, which miss a little: reference.md has figures.
        ratio,       ///< By ratio tracking between bounds of the profiles: no bias. The first order is then found by paths, too
                     ///< (but for the light table's), whatever sampled_first_order says. The sun's disk, and what else lies
                     ///< beyond the air, is seen through transmittances by nodes as before.
    };
    Tracking tracking = Tracking::quadrature;  ///< How transmittances are found.

    /// Paths of a pixel in each composite, and of a texel of the film in each View::record until it has max_paths. In [0,
    /// 65536]: with 0 only what is known without paths is shown. The film takes them 32 at a time (8 with Tracking::ratio); a
    /// composite all at once, which a GPU must finish before its driver loses patience, and of which Mesa's llvmpipe finishes
    /// some 130 (reference.md).
    int paths_per_frame = 16;
    /// Of a texel of the film: then it is left as it is. In [1, 16777216].
    int max_paths = 4096;
    /// Size of the film, in texels: a table of the view in which paths of all frames add up while camera, suns and air stay. It
    /// has the camera's own projection: give it the target's size, else the picture is interpolated from it. 0 x 0: none, and
    /// every composite traces its own paths. Each in [1, 16384], three times the height within Capabilities::max_texture_2d.
    /// Geometry and given directions (CompositeTargets::directions) are always traced by the composite.
    std::uint32_t film_width = 0, film_height = 0;
    /// Events of scattering and reflection by the ground that light may go through; 0: any number (4096 at most, of which
    /// roulette leaves nothing). In [0, 4096].
    int max_order = 0;
    /// Light that has been scattered or reflected once by paths too: better where nodes are too far apart (fog that is thin
    /// compared with the ray), and noisier. False: by Gauss nodes.
    bool sampled_first_order = false;
    /// Pieces of the camera's ray for the first order: 1, 2, 4, 8 or 16, with `nodes` nodes on each smooth part of each.
    int first_order_parts = 16;
    /// Gauss nodes of the first order and, with Tracking::quadrature, of every transmittance. In [4, 16]. What they miss is the
    /// bias.
    int nodes = 16;
    /// From this event on paths end at random, and survivors count for them. In [1, 4096]. More: less noise, more work.
    int roulette_order = 4;
    /// Another seed, other paths. In [0, 16777215]. Equal seeds give equal pictures; composites also differ by the frame number
    /// (Atmosphere::set_frame, modulo 1024), so that a host may average them.
    int seed = 0;
    /// Paths of each of the 192 directions of the light table. In [0, 4096].
    int light_paths = 8;

    /// Throws Error(invalid_argument) at the first value outside its range.
    void validate() const;
    /// By name: "low", "default" or "high", by paths_per_frame: 4, 16, 64. Else Error(invalid_argument) naming "quality".
    [[nodiscard]] static ReferenceSettings by_name(std::string_view quality);
};

/// Throws Error(invalid_argument) at the first setting outside its range.
[[nodiscard]] ModelPtr reference(const ReferenceSettings& settings = {});

/// What View::film_table() holds, once the host has read it back: the texture's texels, RGBA, row by row. In State::sampled
/// when it is not recorded to.
class ReferenceFilm {
public:
    /// Copied. Error(invalid_argument) unless there are 3 x 4 floats for each texel of a film of this size.
    ReferenceFilm(std::span<const float> texels, std::uint32_t width, std::uint32_t height);

    /// Radiance, times the suns' irradiance, before the exposure. x in [0, width), y in [0, height), else
    /// Error(invalid_argument).
    [[nodiscard]] Rgb radiance(std::uint32_t x, std::uint32_t y) const;
    /// Its standard error: the paths' standard deviation over the square root of their number.
    [[nodiscard]] Rgb standard_error(std::uint32_t x, std::uint32_t y) const;
    /// Paths so far.
    [[nodiscard]] int paths(std::uint32_t x, std::uint32_t y) const;

private:
    [[nodiscard]] const float* texel(std::uint32_t x, std::uint32_t y, std::uint32_t layer) const;

    std::vector<float> texels_;
    std::uint32_t width_, height_;
};

}  // namespace aureole::models
