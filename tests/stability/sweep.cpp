#include "stability/sweep.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace aureole::stability {
namespace {

using physics::degree;
using physics::pi;

/// A world of a hundred kilometres under thick haze that scatters forward.
AtmosphereParameters small_and_hazy() {
    AtmosphereParameters air = presets::hazy_earth();
    air.planet = {.bottom_radius_m = 100e3, .top_radius_m = 130e3, .ground_albedo = Rgb(0.6)};
    air.terms[0].profile = ExponentialProfile{4e3};
    air.terms[1].profile = ExponentialProfile{1e3};
    air.terms[1].phase = CornetteShanksPhase{0.9};
    air.terms[2].profile = TentProfile{10e3, 5e3};
    return air;
}

double green(const DensityTerm& term) { return term.scattering_per_m.g + term.absorption_per_m.g; }

void multiply(DensityTerm& term, double factor) {
    term.scattering_per_m *= factor;
    term.absorption_per_m *= factor;
}

DensityTerm& haze(Scene& scene) { return scene.air.terms[1]; }

void set_haze(Scene& s, double per_km) { multiply(haze(s), per_km * 1e-3 / green(haze(s))); }
void set_air(Scene& s, double per_km) {
    const double now = green(s.air.terms[0]) + green(s.air.terms[1]);
    for (DensityTerm& term : s.air.terms) multiply(term, per_km * 1e-3 / now);
}
void set_radius(Scene& s, double radius_m) {
    const double shell = std::min(s.shell_m(), 10 * radius_m);
    s.air.planet.bottom_radius_m = radius_m;
    s.air.planet.top_radius_m = radius_m + shell;
}
void set_shell(Scene& s, double shell_m) {
    const Planet& p = s.air.planet;
    s.air.planet.top_radius_m = std::min(p.bottom_radius_m + shell_m, 11 * p.bottom_radius_m);
}
void set_albedo(Scene& s, double albedo) {
    const Rgb whole = haze(s).scattering_per_m + haze(s).absorption_per_m;
    haze(s).scattering_per_m = albedo * whole;
    haze(s).absorption_per_m = (1 - albedo) * whole;
}

/// From `first` to `last`, `a_decade` values in each.
std::vector<double> decades(double first, double last, int a_decade, std::vector<double> more = {}) {
    const int count = static_cast<int>(std::lround(a_decade * std::log10(last / first)));
    for (int i = 0; i <= count; ++i) more.push_back(first * std::pow(10.0, static_cast<double>(i) / a_decade));
    std::ranges::sort(more);
    return more;
}

/// Of both bases' tops, with what is next to them.
std::vector<double> altitudes() {
    std::vector<double> all = {-10, 0, 2e4, 8e4, 9.9e4};
    for (const double top : {30e3, 100e3})
        for (const double off : {-1.0, -1e-3, 0.0, 1e-3, 1.0}) all.push_back(top + off);
    return decades(1e-3, 1e9, 1, all);
}

std::vector<Sweep> make_sweeps() {
    return {
        {"altitude", "m", altitudes(), [](Scene& s, double v) { s.altitude_m = v; }},
        {"sun elevation",
         "degrees",
         {-90,  -60, -30, -24, -18, -15, -12, -9, -6, -5, -4, -3, -2, -1,    -0.5,
          -0.1, 0,   0.1, 0.5, 1,   2,   5,   10, 20, 45, 60, 80, 89, 89.99, 90},
         [](Scene& s, double v) { s.sun_elevation_deg = v; }},
        {"radius", "m", decades(1e3, 1e9, 1, {6.36e6}), set_radius},
        {"shell", "m", decades(1, 1e7, 1, {2e5, 5e5, 6.36e7}), set_shell},
        {"scale height", "m", decades(1, 1e5, 1, {2e3, 8e3, 3e4}),
         [](Scene& s, double v) { s.air.terms[0].profile = ExponentialProfile{v}; }},
        {"extinction of haze", "1/km", decades(1e-12, 1e3, 1, {0, 30, 300}), set_haze},
        {"extinction of all air", "1/km", decades(1e-12, 1e3, 1, {0, 30, 300}), set_air},
        {"albedo of haze", "", {0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.99, 0.999999, 1}, set_albedo},
        {"albedo of ground", "", {0, 1e-6, 0.1, 0.5, 1}, [](Scene& s, double v) { s.air.planet.ground_albedo = Rgb(v); }},
        {"g of haze",
         "",
         {-0.999, -0.99, -0.9, -0.5, -1e-6, 0, 1e-6, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.999},
         [](Scene& s, double v) { haze(s).phase = CornetteShanksPhase{v}; }},
        {"sun radius",
         "degrees",
         {0, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.27, 1, 5, 15, 30, 45},
         [](Scene& s, double v) { s.sun_radius_deg = v, s.sun_disk = true; }},
        {"irradiance", "", decades(1e-6, 1e9, 1, {0, 1e20}), [](Scene& s, double v) { s.irradiance = v; }},
        {"suns", "", {1, 2, 3, 4}, [](Scene& s, double v) { s.suns = static_cast<std::uint32_t>(v); }},
        {"table size", "", {1, 2, 3}, [](Scene& s, double v) { s.finer = static_cast<std::uint32_t>(v); }},
    };
}

}  // namespace

