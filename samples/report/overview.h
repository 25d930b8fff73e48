// The two tables that a reader wants first: every setting in every class of scenes, and what each simplification costs.
#pragma once

#include "report/summary.h"

namespace aureole::app::report {

/// Markdown; errors as median / 95th percentile. Costs are those of the first class that has them: its scenes' airs.
[[nodiscard]] std::string overview_tables(const Measurements& all, const std::vector<ClassSummary>& classes);

}  // namespace aureole::app::report
