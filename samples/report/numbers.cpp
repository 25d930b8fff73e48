#include "report/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace aureole::app::report {
namespace {

constexpr int most_decimals = 4;

std::string count(double value) {
    for (const auto& [unit, name] : {std::pair{1e9, " G"}, {1e6, " M"}, {1e3, " k"}})
        if (std::abs(value) >= unit) return short_number(value / unit) + name;
    return short_number(value);
}

}  // namespace

std::string short_number(double value) {
    const double size = std::abs(value);
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    if (size == 0) return "0";
    if (size < 0.5 * std::pow(10.0, -most_decimals)) return "<0.0001";
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, most_decimals);
    char text[400];  // the greatest double has 309 digits
    std::string digits(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr);
    if (digits.find('.') != std::string::npos) digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
    return digits;
}

std::string whole_percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string in_unit(double value, Unit unit) {
    switch (unit) {
        case Unit::percent:
            return short_number(100 * value);
        case Unit::bytes:
            return short_number(value / (1024 * 1024));
        case Unit::count:
            return count(value);
        case Unit::delta_e:
        case Unit::milliseconds:
            break;
    }
    return short_number(value);
}

std::string in_unit(const std::map<std::string, double>& figures, const Figure& figure) {
    const std::string key(figure.key);
    const auto found = figures.find(key), low = figures.find(key + "_p10"), high = figures.find(key + "_p90");
    if (found == figures.end()) return std::string(not_measured);
    std::string value = in_unit(found->second, figure.unit);
    if (low == figures.end() || high == figures.end()) return value;
    return value + " (" + in_unit(low->second, figure.unit) + " to " + in_unit(high->second, figure.unit) + ")";
}

}  // namespace aureole::app::report