std::vector<Sun> Scene::all_suns() const {
    std::vector<Sun> all;
    for (std::uint32_t i = 0; i < suns; ++i) {
        // The others stand at other hours and in other directions, and are dimmer.
        const double zenith = (90 - sun_elevation_deg + 25 * i) * degree, azimuth = 2.0 * i;
        Sun sun = physics::sun_at(0, std::min(sun_radius_deg * degree, pi / 4));
        sun.direction = physics::direction(zenith, azimuth);
        sun.irradiance = Rgb(irradiance / (1 + i));
        all.push_back(sun);
    }
    return all;
}

std::vector<glm::dvec3> Scene::views() const {
    const Planet& planet = air.planet;
    const double radius = planet.bottom_radius_m, h = std::max(altitude_m, 0.0), r = radius + h;
    const double horizon = pi / 2 + std::atan2(std::sqrt(h * (2 * radius + h)), radius);
    std::vector<double> zeniths = {0, 1e-3, 0.5, 1.0, 1.4, 1.55, pi / 2, 1.7, 2.3, pi - 1e-3, pi};
    constexpr double nearest = 1e-4;  // to an edge: a third of a pixel of 60 degrees in 3840
    for (const double off : {nearest, 1e-3, 1e-2, 0.1})
        zeniths.insert(zeniths.end(), {horizon - off, std::min(horizon + off, pi)});
    if (h > shell_m())  // through the shell, above the horizon
        for (const double share : {0.02, 0.1, 0.3, 0.7})
            zeniths.push_back(pi - std::asin(std::min((radius + share * shell_m()) / r, 1.0)));
    std::vector<glm::dvec3> all;
    for (const double zenith : zeniths)
        for (const double azimuth : {0.0, 0.7, pi / 2, pi}) all.push_back(physics::direction(zenith, azimuth));
    const double sun = (90 - sun_elevation_deg) * degree, disk = sun_radius_deg * degree;
    for (const double off : {1e-3, 3e-3, 0.02, 0.1, 0.3}) {
        all.push_back(physics::direction(sun + disk + off));
        all.push_back(physics::direction(sun - disk - off));
        all.push_back(physics::direction(sun + pi - off));
    }
    all.push_back(physics::direction(sun + pi));
    for (const double share : {0.0, 0.5, 0.9}) all.push_back(physics::direction(sun + share * disk));
    const double top = planet.top_radius_m, above = std::max(h - shell_m(), 0.0);
    const double limb = pi / 2 + std::atan2(std::sqrt(above * (2 * top + above)), top);
    std::erase_if(all, [&](const glm::dvec3& view) {
        const double zenith = std::atan2(std::hypot(view.x, view.y), view.z);
        return std::abs(zenith - horizon) < 0.99 * nearest || (above > 0 && std::abs(zenith - limb) < 0.99 * nearest) ||
               (disk > nearest &&
                std::abs(glm::distance(view, physics::direction(sun)) - 2 * std::sin(disk / 2)) < 0.99 * nearest);
    });
    return all;
}

std::span<const Base> bases() {
    static const std::array all{Base{"earth", presets::earth()}, Base{"small and hazy", small_and_hazy()}};
    return all;
}

std::span<const Sweep> sweeps() {
    static const std::vector<Sweep> all = make_sweeps();
    return all;
}

