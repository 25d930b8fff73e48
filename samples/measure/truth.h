// The truth of a suite's scenes: tables beside the suite, by the path tracer, with their standard errors and every parameter.
#pragma once

#include "app/trace_checkpoint.h"
#include "measure/aerial.h"
#include "measure/metrics.h"
#include "measure/suite.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

/// What a table holds, all per unit of solar irradiance (of a white sun in wavelengths), and what stands in the third of the
/// four columns that say of where.
enum class TruthKind : std::uint8_t {
    sky,      ///< Radiance of directions, 1/sr, without the sun's disk; view_zenith_deg.
    aerial,   ///< Radiance of the pixels of an AerialView (aerial.h), 1/sr; pixel.
    picture,  ///< Radiance of the pixels of a picture (pictures.h), 1/sr; view_zenith_deg.
    light,    ///< Irradiance; part: 0 that of the sky on a horizontal surface, 1 that of the sun on one that faces it.
};

/// What a table's numbers depend on beside its parameters. Older tables do not say all of it: they are of the first seed and
/// version, and say no more when they grow.
struct TruthMadeBy {
    static constexpr int first_seed = 0, first_version = 1;
    static constexpr int present_version = 1;  ///< To be raised when the path tracer draws or weighs its paths otherwise.

    std::optional<int> seed = TraceSettings{}.seed;  ///< Of TraceSettings.
    std::optional<int> version = present_version;
    [[nodiscard]] bool operator==(const TruthMadeBy&) const = default;
};

/// What is known of one air.
class TruthTable {
public:
    struct Entry {
        TrueValue value;
        std::uint64_t paths = 0;
    };
    explicit TruthTable(TruthKind kind = TruthKind::sky) : kind_(kind) {}

    /// The file, if there is one; else nothing is known yet. Throws Error: io; invalid_argument for a table of other
    /// parameters, naming the first that differs, and as read_csv does.
    [[nodiscard]] static TruthTable read(const std::filesystem::path& path, const TraceParameters& parameters,
                                         TruthKind kind = TruthKind::sky);
    [[nodiscard]] const TruthMadeBy& made_by() const noexcept { return made_by_; }
    /// Throws Error(invalid_argument) naming `path` if what was made by another seed or version than `today`'s stands in the
    /// table: nothing of today may be put beside it.
    void check_may_grow(const std::filesystem::path& path, const TruthMadeBy& today = {}) const;
    /// Replaces the file.
    void write(const std::filesystem::path& path, const TraceParameters& parameters) const;

    [[nodiscard]] const Entry* find(const ProbeRow& row) const;  ///< Null: not known.
    void set(const ProbeRow& row, const Entry& entry);
    /// How well a value must be known: with this relative standard error in each channel, or by so many paths.
    struct Wanted {
        double error = 1e300;
        std::uint64_t paths = 0;
    };
    /// Of these rows those that are not known, or not as well.
    [[nodiscard]] std::vector<ProbeRow> missing(std::span<const ProbeRow> rows, const Wanted& wanted) const;
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }

private:
    using Place = std::array<double, 4>;
    TruthKind kind_;
    TruthMadeBy made_by_;
    std::map<Place, Entry> entries_;
};

/// All that is known of an air's scenes.
struct AirTruth {
    TruthTable sky{TruthKind::sky}, aerial{TruthKind::aerial}, light{TruthKind::light};
};
[[nodiscard]] AirTruth read_truth(const Suite& suite, std::size_t air);

/// Another one for other values (FNV-1a of their bits): what was measured against them does not hold for others.
[[nodiscard]] std::uint64_t fingerprint(std::span<const TrueValue> values);

/// "truth/earth.csv", "truth/earth_aerial.csv", "truth/earth_light.csv" beside the suite.
[[nodiscard]] std::filesystem::path truth_file(const Suite& suite, const SuiteAir& air, TruthKind kind);
/// What an air's tables depend on.
[[nodiscard]] TraceParameters truth_parameters(const SuiteAir& air);
/// Directions of an air's scenes (points.h) that are to be known equally well, each once.
struct TruthRows {
    double error = 0, max_paths = 0;
    std::vector<ProbeRow> rows;
};
[[nodiscard]] std::vector<TruthRows> truth_rows(const Suite& suite, std::size_t air);

/// The picture of a scene with geometry, and where its pixels stand in the table.
[[nodiscard]] AerialView aerial_view(const SuiteScene& scene);
[[nodiscard]] ProbeRow aerial_row(const AerialView& view, std::size_t pixel);
/// Where a scene's light stands in the table.
enum class LightPart : std::uint8_t { sky, sun };
[[nodiscard]] ProbeRow light_row(const SuiteScene& scene, LightPart part);

}  // namespace aureole::app
