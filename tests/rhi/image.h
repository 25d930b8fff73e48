// A texture as numbers.
#pragma once

#include <aureole/rhi/types.h>

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace aureole::passes {

/// A texture's texels, row by row, slice by slice.
struct Image {
    rhi::Extent extent{};
    std::vector<glm::dvec4> texels{};

    [[nodiscard]] const glm::dvec4& at(std::uint32_t x, std::uint32_t y, std::uint32_t z = 0) const {
        return texels.at((std::size_t{z} * extent.height + y) * extent.width + x);
    }
    [[nodiscard]] bool operator==(const Image&) const = default;
};

}  // namespace aureole::passes
