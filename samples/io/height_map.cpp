#include "io/height_map.h"

#include "io/csv.h"
#include "io/image.h"
#include "io/npz.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole::app {
namespace {

constexpr const char* jacksboro = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz";
constexpr double earth_radius_m = 6371008.8;  // mean radius, IUGG
constexpr double highest_m = 1e5;

/// Numbers in the file's own units, before `HeightMapOptions` apply.
struct RawGrid {
    std::size_t width = 0, height = 0;
    std::vector<float> values;
    double spacing_east_m = 0, spacing_north_m = 0;  // 0: unknown
};

double read_number(const NpzFile& file, const std::string& name, const std::string& where) {
    const NpyArray array = file.read(name);
    if (array.values.size() != 1 || !std::isfinite(array.values[0]))
        throw Error(ErrorCode::invalid_argument, where + ": array " + name + " is not a single finite number");
    return array.values[0];
}

void read_spacing(const NpzFile& file, const std::string& where, RawGrid& grid) {
    for (const char* name : {"dx", "dy", "ymin", "ymax"})
        if (!file.has(name)) return;
    const double meters_per_degree = earth_radius_m * std::numbers::pi / 180;
    const double latitude = 0.5 * (read_number(file, "ymin", where) + read_number(file, "ymax", where));
    const double dx = read_number(file, "dx", where), dy = read_number(file, "dy", where);
    if (!(std::abs(latitude) < 89 && dx > 0 && dx < 10 && dy > 0 && dy < 10))
        throw Error(ErrorCode::invalid_argument, where + ": arrays dx, dy, ymin, ymax",
                    print_number(dx) + ", " + print_number(dy) + ", mean latitude " + print_number(latitude),
                    "spacings in (0, 10) degrees and a latitude within 89 degrees of the equator");
    grid.spacing_east_m = dx * meters_per_degree * std::cos(latitude * std::numbers::pi / 180);
    grid.spacing_north_m = dy * meters_per_degree;
}

RawGrid read_npz_grid(const std::filesystem::path& path) {
    const NpzFile file(path);
    const std::string name = file.names().size() == 1 ? file.names().front() : "elevation";
    if (!file.has(name)) {
        std::string all;
        for (const std::string& n : file.names()) all.append(all.empty() ? "" : ", ").append(n);
        throw Error(ErrorCode::invalid_argument, path.string() + ": arrays of the archive", all,
                    "one called elevation, or only one");
    }
    const NpyArray array = file.read(name);
    if (array.shape.size() != 2)
        throw Error(ErrorCode::invalid_argument, path.string() + ": shape of array " + name,
                    std::to_string(array.shape.size()) + " dimensions", "2 (rows, columns)");
    check_grey_size(path, array.shape[1], array.shape[0]);
    RawGrid grid{array.shape[1], array.shape[0], {array.values.begin(), array.values.end()}};
    read_spacing(file, path.string(), grid);
    return grid;
}

RawGrid read_raw(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".npz") return read_npz_grid(path);
    if (extension != ".png" && extension != ".exr")
        throw Error(ErrorCode::invalid_argument, "heightmap", path.string(),
                    "jacksboro, or a file that ends in .npz, .png or .exr");
    GreyImage image = extension == ".png" ? read_png_grey(path) : read_exr_grey(path);
    return {image.width, image.height, std::move(image.values)};
}

void check_options(const HeightMapOptions& options) {
    const auto check = [](const char* field, double value, bool good, const char* allowed) {
        if (!good) throw Error(ErrorCode::invalid_argument, field, print_number(value), allowed);
    };
    if (options.spacing_m)
        check("spacing_m", *options.spacing_m, *options.spacing_m >= 0.01 && *options.spacing_m <= 1e6, "in [0.01, 1e6]");
    const double scale = std::abs(options.meters_per_unit);
    check("meters_per_unit", options.meters_per_unit, scale >= 1e-6 && scale <= 1e6, "of size in [1e-6, 1e6]");
    check("offset_m", options.offset_m, std::abs(options.offset_m) <= highest_m, "in [-100000, 100000]");
}

}  // namespace

HeightMap read_height_map(const std::filesystem::path& path, const HeightMapOptions& options) {
    check_options(options);
    const std::filesystem::path file = path == "jacksboro" ? jacksboro : path;
    if (path == "jacksboro" && !std::filesystem::exists(file))
        throw Error(ErrorCode::io, "heightmap jacksboro: " + file.string() + " is not there; install python-matplotlib-data");

    RawGrid raw = read_raw(file);
    HeightMap map{static_cast<std::uint32_t>(raw.width), static_cast<std::uint32_t>(raw.height), std::move(raw.values),
                  options.spacing_m.value_or(raw.spacing_east_m), options.spacing_m.value_or(raw.spacing_north_m)};
    if (map.spacing_east_m <= 0)
        throw Error(ErrorCode::invalid_argument, "spacing_m", "no value",
                    "metres between points, since " + file.string() + " does not say");
    for (std::size_t i = 0; i < map.meters.size(); ++i) {
        const double meters = map.meters[i] * options.meters_per_unit + options.offset_m;
        if (!(std::abs(meters) <= highest_m))
            throw Error(ErrorCode::invalid_argument,
                        file.string() + ": height at row " + std::to_string(i / raw.width) + ", column " +
                            std::to_string(i % raw.width),
                        print_number(meters) + " m", "finite, within 100 km of the ground");
        map.meters[i] = static_cast<float>(meters);
    }
    return map;
}

}  // namespace aureole::app
