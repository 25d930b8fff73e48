#include "scene/write_scene.h"

#include "io/csv.h"
#include "io/file.h"

#include <cmath>
#include <numbers>
#include <set>
#include <span>

namespace aureole::app {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

/// A TOML string: quotes, backslashes and control characters are escaped.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            result.append("\\").push_back(c);
        else if (code < 0x20 || code == 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04X", code);
            result += escape;
        } else
            result.push_back(c);
    }
    return result + '"';
}

std::string list(std::span<const double> values) {
    std::string text;
    for (const double value : values) text.append(text.empty() ? "[" : ", ").append(print_number(value));
    return text + "]";
}

std::string colour(const Rgb& c) { return c.r == c.g && c.g == c.b ? print_number(c.r) : list(std::array{c.r, c.g, c.b}); }

/// The degrees that are read back as this angle: dividing by what the reader multiplies with may miss them by a bit or two.
double degrees_of(double radians) {
    double candidate = radians / radians_per_degree;
    for (int i = 0; i < 4; ++i) candidate = std::nextafter(candidate, 0);
    for (int i = 0; i < 9; ++i, candidate = std::nextafter(candidate, 1e9))
        if (candidate * radians_per_degree == radians) return candidate;
    return radians / radians_per_degree;
}

class Writer {
public:
    void key(const char* name, const std::string& value) { text_.append(name).append(" = ").append(value).append("\n"); }
    void number(const char* name, double value) { key(name, print_number(value)); }
    void header(const char* name) { text_.append("\n").append(name).append("\n"); }
    std::string text_;
};

std::string print(const Profile& profile) {
    if (const auto* p = std::get_if<ExponentialProfile>(&profile))
        return "{ kind = \"exponential\", scale_height_m = " + print_number(p->scale_height_m) + " }";
    if (const auto* p = std::get_if<TentProfile>(&profile))
        return "{ kind = \"tent\", center_m = " + print_number(p->center_m) +
               ", half_width_m = " + print_number(p->half_width_m) + " }";
    const auto& p = std::get<TabulatedProfile>(profile);
    return "{ kind = \"tabulated\", altitude_m = " + list(p.altitude_m) + ", density = " + list(p.density) + " }";
}

std::string print(const PhaseFunction& phase) {
    if (std::holds_alternative<RayleighPhase>(phase)) return "{ kind = \"rayleigh\" }";
    if (const auto* p = std::get_if<HenyeyGreensteinPhase>(&phase))
        return "{ kind = \"henyey_greenstein\", g = " + print_number(p->g) + " }";
    if (const auto* p = std::get_if<CornetteShanksPhase>(&phase))
        return "{ kind = \"cornette_shanks\", g = " + print_number(p->g) + " }";
    if (const auto* p = std::get_if<HenyeyGreensteinDrainePhase>(&phase))
        return "{ kind = \"henyey_greenstein_draine\", g_hg = " + print_number(p->g_hg) +
               ", g_draine = " + print_number(p->g_draine) + ", alpha = " + print_number(p->alpha) +
               ", weight = " + print_number(p->weight) + " }";
    const auto& p = std::get<TabulatedPhase>(phase);
    std::vector<double> degrees;
    for (const double angle : p.angle_rad) degrees.push_back(degrees_of(angle));
    if (!degrees.empty()) {  // within 1e-6 of 0 and pi is allowed; the reader takes 0 and 180 alone
        degrees.front() = 0;
        degrees.back() = 180;
    }
    return "{ kind = \"tabulated\", angle_deg = " + list(degrees) + ", value = " + list(p.value) + " }";
}

void print_picture(Writer& out, const Scene& scene) {
    out.key("title", quoted(scene.title));
    out.key("size", "[" + std::to_string(scene.width) + ", " + std::to_string(scene.height) + "]");
    out.key("exposure", scene.exposure.factor ? print_number(*scene.exposure.factor) : "\"auto\"");
    out.number("exposure_stops", scene.exposure.stops);
    out.key("tone_map", scene.tone_map == ToneMap::none ? "\"none\"" : "\"aces_fitted\"");
    out.key("sun_disk", scene.sun_disk ? "true" : "false");
    out.number("sun_lobe_g", scene.sun_lobe_g);
    out.key("model", quoted(scene.model.name));
    out.key("quality", quoted(scene.model.quality));
    out.key("spectral", scene.model.in_rgb() ? "\"rgb\"" : scene.model.spectral);
    out.number("aerial_perspective_distance_m", scene.aerial_perspective_distance_m);
}

