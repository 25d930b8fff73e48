// Numbers as the report's tables show them.
#pragma once

#include "report/measurements.h"

#include <string>

namespace aureole::app::report {

inline constexpr std::string_view not_measured = "–";

/// Three digits at most, without an exponent: "0.0123", "1.23", "123"; "<0.0001" for less than can be shown; "∞".
[[nodiscard]] std::string short_number(double value);
/// In the figure's unit, which its title names: fractions as %, bytes as MiB, counts as "12.3 k", "1.23 M".
[[nodiscard]] std::string in_unit(double value, Unit unit);
/// "34 %"
[[nodiscard]] std::string whole_percent(double share);
/// `not_measured` for none. Of a time with its range: "1.23 (1.2 to 1.4)".
[[nodiscard]] std::string in_unit(const std::map<std::string, double>& figures, const Figure& figure);

}  // namespace aureole::app::report
