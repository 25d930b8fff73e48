#include "stability/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

namespace aureole::stability {
namespace {

constexpr double pi = std::numbers::pi;

/// Steele, Lea & Flood 2014.
std::uint64_t splitmix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}
double unit(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

double logarithmic(double low, double high, double u) { return std::min(low * std::pow(high / low, u), high); }

// ---- Corners. Some are numbers as they stand, others say what the accessor makes of them. ----

constexpr std::array radii{1e3, 6.36e6, 1e9, 1e12};
enum Shell { thinnest, hundred_km, as_radius, thickest, shells };
constexpr std::array term_counts{0.0, 1.0, 2.0, 4.0, 20.0};
enum Kind { exponential, tent, tabulated, kinds };
enum Height { least_height, a_metre, whole_shell, beyond_shell, heights };
constexpr std::array extinctions_per_m{0.0, 1e-15, 1e-5, 1.0, 1e6};
constexpr std::array zero_one{0.0, 1.0};
constexpr std::size_t phase_kinds = 5;
constexpr std::array gs{-0.999, 0.0, 0.999};
enum Altitude { deep, ground, millimetre, centimetre, metre, middle, under_top, top, over_top, orbit, far_away, altitudes };
enum Place { north, south, east, slanted, places };
// Zenith angles: of sun and view. From `sunward` on: of the view alone.
enum Zenith { up, down, level, horizon, over_horizon, under_horizon, zeniths, sunward = zeniths, anti_sun, limb, views };
constexpr std::array azimuths{0.0, pi, pi / 2};
constexpr std::array sun_radii{0.0, 1e-12, 0.004675, pi / 4};
constexpr std::array irradiances{0.0, 1e-6, 1.0, 1e9, 1e20};
constexpr std::array sun_counts{0.0, 1.0, 4.0};

std::size_t corners(Axis axis) {
    switch (axis) {
        case Axis::radius:
            return radii.size();
        case Axis::shell:
            return shells;
        case Axis::terms:
            return term_counts.size();
        case Axis::profile:
            return kinds;
        case Axis::scale_height:
            return heights;
        case Axis::extinction:
            return extinctions_per_m.size();
        case Axis::albedo:
        case Axis::ground_albedo:
        case Axis::distance:
            return zero_one.size();
        case Axis::phase:
            return phase_kinds;
        case Axis::g:
            return gs.size();
        case Axis::altitude:
            return altitudes;
        case Axis::place:
            return places;
        case Axis::sun_zenith:
            return zeniths;
        case Axis::sun_azimuth:
            return azimuths.size();
        case Axis::sun_radius:
            return sun_radii.size();
        case Axis::irradiance:
            return irradiances.size();
        case Axis::suns:
            return sun_counts.size();
        case Axis::view:
            return views;
        case Axis::count:
            break;
    }
    return 0;
}

struct Pair {
    Axis a, b;
    std::size_t corner_a, corner_b;
};
std::vector<Pair> all_pairs() {
    std::vector<Pair> pairs;
    for (int a = 0; a < static_cast<int>(Axis::count); ++a)
        for (int b = a + 1; b < static_cast<int>(Axis::count); ++b)
            for (std::size_t i = 0; i < corners(static_cast<Axis>(a)); ++i)
                for (std::size_t j = 0; j < corners(static_cast<Axis>(b)); ++j)
                    pairs.push_back({static_cast<Axis>(a), static_cast<Axis>(b), i, j});
    return pairs;
}
const std::vector<Pair>& pairs() {
    static const std::vector<Pair> all = all_pairs();
    return all;
}

std::uint64_t number_of(const char* name, std::uint64_t fallback) {
    const char* text = std::getenv(name);
    return text == nullptr ? fallback : std::strtoull(text, nullptr, 10);
}

}  // namespace

Range cases(std::uint64_t quick) {
    if (std::getenv("AUREOLE_STABILITY_CASE") != nullptr) {
        const std::uint64_t one = number_of("AUREOLE_STABILITY_CASE", 0);
        return {one, one + 1};
    }
#ifdef __SANITIZE_ADDRESS__
    quick /= 6;  // each takes as many times as long
#endif
    return {0, number_of("AUREOLE_STABILITY_CASES", quick)};
}

std::uint64_t Case::pair_cases() { return pairs().size(); }

Case::Case(std::uint64_t index) : index_(index) {
    if (index >= pair_cases()) return;
    // Scattered over the list, so that the first thousand cases are about all axes.
    const Pair& pair = pairs()[(index * 7919) % pair_cases()];
    pinned_[0] = pair.a, pinned_[1] = pair.b;
    corner_[0] = pair.corner_a, corner_[1] = pair.corner_b;
}

double Case::random(std::uint64_t use) const { return unit(splitmix(splitmix(index_) ^ (use * 0xd1342543de82ef95))); }

Case::Draw Case::draw(Axis axis, std::uint64_t copy) const {
    const std::uint64_t use = 1000 + 64 * copy + static_cast<std::uint64_t>(axis);
    Draw d{std::nullopt, random(use)};
    if (copy == 0)
        for (int i = 0; i < 2; ++i)
            if (pinned_[i] == axis) return {corner_[i], d.u, true};
    const double choice = random(use + 100000);
    if (choice < 1.0 / 3) d.corner = static_cast<std::size_t>(3 * choice * static_cast<double>(corners(axis)));
    return d;
}

double Case::bottom_radius_m() const {
    const Draw d = draw(Axis::radius);
    return d.corner ? radii.at(*d.corner) : logarithmic(1e3, 1e9, d.u);
}

double Case::shell_m() const {
    const double radius = bottom_radius_m(), most = 10 * radius;
    const Draw d = draw(Axis::shell);
    const double named[shells] = {1, 100e3, radius, most};
    const double wanted = d.corner ? named[*d.corner] : logarithmic(1, most, d.u);
    return std::clamp(wanted, 1.0, most);
}

Planet Case::planet() const {
    Planet planet;
    planet.bottom_radius_m = bottom_radius_m();
    planet.top_radius_m =
        std::clamp(planet.bottom_radius_m + shell_m(), planet.bottom_radius_m + 1, 11 * planet.bottom_radius_m);
    const Draw d = draw(Axis::ground_albedo);
    planet.ground_albedo = d.corner ? Rgb(zero_one.at(*d.corner)) : Rgb(d.u, random(1), random(2));
    return planet;
}

Profile Case::profile(std::uint64_t term) const {
    const Draw kind = draw(Axis::profile, term), height = draw(Axis::scale_height, term);
    const double shell = shell_m();
    const double named[heights] = {0.01, 1, std::min(shell, 1e12), 1e12};
    const double length = height.corner ? named[*height.corner] : logarithmic(1, std::clamp(shell, 2.0, 1e12), height.u);
    // Tables are rare unless asked for: they take a thousand times as long to pack.
    const Kind random_kind = kind.u < 0.65 ? exponential : kind.u < 0.995 ? tent : tabulated;
    const auto which = kind.pinned ? *kind.corner : std::size_t{random_kind};
    if (which == exponential) return ExponentialProfile{length};
    const double centre = std::min(shell, 1e12) * random(10 + term);
    if (which == tent) return TentProfile{centre, length};
    return TabulatedProfile{{0, 0.25 * length, 0.5 * length, (0.51 + 0.4 * random(60 + term)) * length},
                            {1, random(30 + term), 1e6 * random(50 + term), 0}};
}

PhaseFunction Case::phase(std::uint64_t term) const {
    const Draw kind = draw(Axis::phase, term), d = draw(Axis::g, term);
    const double g = d.corner ? gs.at(*d.corner) : 0.999 * (2 * d.u - 1);
    const auto which = kind.pinned ? *kind.corner : kind.u < 0.995 ? static_cast<std::size_t>(kind.u * 4.02) : 4;
    if (which == 0) return RayleighPhase{};
    if (which == 1) return HenyeyGreensteinPhase{g};
    if (which == 2) return CornetteShanksPhase{g};
    if (which == 3)
        return HenyeyGreensteinDrainePhase{.g_hg = g,
                                           .g_draine = 0.999 * (2 * random(70 + term) - 1),
                                           .alpha = random(80 + term) < 0.2 ? 0 : logarithmic(1e-6, 1e4, random(90 + term)),
                                           .weight = std::round(4 * random(100 + term)) / 4};
    return TabulatedPhase{{0, 1e-3, 1, pi}, {random(110 + term), 1 + 1e6 * random(120 + term), 0, random(130 + term)}};
}

DensityTerm Case::term(std::uint64_t i) const {
    const Draw extinction = draw(Axis::extinction, i), albedo = draw(Axis::albedo, i);
    const double whole = extinction.corner ? extinctions_per_m.at(*extinction.corner) : logarithmic(1e-15, 1, extinction.u);
    DensityTerm term;
    term.name = "term " + std::to_string(i);
    term.profile = profile(i);
    for (int c = 0; c < 3; ++c) {
        const double share = albedo.corner ? zero_one.at(*albedo.corner) : random(200 + 3 * i + static_cast<std::uint64_t>(c));
        const double here = whole * (c == 0 ? 1 : random(300 + 3 * i + static_cast<std::uint64_t>(c)));
        term.scattering_per_m[c] = share * here;
        term.absorption_per_m[c] = (1 - share) * here;
    }
    term.phase = phase(i % AtmosphereParameters::max_phase_functions);
    return term;
}

AtmosphereParameters Case::air() const {
    AtmosphereParameters air;
    air.planet = planet();
    const Draw d = draw(Axis::terms);
    double count = d.corner ? term_counts.at(*d.corner) : 1 + std::floor(3 * d.u);
    if (count > 16 && !d.pinned) count = 3;  // more than kernels take become tables
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) air.terms.push_back(term(i));
    return air;
}

