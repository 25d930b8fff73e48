#include <aureole/rhi/error.h>
#include <aureole/rhi_tests/conformance.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "rhi/checks.h"
#include "rhi/report.h"

namespace aureole::conformance {
namespace {

constexpr Check all_checks[] = {
    {"capabilities", Subject::device, check_capabilities},
    {"creation errors", Subject::device, check_creation_errors},
    {"deferred destroy", Subject::device, check_deferred_destroy},
    {"find", Subject::device, check_find},
    {"lent textures", Subject::device, check_lent_textures},
    {"texel round trips", Subject::device, check_texel_round_trips},
    {"texture copies", Subject::device, check_texture_copies},
    {"cube copies", Subject::device, check_cube_copies},
    {"storage formats", Subject::device, check_storage_formats},
    {"attachment formats", Subject::device, check_attachment_formats},
    {"format reads", Subject::device, check_format_reads},
    {"nearest filter", Subject::device, check_nearest},
    {"linear filter", Subject::device, check_linear},
    {"linear filter, repeat", Subject::device, check_linear_repeat},
    {"3d textures", Subject::device, check_3d},
    {"cube textures", Subject::device, check_cube},
    {"edges of cubes", Subject::device, check_cube_edges},
    {"specialization", Subject::device, check_specialization},
    {"constants", Subject::device, check_constants},
    {"order of updates", Subject::device, check_update_order},
    {"barriers", Subject::device, check_barriers},
    {"edges of a dispatch", Subject::device, check_edges},
    {"raster", Subject::device, check_raster},
    {"raster and barriers", Subject::device, check_raster_barriers},
    {"timestamps", Subject::device, check_timestamps},
    {"markers and messages", Subject::device, check_markers_and_messages},
    {"frames", Subject::device, check_frames},
    {"pass: transmittance", Subject::passes, check_transmittance},
    {"pass: multi-scatter", Subject::passes, check_multi_scatter},
    {"pass: sky-view", Subject::passes, check_sky_view},
    {"pass: aerial perspective", Subject::passes, check_aerial_perspective},
    {"pass: light", Subject::passes, check_light},
    {"pass: composite", Subject::passes, check_composite},
    {"pass: composite, drawn", Subject::passes, check_composite_drawn},
};

/// What the body says, and what it or the device throws.
void run_body(const Check& check, const Target& target, Result& result) {
    const Reporting reporting(result);
    try {
        check.body(target);
    } catch (const Skipped& skipped) {
        result.reason = skipped.reason;
        if (result.outcome != Outcome::failed) result.outcome = Outcome::skipped;
    } catch (const Stopped&) {
        // Said already.
    } catch (const Error& error) {
        fail("threw Error(" + std::string(to_string(error.code())) + "): " + error.what());
    } catch (const std::exception& error) {
        fail(std::string("threw ") + error.what());
    } catch (...) {
        fail("threw what is no std::exception");
    }
}

template <class Wanted>
Report run_some(const Target& target, const Wanted& wanted) {
    Report report;
    for (const Check& check : all_checks)
        if (wanted(check)) report.results.push_back(check.run(target));
    return report;
}

bool named(const Check& check, std::string_view part) {
    return std::string_view(check.name).find(part) != std::string_view::npos;
}

}  // namespace

const char* to_string(Outcome outcome) noexcept {
    switch (outcome) {
        case Outcome::passed:
            return "passed";
        case Outcome::failed:
            return "failed";
        case Outcome::skipped:
            return "skipped";
    }
    return "unknown";
}

std::string Result::text() const {
    char line[160];
    std::snprintf(line, sizeof line, "%-8s%-28s%6.2f s", to_string(outcome), name.c_str(), seconds);
    std::string all = line + (reason.empty() ? "\n" : "  " + reason + "\n");
    for (const std::string& failure : failures) all += "    FAILED  " + failure + "\n";
    for (const std::string& said : notes) all += "    note    " + said + "\n";
    return all;
}

Result Check::run(const Target& target) const noexcept {
    Result result;
    result.name = name;
    const auto start = std::chrono::steady_clock::now();
    run_body(*this, target, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::span<const Check> checks() noexcept { return all_checks; }

const Check& check_by_name(std::string_view name) {
    for (const Check& check : all_checks)
        if (check.name == name) return check;
    std::string names;
    for (const Check& check : all_checks) names += (names.empty() ? "" : ", ") + std::string(check.name);
    throw Error(ErrorCode::invalid_argument, "check", name, names);
}

std::size_t Report::count(Outcome outcome) const noexcept {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [&](const Result& result) { return result.outcome == outcome; }));
}

bool Report::passed() const noexcept { return count(Outcome::passed) > 0 && count(Outcome::failed) == 0; }

std::string Report::text() const {
    std::string all;
    for (const Result& result : results) all += result.text();
    return all + std::to_string(count(Outcome::passed)) + " passed, " + std::to_string(count(Outcome::failed)) + " failed, " +
           std::to_string(count(Outcome::skipped)) + " skipped\n";
}

Report run_all(const Target& target, std::string_view part) noexcept {
    return run_some(target, [&](const Check& check) { return named(check, part); });
}

Report run_all(const Target& target, Subject subject) noexcept {
    return run_some(target, [&](const Check& check) { return check.subject == subject; });
}

int run_main(const Target& target, int argc, const char* const* argv) {
    const std::span<const char* const> parts(argv + std::min(argc, 1), static_cast<std::size_t>(std::max(argc - 1, 0)));
    for (const std::string_view part : parts) {
        if (part == "--list") {
            for (const Check& check : all_checks) std::puts(check.name);
            return 0;
        }
        if (part.starts_with('-')) {
            std::fprintf(stderr, "unknown argument %s; allowed: --list, parts of names\n", std::string(part).c_str());
            return 2;
        }
    }
    Report report;
    for (const Check& check : all_checks) {
        const bool wanted = std::any_of(parts.begin(), parts.end(), [&](const char* part) { return named(check, part); });
        if (!parts.empty() && !wanted) continue;
        report.results.push_back(check.run(target));
        std::fputs(report.results.back().text().c_str(), stdout);
        std::fflush(stdout);
    }
    std::printf("%zu passed, %zu failed, %zu skipped\n", report.count(Outcome::passed), report.count(Outcome::failed),
                report.count(Outcome::skipped));
    return report.passed() ? 0 : 1;
}

}  // namespace aureole::conformance
