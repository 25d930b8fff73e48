#include "app/probe.h"

#include "app/solution.h"

#include "io/csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::uint32_t texture_width = 64;

/// Indices of the rows that share sun and altitude.
using Groups = std::map<std::pair<double, double>, std::vector<std::size_t>>;

/// The composite's inputs and output for the largest group.
class ProbeTarget {
public:
    ProbeTarget(Backend& backend, View& view, std::size_t rows) : textures_(backend) {
        const auto height = static_cast<std::uint32_t>((rows + texture_width - 1) / texture_width);
        targets_.extent = {texture_width, height, 1};
        targets_.target = textures_.create("radiance", rhi::Format::rgba32_float, targets_.extent,
                                           rhi::Usage::storage | rhi::Usage::copy_source);
        textures_.make_ready(targets_.target, rhi::State::storage_write);
        targets_.directions = textures_.create("directions", rhi::Format::rgba32_float, targets_.extent,
                                               rhi::Usage::sampled | rhi::Usage::copy_destination);
        view.prepare_composite(targets_);
        texels_.resize(std::size_t{4} * texture_width * height);
    }

    /// Unused texels look up.
    void look(std::span<const ProbeRow> rows, std::span<const std::size_t> group) {
        for (std::size_t i = 0; i < texels_.size() / 4; ++i) {
            glm::dvec3 d(0, 0, 1);
            if (i < group.size()) d = probe_direction(rows[group[i]].view_zenith_deg, rows[group[i]].azimuth_deg);
            for (int c = 0; c < 3; ++c) texels_[4 * i + static_cast<std::size_t>(c)] = static_cast<float>(d[c]);
        }
        textures_.upload(targets_.directions, std::as_bytes(std::span(texels_)),
                         filled_ ? rhi::State::sampled : rhi::State::undefined, rhi::State::sampled);
        filled_ = true;
    }
    [[nodiscard]] const CompositeTargets& targets() const { return targets_; }
    [[nodiscard]] std::vector<float> read() {
        return textures_.read_floats(targets_.target, texels_.size(), rhi::State::storage_write);
    }

private:
    DeviceTextures textures_;
    CompositeTargets targets_;
    std::vector<float> texels_;
    bool filled_ = false;
};

}  // namespace

glm::dvec3 probe_direction(double zenith_deg, double azimuth_deg) {
    const double z = zenith_deg * degree, a = azimuth_deg * degree;
    return {std::sin(z) * std::cos(a), std::sin(z) * std::sin(a), std::cos(z)};
}

void check_row(const ProbeRow& row, const std::string& place) {
    const auto check = [&](const char* field, double value, double low, double high) {
        if (!(value >= low && value <= high))
            throw Error(ErrorCode::invalid_argument, place + ": " + field, print_number(value),
                        "in [" + print_number(low) + ", " + print_number(high) + "]");
    };
    check("sun_zenith_deg", row.sun_zenith_deg, 0, 180);
    check("altitude_km", row.altitude_km, -10, 1e9);
    check("view_zenith_deg", row.view_zenith_deg, 0, 180);
    check("azimuth_deg", row.azimuth_deg, -360, 360);
}

std::vector<ProbeRow> read_probe_rows(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 4> columns{"sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg"};
    const CsvTable table = read_csv(path, columns);
    std::vector<ProbeRow> rows;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        rows.push_back({table.columns[0][i], table.columns[1][i], table.columns[2][i], table.columns[3][i]});
        check_row(rows.back(), path.string() + ":" + std::to_string(table.lines[i]));
    }
    return rows;
}

std::vector<Rgb> probe(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model,
                       std::span<const ProbeRow> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) check_row(rows[i], "row " + std::to_string(i + 1));
    if (rows.empty()) return {};
    return probe(backend, *solved(backend, parameters, model), rows);
}

std::vector<Rgb> probe(Backend& backend, Atmosphere& air, std::span<const ProbeRow> rows) {
    Groups groups;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        check_row(rows[i], "row " + std::to_string(i + 1));
        std::vector<std::size_t>& group = groups[{rows[i].sun_zenith_deg, rows[i].altitude_km}];
        group.push_back(i);
        largest = std::max(largest, group.size());
    }
    if (rows.empty()) return {};

    ViewSettings settings;
    settings.aerial_perspective = settings.light = false;
    CompositeSettings composite;
    composite.target_format = rhi::Format::rgba32_float;
    composite.sun_disk = false;
    View view(air, settings, composite);
    ProbeTarget target(backend, view, largest);

    const double radius = air.parameters().planet.bottom_radius_m;
    std::vector<Rgb> radiance(rows.size());
    for (const auto& [place, group] : groups) {
        Sun sun;
        sun.direction = probe_direction(place.first, 0);
        view.update(look(radius, place.second * 1000, 0, 0, 1, 1), {&sun, 1});
        target.look(rows, group);
        backend.run([&](rhi::CommandList& commands) {
            view.record(commands);
            view.record_composite(commands, target.targets());
        });
        const std::vector<float> texels = target.read();
        for (std::size_t i = 0; i < group.size(); ++i) {
            const Rgb value(texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]);
            if (!std::isfinite(value.r + value.g + value.b))
                throw Error(ErrorCode::internal, "the radiance of row " + std::to_string(group[i] + 1) + " is not finite");
            radiance[group[i]] = value;
        }
    }
    backend.check();
    return radiance;
}

std::string print_rows(const std::string& comment, std::span<const ProbeRow> rows, std::span<const Rgb> radiance) {
    std::string text = "# " + comment + "\nsun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg,r,g,b\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ProbeRow& row = rows[i];
        for (const double value : {row.sun_zenith_deg, row.altitude_km, row.view_zenith_deg, row.azimuth_deg})
            text.append(print_number(value)).append(",");
        for (int c = 0; c < 3; ++c) text.append(print_number(static_cast<float>(radiance[i][c]))).append(c < 2 ? "," : "\n");
    }
    return text;
}

}  // namespace aureole::app
