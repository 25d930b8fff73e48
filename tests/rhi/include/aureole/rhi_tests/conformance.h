// The conformance kit: checks of what an rhi::Device must do, for whoever implements one. Link aureole::rhi_tests, make a
// Target of your device, and run:
//
//     int main(int argc, char** argv) {
//         MyDevice mine;
//         return aureole::conformance::run_main({mine.device(), mine.queue()}, argc, argv);
//     }
//
// or, inside a test framework of your own, one test for each of checks():
//
//     const Result result = check.run({mine.device(), mine.queue()});
//     EXPECT(result.outcome != Outcome::failed) << result.text();
//
// What a device says it cannot do (Device::capabilities, Device::format_support) is not asked of it, and noted. No test
// framework is needed, and nothing of one is in the library. Not for several threads at once on one device. Page:
// docs/conformance.md.
#pragma once

#include <aureole/rhi/device.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::conformance {

/// The device to be checked. Device and queue outlive every run.
struct Target {
    rhi::Device& device;  ///< The device.
    /// Records and runs a list of the device: for a host with a frame loop a few lines (docs/conformance.md). Frame numbers
    /// (Queue::submit) are those that the device's objects are destroyed by.
    rhi::Queue& queue;
    /// The device rounds every store to nearest even and filters in full precision (the CPU backend). Otherwise either
    /// neighbour of the exact value is accepted, denormals may vanish, and filter weights may have 8 bits.
    bool exact = false;
    /// Makes a texture of a host's and lends it in State::general; it stays as long as the device. Asked for: 8x4 texels of
    /// rgba32_float, 2D. Empty: nothing can be lent, and the check of lent textures is skipped.
    std::function<rhi::ExternalTexture(const rhi::TextureDesc&)> lend{};
    /// How far the tables of a pass may be from those of the CPU backend in float, made of the same parameters from the same
    /// tables before: relative, where less than a thousandth of the brightest in a table counts as that. In (0, 1]. The
    /// default has room for filter weights of 8 bits and for the sines of the fastest GPUs; a device that computes in float as
    /// IEEE 754 says keeps 1e-4.
    double pass_tolerance = 1e-2;
};

/// How a check ended.
enum class Outcome : std::uint8_t {
    passed,   ///< All is as it should be.
    failed,   ///< Something is not: Result::failures.
    skipped,  ///< The device, or the target, has nothing that the check could try. No failure.
};
[[nodiscard]] const char* to_string(Outcome outcome) noexcept;  ///< As written here.

/// What one check found.
struct Result {
    std::string name;                   ///< Of the check.
    Outcome outcome = Outcome::passed;  ///< How it ended.
    std::string reason;                 ///< Why it was skipped; else empty.
    std::vector<std::string>
        failures;                    ///< What was wrong: where, what came, what was wanted. The first 12, then how many more.
    std::vector<std::string> notes;  ///< What was not tried, because the device says it cannot do it; figures.
    double seconds = 0;              ///< Wall time.
    /// For people: a line, and one more for each failure and note.
    [[nodiscard]] std::string text() const;
};

/// What a check is about.
enum class Subject : std::uint8_t {
    device,  ///< What rhi::Device, CommandList and Queue promise: functions, formats, filters, barriers.
    passes,  ///< What follows: the passes of the model `aureole` on this device, against the CPU backend.
};

/// One check of the kit: something that every device must do.
struct Check {
    const char* name;             ///< Stays the same from version to version; new ones may come.
    Subject subject;              ///< What it is about.
    void (*body)(const Target&);  ///< For run().

    /// Never throws: what the device throws is a failure. Its message callback is left as it was set last or empty.
    [[nodiscard]] Result run(const Target& target) const noexcept;
};
/// All checks, in the order in which they are best read: what fails early explains what fails later.
[[nodiscard]] std::span<const Check> checks() noexcept;
/// By its whole name. Throws Error(invalid_argument) naming "check" for one that there is not.
[[nodiscard]] const Check& check_by_name(std::string_view name);

/// What a run of several checks found.
struct Report {
    std::vector<Result> results;                                      ///< In the order of running.
    [[nodiscard]] std::size_t count(Outcome outcome) const noexcept;  ///< How many ended so.
    /// Something ran, and none failed.
    [[nodiscard]] bool passed() const noexcept;
    /// Every result's text, and the counts.
    [[nodiscard]] std::string text() const;
};
/// Runs every check whose name contains `part`; all of them for an empty one.
[[nodiscard]] Report run_all(const Target& target, std::string_view part = {}) noexcept;
/// Runs the checks of one subject.
[[nodiscard]] Report run_all(const Target& target, Subject subject) noexcept;

/// A test program: prints each result as it comes, and the counts. Arguments: parts of names, of which a check's must contain
/// one (none given: all run); --list prints the names alone. Returns 0 if something ran and none failed, 1 if not, 2 for an
/// argument that it does not know.
[[nodiscard]] int run_main(const Target& target, int argc, const char* const* argv);

}  // namespace aureole::conformance
