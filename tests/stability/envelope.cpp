// How far each model in float is from itself in double, along every axis: a line of CSV for each model, backend, storage and
// value. docs/stability.md shows what came out; AUREOLE_STABILITY_PRINT=1 tells where each of the errors is.
#include "stability/search.h"
#include "stability/sweep.h"

#ifdef AUREOLE_TESTS_HAVE_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

using namespace aureole;
using namespace aureole::stability;

namespace {

struct Backend {
    const char* name;
    physics::Machine* machine;
};

#ifdef AUREOLE_TESTS_HAVE_VULKAN
class VulkanMachine final : public physics::Machine {
public:
    VulkanMachine() : device_(vulkan::create_vulkan_device({})) { listen(); }
    rhi::Device& device() override { return device_->device(); }
    rhi::Queue& queue() override { return device_->queue(); }

private:
    std::unique_ptr<vulkan::VulkanDevice> device_;
};
#endif

/// The CPU in float; and Vulkan, where it is.
std::vector<Backend> backends([[maybe_unused]] bool with_vulkan) {
    std::vector<Backend> all = {{"cpu", &physics::cpu_float()}};
#ifdef AUREOLE_TESTS_HAVE_VULKAN
    if (!with_vulkan) return all;
    try {
        static VulkanMachine vulkan;
        all.push_back({"vulkan", &vulkan});
    } catch (const Error& error) {
        std::fprintf(stderr, "without Vulkan: %s\n", error.what());
    }
#endif
    return all;
}

struct Stored {
    const char* name;
    bool half;
    std::vector<Rung> (*rungs)(std::uint32_t finer);
};
constexpr Stored storages[] = {
    {"none", false, [](std::uint32_t) { return bare_rungs(); }},
    {"float", false, [](std::uint32_t finer) { return stored_rungs(rhi::Format::rgba32_float, finer); }},
    {"half", true, [](std::uint32_t finer) { return stored_rungs(rhi::Format::rgba16_float, finer); }},
};

/// What a line is about.
struct Line {
    const char* model;
    const Stored& stored;
    const Base& base;
    const Sweep& axis;
    double value;
    const char* subject;
};

bool is_told() { return std::getenv("AUREOLE_STABILITY_PRINT") != nullptr; }

void print(const Line& line, const Backend& backend, std::vector<double> errors) {
    std::ranges::sort(errors);
    const double p95 = errors[static_cast<std::size_t>(0.95 * static_cast<double>(errors.size() - 1))];
    std::printf("\"%s\",%s,%s,%s,%s,%s,%.10g,%.3g,%.3g\n", line.model, backend.name, line.stored.name, line.subject,
                line.base.name, line.axis.name, line.value, p95, errors.back());
    std::fflush(stdout);
    if (is_told())
        std::fprintf(stderr, "%s, %s, %s, %s, %s: %s %g: %.3g\n", line.model, backend.name, line.stored.name, line.subject,
                     line.base.name, line.axis.name, line.value, errors.back());
}

std::size_t worst_of(std::span<const double> errors) {
    return static_cast<std::size_t>(std::ranges::max_element(errors) - errors.begin());
}

std::string place_of(const Scene& scene, Subject subject, std::size_t i) {
    std::ostringstream text;
    text.precision(7);
    const glm::dvec3 view = subject == Subject::sky ? scene.views()[i] : glm::dvec3();
    if (subject == Subject::sky)
        text << "view at zenith angle " << std::acos(view.z) << ", azimuth " << std::atan2(view.y, view.x);
    else
        text << "pixel " << i % physics::Picture::width << ", " << i / physics::Picture::width;
    return text.str();
}

void tell(const char* subject, const Scene& scene, const std::string& place, double error, const Rgb& seen, const Rgb& exact) {
    std::fprintf(stderr, "  %s, %.3g: altitude %.10g m, sun at %g degrees, %s: (%.6g %.6g %.6g), exact (%.6g %.6g %.6g)\n",
                 subject, error, scene.altitude_m, scene.sun_elevation_deg, place.c_str(), seen.r, seen.g, seen.b, exact.r,
                 exact.g, exact.b);
}

/// Infinite where there is a number that is none.
struct Errors {
    std::vector<double> picture, black;
    void add(const Errors& more) {
        std::ranges::copy(more.picture, std::back_inserter(picture));
        std::ranges::copy(more.black, std::back_inserter(black));
    }
};

Errors compare(Observer& observer, Observer& exact, const Scene& scene, Subject subject, bool half) {
    const Exact right = exact_look(exact, scene, subject, half);
    const bool with_black = subject == Subject::geometry;
    try {
        const std::vector<Rgb> seen = observer.look(scene, subject);
        Errors errors{relative_errors(seen, right), with_black ? errors_of_black(seen, right) : std::vector<double>()};
        if (!is_told()) return errors;
        const std::size_t worst = worst_of(errors.picture);
        tell(with_black ? "geometry" : "sky", scene, place_of(scene, subject, worst), errors.picture[worst], seen[worst],
             right.here[worst]);
        if (errors.black.empty()) return errors;
        const std::size_t black = worst_of(errors.black), pixel = right.black[black];
        tell("black", scene, place_of(scene, subject, pixel), errors.black[black], seen[pixel], right.here[pixel]);
        return errors;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        const std::vector<double> infinite{std::numeric_limits<double>::infinity()};
        return {infinite, with_black ? infinite : std::vector<double>()};
    }
}

/// One model along one axis.
void run(const Stored& stored, std::size_t rung, const Sweep& axis, std::span<const Backend> all) {
    std::uint32_t made = 0;
    std::vector<Rung> rungs;
    std::vector<Observer> observers;
    std::unique_ptr<Observer> exact;
    for (const Base& base : bases())
        for (const double value : axis.values) {
            const std::vector<Scene> scenes = axis.scenes(base, value);
            if (scenes.front().finer != made) {
                rungs = stored.rungs(made = scenes.front().finer);
                observers.clear();
                for (const Backend& backend : all) observers.emplace_back(*backend.machine, rungs[rung].model);
                exact = std::make_unique<Observer>(physics::cpu_double(), rungs[rung].model);
            }
            const auto line = [&](const char* subject) { return Line{rungs[rung].name, stored, base, axis, value, subject}; };
            for (std::size_t i = 0; i < all.size(); ++i) {
                Errors sky, geometry;
                for (const Scene& scene : scenes) {
                    sky.add(compare(observers[i], *exact, scene, Subject::sky, stored.half));
                    geometry.add(compare(observers[i], *exact, scene, Subject::geometry, stored.half));
                }
                print(line("sky"), all[i], sky.picture);
                print(line("geometry"), all[i], geometry.picture);
                if (!geometry.black.empty()) print(line("black"), all[i], geometry.black);
            }
        }
}

/// As lines of worst_scenes.inc, each with the scene that it stands for; bounds are half as much again, a thousandth at least.
void search_all(std::uint64_t starts, std::string_view only) {
    for (const Rung& rung : searched_rungs()) {
        if (!only.empty() && only != rung.name) continue;
        ModelError error(rung);
        for (const Subject subject : {Subject::sky, Subject::geometry}) {
            const WorstScene worst = search(error, subject, 1, starts);
            const char* of = subject == Subject::sky ? "sky" : "geometry";
            std::printf("// %s: %.2g at %s.\n", of, worst.error, text_of(scene_at(worst.at, subject)).c_str());
            std::printf("{\"%s\", Subject::%s, %.2g, {", rung.name, of, std::max(1.5 * worst.error, 1e-3));
            for (std::size_t i = 0; i < worst.at.size(); ++i) std::printf("%s%.17g", i == 0 ? "" : ", ", worst.at[i]);
            std::printf("}},\n");
            std::fflush(stdout);
        }
    }
}

/// What the scenes that are kept have for an error, and where (AUREOLE_STABILITY_PRINT).
void show_kept() {
    for (const Rung& rung : searched_rungs()) {
        Observer seen(physics::cpu_float(), rung.model), exact(physics::cpu_double(), rung.model);
        for (const KeptScene& kept : kept_scenes()) {
            if (std::string_view(kept.rung) != rung.name) continue;
            const Scene scene = scene_at(kept.at, kept.subject);
            const Errors errors = compare(seen, exact, scene, kept.subject, false);
            std::printf("%s, %s: %.3g, at most %g, at %s\n", kept.rung, kept.subject == Subject::sky ? "sky" : "geometry",
                        std::ranges::max(errors.picture), kept.bound, text_of(scene).c_str());
        }
    }
}

int usage() {
    std::fputs("stability_envelope [AXIS|all] [cpu]\nstability_envelope search STARTS [MODEL]\nstability_envelope kept\nAxes:",
               stderr);
    for (const Sweep& axis : sweeps()) std::fprintf(stderr, " \"%s\"", axis.name);
    std::fputs("\n", stderr);
    return 2;
}

}  // namespace

int main(int count, char** words) {
    const std::string_view only = count > 1 ? words[1] : "all", with = count > 2 ? words[2] : "";
    if ((count == 3 || count == 4) && only == "search") {
        const std::uint64_t starts = std::strtoull(words[2], nullptr, 10);
        if (starts < 4 || starts > 1'000'000) return usage();
        search_all(starts, count == 4 ? words[3] : "");
        return 0;
    }
    if (count == 2 && only == "kept") {
        show_kept();
        return 0;
    }
    if (count > 3 || (count > 2 && with != "cpu")) return usage();
    const bool known = only == "all" || std::ranges::any_of(sweeps(), [&](const Sweep& axis) { return only == axis.name; });
    if (!known) return usage();
    const std::vector<Backend> all = backends(with != "cpu");
    std::printf("model,backend,tables,subject,base,axis,value,p95,max\n");
    for (const Sweep& axis : sweeps()) {
        if (only != "all" && only != axis.name) continue;
        for (const Stored& stored : storages) {
            if (std::string_view(axis.name) == "table size" && std::string_view(stored.name) == "none") continue;
            for (std::size_t rung = 0; rung < stored.rungs(1).size(); ++rung) run(stored, rung, axis, all);
        }
    }
    return 0;
}