const Sweep& sweep(std::string_view name) {
    for (const Sweep& one : sweeps())
        if (name == one.name) return one;
    throw std::invalid_argument("no axis " + std::string(name));
}

std::vector<Scene> Sweep::scenes(const Base& base, double value) const {
    std::vector<Scene> all;
    const auto add = [&](double share_of_shell, double elevation_deg) {
        Scene scene;
        scene.air = base.air;
        scene.sun_elevation_deg = elevation_deg;
        set(scene, value);
        // Places are shares of the shell as it has become.
        if (std::string_view(name) != "altitude" && share_of_shell > 0) scene.altitude_m = share_of_shell * scene.shell_m();
        all.push_back(scene);
    };
    const bool hours = std::string_view(name) != "sun elevation", places = std::string_view(name) != "altitude";
    for (const double share : places ? std::vector{0.0, 0.1, 4.0} : std::vector{0.0})
        for (const double elevation : hours ? std::vector{50.0, 3.0, -4.0} : std::vector{0.0}) add(share, elevation);
    return all;
}

namespace {

/// Every other row of the picture; the others are a dull grey.
bool is_black(std::size_t pixel) { return pixel / physics::Picture::width % 2 == 0; }

/// To where a line meets a sphere about the planet's centre from outside, or infinity: at a distance, by the cosine there.
double distance_to_sphere(double radius, double r, double mu) {
    const double b = r * mu, c = (r - radius) * (r + radius), discriminant = b * b - c;
    if (b >= 0 || discriminant < 0) return std::numeric_limits<double>::infinity();
    return c / (std::sqrt(discriminant) - b);
}

/// From the camera, no farther than the ground; seen from beyond the air, so far before the ground, or before the lowest point
/// of a line that misses it, but with ten metres of air at least.
double distance_of(const Scene& scene, const glm::dvec3& direction, double in_air_m) {
    const Planet& planet = scene.air.planet;
    const double r = planet.bottom_radius_m + scene.altitude_m;
    const double ground = scene.altitude_m > 0 ? distance_to_sphere(planet.bottom_radius_m, r, direction.z)
                                               : std::numeric_limits<double>::infinity();
    if (r <= planet.top_radius_m) return std::min(in_air_m, ground);
    const double entry = distance_to_sphere(planet.top_radius_m, r, direction.z);
    if (!std::isfinite(entry)) return scene.altitude_m + in_air_m;  // no air there
    const double farthest = std::min(ground, -r * direction.z);
    return std::max(farthest - in_air_m, std::min(entry + 10, farthest));
}

/// Of a float of a distance in kilometres, in which kernels work.
double step_of_distance(double distance_m) { return 1e3 * std::ldexp(1.0, std::ilogb(1e-3 * distance_m) - 23); }
constexpr double step_of_direction = static_cast<double>(std::numeric_limits<float>::epsilon());

/// Horizon and ground in one picture, or the whole planet where it is small.
Camera camera_of(const Scene& scene, double tilt_rad) {
    const double radius = scene.air.planet.bottom_radius_m, h = std::max(scene.altitude_m, 0.0);
    const double from_nadir = std::atan2(radius, std::sqrt(h * (2 * radius + h)));  // of the horizon
    const double fov = std::min(60 * degree, 2.2 * from_nadir);
    return look(radius, scene.altitude_m, 0.7, std::max(from_nadir - fov / 4, 0.0) - pi / 2 + tilt_rad, fov,
                static_cast<double>(physics::Picture::width) / physics::Picture::height, 1e-2);
}

}  // namespace

std::vector<Rgb> Observer::geometry(const Scene& scene, int farther, int tilted) {
    if (!picture_ || scene.suns != suns_of_picture_) {
        suns_of_picture_ = scene.suns;
        picture_.reset();
        picture_ = std::make_unique<physics::Picture>(machine_, scene.air, model_, 96e3, scene.suns);
    } else {
        picture_->air().set_parameters(scene.air);
    }
    picture_->place(camera_of(scene, 0), scene.all_suns());
    distances_.clear();
    std::vector<Rgb> colors;
    for (std::uint32_t y = 0; y < physics::Picture::height; ++y)
        for (std::uint32_t x = 0; x < physics::Picture::width; ++x) {
            constexpr double in_air_m[] = {10, 300, 5e3, 5e4};
            const double distance = distance_of(scene, picture_->direction(x, y), in_air_m[x % 4]);
            distances_.push_back(distance + farther * step_of_distance(distance));
            colors.push_back(is_black(colors.size()) ? Rgb(0) : Rgb(0.05 * scene.irradiance));
        }
    if (tilted != 0) picture_->place(camera_of(scene, tilted * step_of_direction), scene.all_suns());
    return picture_->render(distances_, colors);
}

