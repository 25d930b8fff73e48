// Rejecting values: every message names field, value and allowed range.
#pragma once

#include <aureole/parameters.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace aureole::detail {

/// Shortest text that reads back as the same number; "nan" and "inf" for those.
[[nodiscard]] std::string print(double value);
/// "in [low, high]"
[[nodiscard]] std::string range_text(double low, double high);
/// "<field>[<index>]"
[[nodiscard]] std::string element(std::string_view field, std::size_t index);

/// A field's name with room for what comes behind it, made without allocating: what is checked in every frame names its fields
/// by it. What does not fit is cut off.
class FieldName {
public:
    FieldName(std::string_view text) noexcept { append(text); }
    FieldName(const char* text) noexcept : FieldName(std::string_view(text)) {}
    FieldName(const std::string& text) noexcept : FieldName(std::string_view(text)) {}
    /// "<name><more>"
    [[nodiscard]] FieldName operator+(std::string_view more) const noexcept;
    /// "<name>[<index>]"
    [[nodiscard]] FieldName operator[](std::size_t index) const noexcept;
    operator std::string_view() const noexcept { return {text_, size_}; }

private:
    void append(std::string_view more) noexcept;
    char text_[112];
    std::size_t size_ = 0;
};

/// Throws Error(invalid_argument).
[[noreturn]] void reject(std::string_view field, std::string_view value, std::string_view allowed);

/// Rejects everything outside [low, high], and NaN.
void check(std::string_view field, double value, double low, double high);
/// The same for each of ".r", ".g", ".b" (or ".x", ".y", ".z").
void check_rgb(const FieldName& field, const Rgb& value, double low, double high);
void check_xyz(const FieldName& field, const glm::dvec3& value, double low, double high);
/// Rejects a number that is none of the enumerators, which count from 0 to `last`.
template <class Enum>
void check_enum(std::string_view field, Enum value, Enum last, std::string_view allowed) {
    const auto number = static_cast<int>(value);
    if (number < 0 || number > static_cast<int>(last)) reject(field, std::to_string(number), allowed);
}
/// Number of entries of a list.
void check_count(std::string_view field, std::size_t count, std::size_t low, std::size_t high);

}  // namespace aureole::detail
