#include "app/trace.h"

#include "app/trace_eyes.h"
#include "io/csv.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace aureole::app {
namespace {

using models::ReferenceSettings;

/// Rows of a block: a round of it takes a second or two, so that it can be interrupted.
constexpr std::size_t block_rows = 16;
void check(const char* field, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw Error(ErrorCode::invalid_argument, field, print_number(value),
                    "in [" + print_number(low) + ", " + print_number(high) + "]");
}

/// The first order needs none.
std::size_t tally_count(const TraceSettings& settings) { return static_cast<std::size_t>(std::max(settings.orders, 1)); }

Estimated estimate(const TraceState& state, const Tally& tally) {
    return estimate(tally, static_cast<double>(state.rounds) * trace_lanes);
}

/// Without paths: what nodes know, which is the first order.
ReferenceSettings up_to_order(int order, int paths, int seed, ReferenceSettings::Tracking tracking) {
    ReferenceSettings settings;
    if (paths > 0) settings.tracking = tracking;
    settings.max_order = order;
    settings.paths_per_frame = paths;
    settings.seed = seed;
    return settings;
}

}  // namespace

void TraceSettings::validate() const {
    check("error", error, 1e-6, 1);
    check("max_paths", static_cast<double>(max_paths), trace_least_rounds * trace_round_paths, 1e12);
    check("orders", orders, 0, 64);
    check("seed", seed, 0, seeds_of_trace - 1);
    if (tracking == ReferenceSettings::Tracking::ratio) check("orders, with ratio tracking", orders, 0, 0);
}

/// Everything on the device, for one seed.
struct Tracer::Eyes {
    Eyes(Backend& device, const AtmosphereParameters& parameters, std::size_t rows, const TraceSettings& settings)
        : backend(device), colours(parameters, settings.spectral), target(device, rows) {}

    /// An eye for every air, for orders up to `order`; 0: all.
    std::vector<std::unique_ptr<TraceEye>> open(int order, int paths, const TraceSettings& settings, std::uint64_t nth) {
        std::vector<std::unique_ptr<TraceEye>> opened;
        for (std::size_t air = 0; air < colours.airs().size(); ++air)
            opened.push_back(
                std::make_unique<TraceEye>(backend, colours.airs()[air],
                                           up_to_order(order, paths, nth_seed(settings, nth, air), settings.tracking), target));
        return opened;
    }
    /// Adds what they see of the chosen rows. False if it was stopped before.
    bool see(std::span<const std::unique_ptr<TraceEye>> eyes, std::span<const ProbeRow> rows,
             std::span<const std::size_t> chosen, std::uint64_t frame, Values& values, const std::function<bool()>& stop) {
        for (std::size_t air = 0; air < eyes.size(); ++air) {
            if (stop && stop()) return false;
            const std::vector<double> texels = eyes[air]->see(target, rows[chosen.front()], frame);
            for (const std::size_t row : chosen)
                for (std::size_t i = row * trace_lanes; i < (row + 1) * trace_lanes; ++i) {
                    const Rgb part = colours.part(air, {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]});
                    if (!std::isfinite(part.r + part.g + part.b))
                        throw Error(ErrorCode::internal, "the radiance of row " + std::to_string(row + 1) + " is not finite");
                    values[i] += part;
                }
        }
        return true;
    }
    /// Makes what this round needs: one of another seed needs other eyes.
    void prepare(std::uint64_t round, const TraceSettings& settings) {
        const std::uint64_t nth = round / seed_rounds;
        if (seeds == nth) return;
        by_order.clear();
        by_order.push_back(open(0, trace_batch_paths, settings, nth));
        for (int order = 2; order <= settings.orders; ++order)
            by_order.push_back(open(order, trace_batch_paths, settings, nth));
        seeds = nth;
    }

    Backend& backend;
    TraceColours colours;
    TraceTarget target;
    std::vector<std::vector<std::unique_ptr<TraceEye>>> by_order;  ///< All orders; up to the second, the third, ...
    std::optional<std::uint64_t> seeds;                            ///< The how many-th.
};

Tracer::Tracer(Backend& backend, const AtmosphereParameters& parameters, std::vector<ProbeRow> rows,
               const TraceSettings& settings)
    : backend_(backend), settings_(settings), rows_(std::move(rows)) {
    settings_.validate();
    if (rows_.empty()) throw Error(ErrorCode::invalid_argument, "rows", "none", "at least one");
    std::map<std::pair<double, double>, std::vector<std::size_t>> open;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        check_row(rows_[i], "row " + std::to_string(i + 1));
        std::vector<std::size_t>& block = open[{rows_[i].sun_zenith_deg, rows_[i].altitude_km}];
        block.push_back(i);
        if (block.size() == block_rows) blocks_.push_back(std::exchange(block, {}));
    }
    for (const auto& [place, block] : open)
        if (!block.empty()) blocks_.push_back(block);
    states_.assign(rows_.size(), {0, std::vector<Tally>(tally_count(settings_))});
    eyes_ = std::make_unique<Eyes>(backend, parameters, rows_.size(), settings_);
    find_first_orders(parameters);
}

Tracer::~Tracer() = default;

