#include "measure/pictures.h"

#include "measure/kept.h"
#include "measure/measure.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aureole::app {
namespace {

using nlohmann::json;

constexpr std::uint32_t half_width = picture_width / 2;

/// Linear colours at even steps of the scale.
constexpr double scale_end = 10;
constexpr std::array<std::array<float, 3>, 5> scale{
    {{0, 0, 0}, {0.1F, 0.02F, 0.35F}, {0.8F, 0.03F, 0.04F}, {0.95F, 0.7F, 0.02F}, {1, 1, 1}}};

std::array<float, 3> scale_colour(double difference) {
    const double at = std::clamp(difference / scale_end, 0.0, 1.0) * (scale.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(at), scale.size() - 2);
    std::array<float, 3> colour;
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = std::lerp(scale[below][c], scale[below + 1][c], static_cast<float>(at - static_cast<double>(below)));
    return colour;
}

/// A picture of both halves; `colour` is asked for each direction of the one.
template <class Colour>
LinearImage mirrored(const Colour& colour) {
    LinearImage image{picture_width, picture_height, {}};
    image.rgb.resize(std::size_t{3} * picture_width * picture_height);
    for (std::uint32_t y = 0; y < picture_height; ++y)
        for (std::uint32_t x = 0; x < half_width; ++x) {
            const std::array<float, 3> rgb = colour(std::size_t{y} * half_width + x);
            for (const std::uint32_t column : {half_width + x, half_width - 1 - x})
                std::ranges::copy(rgb, image.rgb.begin() + 3 * (std::ptrdiff_t{y} * picture_width + column));
        }
    return image;
}

/// The scenes of an air that have pictures, and their truth.
struct Gallery {
    std::vector<std::size_t> scenes;
    std::vector<ProbeRow> rows;  ///< Of all, one scene after the other.
    std::vector<Rgb> truth;
    std::vector<double> exposures;  ///< Of each scene.
    std::string key;                ///< Names the scenes and their truth.
};

constexpr std::size_t picture_rows_count = std::size_t{half_width} * picture_height;

Gallery gallery_of(const Suite& suite, std::size_t air) {
    Gallery gallery;
    const std::filesystem::path file = truth_file(suite, suite.airs[air], TruthKind::picture);
    const TruthTable table = TruthTable::read(file, truth_parameters(suite.airs[air]), TruthKind::picture);
    for (const std::size_t i : suite.scenes_of(air)) {
        if (!suite.scenes[i].picture) continue;
        std::vector<TrueValue> truth;
        for (const ProbeRow& row : picture_rows(suite.scenes[i])) {
            const TruthTable::Entry* entry = table.find(row);
            if (!entry)
                throw Error(ErrorCode::invalid_argument,
                            file.string() + " lacks scenes of the suite; `aureole truth` adds them");
            gallery.rows.push_back(row);
            truth.push_back(entry->value);
            gallery.truth.push_back(entry->value.value);
        }
        gallery.scenes.push_back(i);
        gallery.exposures.push_back(fixed_exposure(truth));
        gallery.key += suite.id(suite.scenes[i]) + " " + std::to_string(fingerprint(truth)) + " ";
    }
    return gallery;
}

std::string png(const LinearImage& image) { return base64(encode_png(image)); }

json truth_pictures(const Suite& suite, const Gallery& gallery) {
    json pictures = json::array();
    for (std::size_t k = 0; k < gallery.scenes.size(); ++k) {
        const std::span truth = std::span(gallery.truth).subspan(k * picture_rows_count, picture_rows_count);
        pictures.push_back({{"scene", suite.id(suite.scenes[gallery.scenes[k]])},
                            {"setting", "truth"},
                            {"png", png(picture_of(truth, gallery.exposures[k]))}});
    }
    return pictures;
}

json pictures_of(const Suite& suite, const Setting& setting, const Gallery& gallery, std::span<const Rgb> seen) {
    json pictures = json::array();
    for (std::size_t k = 0; k < gallery.scenes.size(); ++k) {
        const std::span truth = std::span(gallery.truth).subspan(k * picture_rows_count, picture_rows_count);
        const std::span shown = seen.subspan(k * picture_rows_count, picture_rows_count);
        pictures.push_back({{"scene", suite.id(suite.scenes[gallery.scenes[k]])},
                            {"setting", setting.id()},
                            {"png", png(picture_of(shown, gallery.exposures[k]))},
                            {"difference_png", png(difference_of(shown, truth, gallery.exposures[k]))}});
    }
    return pictures;
}

}  // namespace

std::vector<ProbeRow> picture_rows(const SuiteScene& scene) {
    constexpr double pixel_deg = 180.0 / picture_height;
    std::vector<ProbeRow> rows;
    for (std::uint32_t y = 0; y < picture_height; ++y)
        for (std::uint32_t x = 0; x < half_width; ++x)
            rows.push_back({scene.sun_zenith_deg(), scene.altitude_km(), (y + 0.5) * pixel_deg, (x + 0.5) * pixel_deg});
    return rows;
}

LinearImage picture_of(std::span<const Rgb> radiance, double exposure) {
    return mirrored([&](std::size_t i) {
        const glm::vec3 shown(radiance[i] * exposure);
        return std::array{shown.r, shown.g, shown.b};
    });
}

LinearImage difference_of(std::span<const Rgb> radiance, std::span<const Rgb> truth, double exposure) {
    return mirrored([&](std::size_t i) { return scale_colour(shown_difference(radiance[i], truth[i], exposure)); });
}

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

json measure_pictures(const Suite& suite, const MeasureOptions& options, Backend& run,
                      const std::function<void(std::size_t done, std::size_t items)>& after_item) {
    json all = json::array();
    const std::size_t items = suite.airs.size() * suite.settings.size();
    for (std::size_t a = 0; a < suite.airs.size(); ++a) {
        const SuiteAir& air = suite.airs[a];
        const Gallery gallery = gallery_of(suite, a);
        for (const json& picture : truth_pictures(suite, gallery)) all.push_back(picture);
        for (std::size_t s = 0; s < suite.settings.size(); ++s) {
            const Setting& setting = suite.settings[s];
            if (!gallery.scenes.empty() && is_for(setting, air)) {
                const json key{{"scenes", gallery.key},
                               {"setting", setting.id()},
                               {"air", print_parameters(truth_parameters(air))},
                               {"device", run.describe()},
                               {"build", build_stamp()}};
                const json pictures =
                    kept_or(options.out / "items" / air.name / ("pictures_" + file_name(setting.id())), key, [&] {
                        const Prepared prepared = prepare(setting, air.parameters).value();
                        return pictures_of(suite, setting, gallery, probe(run, prepared.air, prepared.model, gallery.rows));
                    });
                for (const json& picture : pictures) all.push_back(picture);
            }
            after_item(a * suite.settings.size() + s + 1, items);
        }
    }
    return all;
}

}  // namespace aureole::app