std::vector<Rgb> Observer::sky(const Scene& scene) {
    if (!sky_ || scene.suns != suns_ || scene.sun_disk != sun_disk_) {
        physics::SkyOptions options;
        options.model = model_;
        options.suns = suns_ = scene.suns;
        options.sun_disk = sun_disk_ = scene.sun_disk;
        sky_.reset();
        sky_ = std::make_unique<physics::Sky>(machine_, scene.air, options);
    } else {
        sky_->air().set_parameters(scene.air);
    }
    sky_->place({0, 0, scene.air.planet.bottom_radius_m + scene.altitude_m}, scene.all_suns());
    return sky_->radiance(scene.views());
}

namespace {

/// What the sun's beam gives level ground of reflectance 1, 1/sr, through the air above it.
Rgb beam_on_ground(const Scene& scene) {
    const double sine = std::sin(scene.sun_elevation_deg * degree);
    if (sine <= 0) return Rgb(0);
    return scene.irradiance * sine / pi * glm::exp(-vertical_optical_depth(scene.air) / sine);
}

Rgb mean_away_from_suns(const Scene& scene, std::span<const Rgb> sky) {
    const std::vector<glm::dvec3> views = scene.views();
    Rgb sum(0);
    double count = 0;
    for (std::size_t i = 0; i < sky.size(); ++i) {
        bool near_sun = false;
        for (const Sun& sun : scene.all_suns())
            near_sun = near_sun || glm::dot(views[i], sun.direction) > std::cos(10 * degree + sun.angular_radius_rad);
        if (!near_sun) sum += sky[i], ++count;
    }
    return sum / std::max(count, 1.0);
}

void widen(Exact& exact, std::span<const Rgb> other) {
    for (std::size_t i = 0; i < other.size(); ++i) {
        exact.least[i] = glm::min(exact.least[i], other[i]);
        exact.most[i] = glm::max(exact.most[i], other[i]);
    }
}

}  // namespace

Exact exact_look(Observer& in_double, const Scene& scene, Subject subject, bool half_tables) {
    const std::vector<Rgb> sky = in_double.look(scene);
    const Rgb mean = mean_away_from_suns(scene, sky);
    const double steps = half_tables ? 100 * 6e-8 : 0;
    Exact exact{sky, sky, sky, Rgb(1e-3 * physics::sum(mean) / 3), std::max((1e-12 + steps) * scene.irradiance, 1e-300), {}};
    if (subject == Subject::geometry) {
        exact.here = exact.least = exact.most = in_double.look(scene, subject);
        for (std::size_t i = 0; i < exact.here.size(); ++i)
            if (is_black(i) && in_double.distances_m()[i] >= 1) exact.black.push_back(i);
        for (const int one : {-1, 1}) {
            widen(exact, in_double.geometry(scene, 2 * one));
            widen(exact, in_double.geometry(scene, 0, one));
        }
        exact.least_light = 0.04 * (mean + beam_on_ground(scene));
    }
    exact.least_light = glm::max(exact.least_light, Rgb(exact.faintest));
    return exact;
}

namespace {

double relative_error(const Rgb& seen, const Exact& exact, std::size_t i, const Rgb& least_light) {
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::max(seen[c] - exact.most[i][c], exact.least[i][c] - seen[c]) /
                                    std::max(exact.here[i][c], least_light[c]));
    return worst;
}

}  // namespace

std::vector<double> relative_errors(std::span<const Rgb> seen, const Exact& exact) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < seen.size(); ++i) errors.push_back(relative_error(seen[i], exact, i, exact.least_light));
    return errors;
}

std::vector<double> errors_of_black(std::span<const Rgb> seen, const Exact& exact) {
    std::vector<double> errors;
    for (const std::size_t i : exact.black) errors.push_back(relative_error(seen[i], exact, i, Rgb(exact.faintest)));
    return errors;
}

}  // namespace aureole::stability
