#include "common/check.h"

#include <algorithm>
#include <charconv>

namespace aureole::detail {

std::string print(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string range_text(double low, double high) { return "in [" + print(low) + ", " + print(high) + "]"; }

std::string element(std::string_view field, std::size_t index) {
    return std::string(field) + "[" + std::to_string(index) + "]";
}

void FieldName::append(std::string_view more) noexcept {
    const std::size_t count = std::min(more.size(), sizeof text_ - size_);
    std::copy_n(more.data(), count, text_ + size_);
    size_ += count;
}
FieldName FieldName::operator+(std::string_view more) const noexcept {
    FieldName longer = *this;
    longer.append(more);
    return longer;
}
FieldName FieldName::operator[](std::size_t index) const noexcept {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, index).ptr;
    FieldName longer = *this + "[";
    longer.append({digits, static_cast<std::size_t>(end - digits)});
    longer.append("]");
    return longer;
}

void reject(std::string_view field, std::string_view value, std::string_view allowed) {
    throw Error(ErrorCode::invalid_argument, field, value, allowed);
}

void check(std::string_view field, double value, double low, double high) {
    if (!(value >= low && value <= high)) reject(field, print(value), range_text(low, high));  // negated: catches NaN
}

void check_rgb(const FieldName& field, const Rgb& value, double low, double high) {
    check(field + ".r", value.r, low, high);
    check(field + ".g", value.g, low, high);
    check(field + ".b", value.b, low, high);
}

void check_xyz(const FieldName& field, const glm::dvec3& value, double low, double high) {
    check(field + ".x", value.x, low, high);
    check(field + ".y", value.y, low, high);
    check(field + ".z", value.z, low, high);
}

void check_count(std::string_view field, std::size_t count, std::size_t low, std::size_t high) {
    if (count < low || count > high)
        reject(field, std::to_string(count) + " entries", std::to_string(low) + " to " + std::to_string(high) + " entries");
}

}  // namespace aureole::detail