void print_air(Writer& out, const AtmosphereParameters& air) {
    out.header("[atmosphere]");
    out.key("preset", "\"none\"");
    out.number("bottom_radius_m", air.planet.bottom_radius_m);
    out.number("top_radius_m", air.planet.top_radius_m);
    out.key("ground_albedo", colour(air.planet.ground_albedo));
    std::set<std::string> names;
    for (const DensityTerm& term : air.terms) {
        if (!names.insert(term.name).second)
            throw Error(ErrorCode::invalid_argument, "atmosphere.term.name", quoted(term.name) + " twice",
                        "a name of its own for each term of a scene file");
        out.header("[[atmosphere.term]]");
        out.key("name", quoted(term.name));
        out.key("scattering_per_m", colour(term.scattering_per_m));
        out.key("absorption_per_m", colour(term.absorption_per_m));
        out.number("scattering_scale", term.scattering_scale);
        out.number("absorption_scale", term.absorption_scale);
        out.key("profile", print(term.profile));
        out.key("phase", print(term.phase));
    }
}

void print_suns(Writer& out, const std::vector<SceneSun>& suns) {
    if (suns.size() > 4) throw Error(ErrorCode::invalid_argument, "sun", std::to_string(suns.size()) + " suns", "at most 4");
    for (const SceneSun& sun : suns) {
        out.header("[[sun]]");
        out.number("elevation_deg", sun.pose.elevation_deg);
        out.number("bearing_deg", sun.pose.bearing_deg);
        out.key("irradiance", sun.irradiance ? colour(*sun.irradiance) : "\"sun\"");
        out.number("angular_radius_deg", sun.angular_radius_deg);
        out.key("limb_darkening", sun.limb_darkening == LimbDarkening::none ? "\"none\"" : "\"neckel94\"");
    }
}

void print_camera(Writer& out, const SceneCamera& camera) {
    out.header("[camera]");
    if (camera.clearance_m)
        out.number("clearance_m", *camera.clearance_m);
    else
        out.number("altitude_m", camera.altitude_m);
    out.number("bearing_deg", camera.pose.bearing_deg);
    out.number("elevation_deg", camera.pose.elevation_deg);
    out.number("vertical_fov_deg", camera.vertical_fov_deg);
    const bool fisheye = camera.projection == Projection::fisheye;
    out.key("projection", camera.projection == Projection::matrix ? "\"perspective\""
                          : fisheye                               ? "\"fisheye\""
                                                                  : "\"panorama\"");
}

std::string name_of_map(const std::filesystem::path& map, const std::filesystem::path& folder) {
    if (map == "jacksboro") return quoted(map.string());
    return quoted(absolute(map).lexically_normal().lexically_proximate(absolute(folder).lexically_normal()).string());
}

void print_terrain(Writer& out, const SceneTerrain& terrain, const std::filesystem::path& folder) {
    out.header("[terrain]");
    out.key("heightmap", name_of_map(terrain.height_map, folder));
    if (terrain.options.spacing_m) out.number("spacing_m", *terrain.options.spacing_m);
    out.number("meters_per_unit", terrain.options.meters_per_unit);
    out.number("offset_m", terrain.options.offset_m);
    out.number("vertical_exaggeration", terrain.vertical_exaggeration);
    out.number("camera_east_m", terrain.camera_east_m);
    out.number("camera_north_m", terrain.camera_north_m);
    out.number("range_m", terrain.range_m);
    out.number("air_shadows_m", terrain.air_shadows_m);
    out.number("air_shadow_samples", terrain.air_shadow_samples);
    if (terrain.albedo) out.key("albedo", colour(*terrain.albedo));
}

}  // namespace

std::string print_scene(const Scene& scene, const std::filesystem::path& folder) {
    Writer out;
    print_picture(out, scene);
    print_air(out, scene.atmosphere);
    print_suns(out, scene.suns);
    print_camera(out, scene.camera);
    if (scene.terrain) print_terrain(out, *scene.terrain, folder.empty() ? "." : folder);
    return out.text_;
}

void write_scene(const std::filesystem::path& path, const Scene& scene) {
    write_text(path, print_scene(scene, path.parent_path()));
}

}  // namespace aureole::app