double Case::altitude_m() const {
    const Draw d = draw(Axis::altitude);
    const double shell = planet().top_radius_m - planet().bottom_radius_m;
    const double named[altitudes] = {
        -10, 0, 1e-3, 1e-2, 1, 0.5 * shell, shell - 1e-3, shell, shell + 1e-3, shell + 0.06 * bottom_radius_m(), 1e9};
    const double farthest = 0.999e13 - bottom_radius_m();
    return std::min(d.corner ? named[*d.corner] : logarithmic(1e-6, 4 * shell, d.u), farthest);
}

double Case::altitude_in_air_m() const {
    return std::clamp(altitude_m(), 0.0, planet().top_radius_m - planet().bottom_radius_m);
}

double Case::dip() const {
    const double radius = bottom_radius_m(), h = std::max(altitude_m(), 0.0);
    return std::atan2(std::sqrt(h * (2 * radius + h)), radius);
}

double Case::zenith(std::span<const double> special, const Draw& d) const {
    const double at_horizon = pi / 2 + dip();
    const double named[zeniths] = {0, pi, pi / 2, at_horizon, at_horizon - 1e-7, at_horizon + 1e-7};
    if (d.corner && *d.corner < zeniths) return std::min(named[*d.corner], pi);
    if (d.corner) return special[*d.corner - zeniths];
    // Even over the sphere; or at the horizon, by decades of angle.
    if (d.u < 0.5) return std::acos(1 - 4 * d.u);
    const double off = logarithmic(1e-9, 1, std::abs(4 * d.u - 3));
    return std::clamp(at_horizon + (d.u < 0.75 ? -off : off), 0.0, pi);
}