void Tracer::find_first_orders(const AtmosphereParameters& parameters) {
    AtmosphereParameters black = parameters;
    black.planet.ground_albedo = Rgb(0);
    Eyes over_black(backend_, black, rows_.size(), settings_);
    const auto first = eyes_->open(1, 0, settings_, 0), first_air = over_black.open(1, 0, settings_, 0);
    Values all(rows_.size() * trace_lanes), air(rows_.size() * trace_lanes);
    for (const std::vector<std::size_t>& block : blocks_) {
        eyes_->target.look(rows_, block, 1);
        eyes_->see(first, rows_, block, 0, all, {});
        over_black.target.look(rows_, block, 1);
        over_black.see(first_air, rows_, block, 0, air, {});
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        first_.push_back(all[row * trace_lanes]);
        first_air_.push_back(air[row * trace_lanes]);
    }
}

bool Tracer::finished(const TraceState& state) const {
    if ((state.rounds + 1) * trace_round_paths > settings_.max_paths) return true;
    return is_checked(state.rounds, trace_least_rounds) && relative_error(estimate(state, state.tallies[0])) <= settings_.error;
}

bool Tracer::step(const std::function<bool()>& stop) {
    std::vector<std::size_t> chosen;
    for (const std::vector<std::size_t>& block : blocks_) {
        for (const std::size_t row : block) {
            if (finished(states_[row])) continue;
            // Those that are behind come first: they differ where an earlier run wanted less.
            if (!chosen.empty() && states_[row].rounds < states_[chosen.front()].rounds) chosen.clear();
            if (chosen.empty() || states_[row].rounds == states_[chosen.front()].rounds) chosen.push_back(row);
        }
        if (!chosen.empty()) break;
    }
    if (chosen.empty()) return false;

    const std::uint64_t round = states_[chosen.front()].rounds;
    eyes_->prepare(round, settings_);
    eyes_->target.look(rows_, chosen, trace_lanes);
    std::vector<Values> up_to(eyes_->by_order.size(), Values(rows_.size() * trace_lanes));
    for (std::size_t i = 0; i < up_to.size(); ++i)
        if (!eyes_->see(eyes_->by_order[i], rows_, chosen, round % seed_rounds, up_to[i], stop)) return true;
    for (const std::size_t row : chosen) add(row, up_to);
    return true;
}

void Tracer::add(std::size_t row, const std::vector<Values>& up_to) {
    TraceState& state = states_[row];
    for (std::size_t lane = 0; lane < trace_lanes; ++lane) {
        const double count = static_cast<double>(state.rounds * trace_lanes + lane + 1);
        const std::size_t at = row * trace_lanes + lane;
        for (std::size_t i = 0; i < up_to.size(); ++i) {
            // Paths up to one order are those up to the next but for their last event: what they differ by is that event's.
            const Rgb value = i == 0 ? up_to[0][at] : up_to[i][at] - (i == 1 ? first_[row] : up_to[i - 1][at]);
            state.tallies[i].add(value, count);
        }
    }
    ++state.rounds;
}

double Tracer::share() const {
    double done = 0, expected = 0, begun = 0;
    for (const TraceState& state : states_) {
        if (state.rounds == 0) continue;
        const double rounds = static_cast<double>(state.rounds);
        const auto most = settings_.max_paths / trace_round_paths;
        done += rounds;
        expected +=
            finished(state) ? rounds : expected_rounds(state.rounds, most, estimate(state, state.tallies[0]), settings_.error);
        ++begun;
    }
    return begun > 0 ? done / expected * begun / static_cast<double>(states_.size()) : 0;
}

std::size_t Tracer::done() const {
    return static_cast<std::size_t>(std::ranges::count_if(states_, [&](const TraceState& s) { return finished(s); }));
}

TraceResult Tracer::result(std::size_t row) const {
    const TraceState& state = states_.at(row);
    TraceResult result;
    result.all = estimate(state, state.tallies[0]);
    result.first_air = first_air_[row];
    result.first_ground = glm::max(first_[row] - first_air_[row], Rgb(0));
    if (settings_.orders > 0) result.orders.push_back({first_[row], Rgb(0)});
    for (std::size_t i = 1; i < state.tallies.size(); ++i) result.orders.push_back(estimate(state, state.tallies[i]));
    result.paths = state.rounds * trace_round_paths;
    return result;
}

bool Tracer::reached(std::size_t row) const { return relative_error(result(row).all) <= settings_.error; }

void Tracer::restore(std::vector<TraceState> states) {
    constexpr std::uint64_t most_rounds = std::uint64_t{1'000'000'000'000} / trace_round_paths;
    const auto in_range = [](const Tally& tally) {
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(tally.mean[c]) || !std::isfinite(tally.spread[c]) || tally.spread[c] < 0) return false;
        return true;
    };
    const auto fits = [&](const TraceState& state) {
        return state.tallies.size() == tally_count(settings_) && state.rounds <= most_rounds &&
               std::ranges::all_of(state.tallies, in_range);
    };
    if (states.size() != rows_.size() || !std::ranges::all_of(states, fits))
        throw Error(ErrorCode::invalid_argument, "states", "others",
                    "as many as there are rows, with as many orders, of finite numbers");
    states_ = std::move(states);
}

}  // namespace aureole::app
