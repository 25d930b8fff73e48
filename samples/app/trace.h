// Radiance of single directions by path tracing, each until its standard error is as small as wanted.
#pragma once

#include "app/backend.h"
#include "app/probe.h"
#include "app/tally.h"

#include <aureole/models/reference.h>
#include <aureole/parameters.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// Paths are traced in rounds: of each direction `trace_lanes` batches, of which only the mean is kept.
inline constexpr std::uint32_t trace_lanes = 32;
inline constexpr int trace_batch_paths = 64;  ///< Within what every driver finishes (reference.md).
inline constexpr std::uint64_t trace_round_paths = std::uint64_t{trace_lanes} * trace_batch_paths;
/// Fewer rounds say too little of their own scatter.
inline constexpr std::uint64_t trace_least_rounds = 2;

struct TraceSettings {
    double error = 0.005;               ///< Wanted standard error of each channel, relative to its radiance. In [1e-6, 1].
    std::uint64_t max_paths = 1 << 20;  ///< Of a direction, at most. In [4096, 1e12].
    int orders = 0;                     ///< Radiance of the orders 1 to this is told apart, too. In [0, 64].
    int seed = 0;                       ///< Another seed, other paths. In [0, 4095].
    /// With `ratio` nothing is biased, and `orders` must be 0: the difference of two noises says little of the second order.
    models::ReferenceSettings::Tracking tracking = models::ReferenceSettings::Tracking::quadrature;
    std::string spectral = "rgb";  ///< Or a number of wavelengths, as models::wavelengths_by_name takes it.

    /// Throws Error(invalid_argument) at the first value outside its range.
    void validate() const;
};

/// What is known of a direction: all that a later run needs to go on.
struct TraceState {
    std::uint64_t rounds = 0;
    std::vector<Tally> tallies;  ///< All orders together; then the second to TraceSettings::orders.
    [[nodiscard]] bool operator==(const TraceState&) const = default;
};

struct TraceResult {
    Estimated all;
    Rgb first_air{0}, first_ground{0};  ///< Scattered once by the air; reflected once by the ground: without paths.
    std::vector<Estimated> orders;
    std::uint64_t paths = 0;
};

class Tracer {
public:
    /// Throws Error(invalid_argument) for a setting or a row (from 1) outside its range, (unsupported) for more rows than the
    /// device takes.
    Tracer(Backend& backend, const AtmosphereParameters& parameters, std::vector<ProbeRow> rows, const TraceSettings& settings);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// Traces another round of some directions that still need it; false if there are none. What a direction gets depends on
    /// its place in the list, the seed and its rounds so far, on nothing else. If `stop` says so the round is dropped halfway,
    /// without a trace.
    bool step(const std::function<bool()>& stop = {});
    /// How much is done of what is to be expected by now, in [0, 1].
    [[nodiscard]] double share() const;
    [[nodiscard]] std::size_t done() const;  ///< Directions.
    [[nodiscard]] const std::vector<ProbeRow>& rows() const { return rows_; }
    [[nodiscard]] TraceResult result(std::size_t row) const;
    /// Whether the wanted error has been reached: false where max_paths came first.
    [[nodiscard]] bool reached(std::size_t row) const;

    [[nodiscard]] const std::vector<TraceState>& states() const { return states_; }
    /// Goes on from there. Throws Error(invalid_argument) if these are not states of as many rows and orders.
    void restore(std::vector<TraceState> states);

private:
    struct Eyes;
    using Values = std::vector<Rgb>;  ///< trace_lanes for each row.
    [[nodiscard]] bool finished(const TraceState& state) const;
    void find_first_orders(const AtmosphereParameters& parameters);
    void add(std::size_t row, const std::vector<Values>& up_to);

    Backend& backend_;
    TraceSettings settings_;
    std::vector<ProbeRow> rows_;
    std::vector<std::vector<std::size_t>> blocks_;  ///< Rows of the same sun and altitude, not too many.
    std::vector<TraceState> states_;
    std::vector<Rgb> first_, first_air_;
    std::unique_ptr<Eyes> eyes_;
};

}  // namespace aureole::app