double Case::sun_zenith() const { return zenith({}, draw(Axis::sun_zenith)); }

double Case::view_zenith() const {
    const double shell = planet().top_radius_m - planet().bottom_radius_m, above = std::max(altitude_m() - shell, 0.0);
    const double top = planet().top_radius_m;
    const double special[views - zeniths] = {sun_zenith(), pi - sun_zenith(),
                                             pi / 2 + std::atan2(std::sqrt(above * (2 * top + above)), top)};
    return zenith(special, draw(Axis::view));
}

double Case::sun_azimuth() const {
    const Draw view = draw(Axis::view);
    if (view.corner == std::size_t{sunward}) return 0;
    if (view.corner == std::size_t{anti_sun}) return pi;
    const Draw d = draw(Axis::sun_azimuth);
    return d.corner ? azimuths.at(*d.corner) : pi * (2 * d.u - 1);
}

double Case::distance_share() const {
    const Draw d = draw(Axis::distance);
    return d.corner ? zero_one.at(*d.corner) : logarithmic(1e-6, 1, d.u);
}

glm::dvec3 Case::world(double zenith, double azimuth) const {
    const Draw d = draw(Axis::place);
    const glm::dvec3 named[places] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1, 2, 3}};
    const double z = 2 * d.u - 1, angle = 2 * pi * random(3), across = std::sqrt(std::max(1 - z * z, 0.0));
    const glm::dvec3 up_here =
        glm::normalize(d.corner ? named[*d.corner] : glm::dvec3(across * std::cos(angle), across * std::sin(angle), z));
    const glm::dvec3 ahead =
        glm::normalize(glm::cross(std::abs(up_here.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), up_here));
    return std::sin(zenith) * (std::cos(azimuth) * ahead + std::sin(azimuth) * glm::cross(up_here, ahead)) +
           std::cos(zenith) * up_here;
}

