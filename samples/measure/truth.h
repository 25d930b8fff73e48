// The truth of a suite's scenes: tables beside the suite, by the path tracer, with their standard errors and every parameter.
#pragma once

#include "app/trace_checkpoint.h"
#include "measure/metrics.h"
#include "measure/suite.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace aureole::app {

/// True radiances of one air.
class TruthTable {
public:
    struct Entry {
        TrueValue radiance;  ///< 1/sr per unit of solar irradiance (of a white sun in wavelengths), without the sun's disk.
        std::uint64_t paths = 0;
    };

    /// The file, if there is one; else nothing is known yet. Throws Error: io; invalid_argument for a table of other
    /// parameters, naming the first that differs, and as read_csv does.
    [[nodiscard]] static TruthTable read(const std::filesystem::path& path, const TraceParameters& parameters);
    /// Replaces the file.
    void write(const std::filesystem::path& path, const TraceParameters& parameters) const;

    [[nodiscard]] const Entry* find(const ProbeRow& row) const;  ///< Null: not known.
    void set(const ProbeRow& row, const Entry& entry);
    [[nodiscard]] std::vector<ProbeRow> missing(std::span<const ProbeRow> rows) const;
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }

private:
    using Place = std::array<double, 4>;
    std::map<Place, Entry> entries_;
};

/// "truth/earth.csv", beside the suite.
[[nodiscard]] std::filesystem::path truth_file(const Suite& suite, const SuiteAir& air);
/// What an air's table depends on.
[[nodiscard]] TraceParameters truth_parameters(const SuiteAir& air);
/// Every direction of this air's scenes (points.h), each once.
[[nodiscard]] std::vector<ProbeRow> truth_rows(const Suite& suite, std::size_t air);

}  // namespace aureole::app
