#include "app/frame.h"

namespace aureole::app {

DisplayImage downsample(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    DisplayImage image{width / samples, height / samples, {}};
    image.rgb.resize(std::size_t{3} * image.width * image.height);
    const std::uint32_t count = samples * samples;
    // Thresholds of a 4 x 4 Bayer matrix, in sixteenths.
    static constexpr std::uint32_t bayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::uint32_t threshold = count * (2 * bayer[4 * (y % 4) + x % 4] + 1) / 32;
            for (std::uint32_t c = 0; c < 3; ++c) {
                std::uint32_t sum = 0;
                for (std::uint32_t j = 0; j < samples; ++j)
                    for (std::uint32_t i = 0; i < samples; ++i)
                        sum += rgba[4 * (std::size_t{y * samples + j} * width + x * samples + i) + c];
                image.rgb[3 * (std::size_t{y} * image.width + x) + c] = static_cast<std::uint8_t>((sum + threshold) / count);
            }
        }
    }
    return image;
}

LinearImage downsample(std::span<const float> rgba, std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    LinearImage image{width / samples, height / samples, {}};
    image.rgb.resize(std::size_t{3} * image.width * image.height);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                float sum = 0;
                for (std::uint32_t j = 0; j < samples; ++j)
                    for (std::uint32_t i = 0; i < samples; ++i)
                        sum += rgba[4 * (std::size_t{y * samples + j} * width + x * samples + i) + c];
                image.rgb[3 * (std::size_t{y} * image.width + x) + c] = sum / static_cast<float>(samples * samples);
            }
        }
    }
    return image;
}

}  // namespace aureole::app
