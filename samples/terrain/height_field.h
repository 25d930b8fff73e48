// A height map made smooth and endless: resampled to a finer grid, continued in mirror image in all directions.
#pragma once

#include "io/height_map.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace aureole::app {

/// Places are (east, north) in metres from the middle of the map. Continuing in mirror image keeps heights and slopes free of
/// steps at the map's edges, so that the land reaches the horizon.
class HeightField {
public:
    /// Heights are multiplied by `exaggeration`.
    HeightField(const HeightMap& map, double exaggeration);

    [[nodiscard]] double height(glm::dvec2 place) const;
    /// Unit normal (east, north, up), smooth across cells.
    [[nodiscard]] glm::dvec3 normal(glm::dvec2 place) const;
    /// Share of the sky's cosine-weighted hemisphere that the land around leaves free, in [0, 1].
    [[nodiscard]] double open_sky(glm::dvec2 place) const;
    [[nodiscard]] double lowest() const noexcept { return lowest_; }
    [[nodiscard]] double highest() const noexcept { return highest_; }

    // Square-ish cells for ray casting. Level 0 is the grid itself, bilinear inside each cell; a cell of level n covers 2^n by
    // 2^n of them. Cells are numbered from the map's south-west corner, without bounds (the mirror images included).
    [[nodiscard]] int levels() const noexcept { return static_cast<int>(pyramid_.size()); }
    [[nodiscard]] glm::dvec2 cell_size(int level) const { return cell_ * static_cast<double>(1 << level); }
    /// South-west corner of cell (0, 0).
    [[nodiscard]] glm::dvec2 origin() const noexcept { return origin_; }
    /// Nothing in the cell is higher.
    [[nodiscard]] double ceiling(int level, std::int64_t x, std::int64_t y) const;

private:
    struct Corner {  // of the cell at a place: its grid points and how far in it the place is
        std::size_t p00, p10, p01, p11;
        double fx, fy;
        double sign_x, sign_y;  // -1 in mirror images
    };
    [[nodiscard]] Corner corner(glm::dvec2 place) const;
    void resample(const HeightMap& map, double exaggeration);
    void build_normals();
    void build_pyramid();
    void build_open_sky();

    std::int64_t nx_ = 0, ny_ = 0;  // cells of the map; (nx + 1) * (ny + 1) points, row 0 in the south
    glm::dvec2 cell_{}, origin_{};
    double lowest_ = 0, highest_ = 0;
    std::vector<float> points_;
    std::vector<glm::vec2> slopes_;  // d height / d east, d north, at the points
    std::vector<float> open_sky_;
    struct Level {
        std::int64_t width = 0, height = 0;
        std::vector<float> ceilings;
    };
    std::vector<Level> pyramid_;
};

}  // namespace aureole::app