Camera Case::camera() const {
    Camera camera;
    const glm::dvec3 above = world(0, 0), ahead = world(pi / 2, 0), right = world(pi / 2, -pi / 2);
    camera.position_m = (bottom_radius_m() + altitude_m()) * above;
    camera.view = glm::dmat4(glm::transpose(glm::dmat3(right, above, -ahead)));
    camera.kind = Projection::panorama;
    return camera;
}

std::vector<Sun> Case::suns() const {
    const Draw d = draw(Axis::suns);
    const auto count = static_cast<std::uint64_t>(d.corner ? sun_counts.at(*d.corner) : 1 + std::floor(2 * d.u));
    std::vector<Sun> suns(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Draw radius = draw(Axis::sun_radius, i), irradiance = draw(Axis::irradiance, i);
        suns[i].direction = i == 0 ? world(sun_zenith(), sun_azimuth()) : world(pi * random(400 + i), 6 * random(410 + i));
        suns[i].angular_radius_rad = radius.corner ? sun_radii.at(*radius.corner) : logarithmic(1e-6, pi / 4, radius.u);
        const double light = irradiance.corner ? irradiances.at(*irradiance.corner) : logarithmic(1e-6, 1e9, irradiance.u);
        suns[i].irradiance = {light, light * random(420 + i), light * random(430 + i)};
        suns[i].limb_darkening = random(440 + i) < 0.5 ? LimbDarkening::none : LimbDarkening::neckel94;
    }
    return suns;
}

double finest_m(const Case& c) {
    double least = std::min(c.planet().top_radius_m - c.planet().bottom_radius_m, c.bottom_radius_m());
    for (const DensityTerm& term : c.air().terms) {
        if (const auto* layer = std::get_if<ExponentialProfile>(&term.profile)) least = std::min(least, layer->scale_height_m);
        if (const auto* layer = std::get_if<TentProfile>(&term.profile)) least = std::min(least, layer->half_width_m);
        if (const auto* layer = std::get_if<TabulatedProfile>(&term.profile))
            least = std::min(least, layer->altitude_m[1] / 1e6);
    }
    return least;
}

std::string Case::text() const {
    std::ostringstream text;
    text.precision(17);
    text << "case " << index_ << ": radius " << bottom_radius_m() << " m, shell "
         << planet().top_radius_m - planet().bottom_radius_m << " m, altitude " << altitude_m() << " m, view zenith "
         << view_zenith() << ", sun zenith " << sun_zenith() << ", azimuth " << sun_azimuth();
    return text.str();
}

}  // namespace aureole::stability
