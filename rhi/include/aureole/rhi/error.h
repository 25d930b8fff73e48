// The one error type of the whole library.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace aureole {

/// What kind of thing went wrong. A host switches on this; people read `Error::what()`.
enum class ErrorCode {
    invalid_argument,  ///< A value given by the caller is outside its documented range.
    unsupported,       ///< The device lacks a format, feature or limit that the request needs.
    out_of_memory,     ///< Host or device memory could not be had.
    device_lost,       ///< The device stopped working; every object made from it is dead.
    io,                ///< A file could not be read or written (samples only).
    misuse,            ///< The interface was called in a forbidden order or state.
    internal           ///< A bug in Aureole or in the driver.
};

/// Short name of a code, e.g. "invalid_argument". Never null, never throws.
[[nodiscard]] const char* to_string(ErrorCode code) noexcept;

/// Thrown by every Aureole function that rejects its input or cannot do its work. Whatever throws leaves its object as it
/// was: nothing is half-applied. `what()` reads "<field>: <value> is not allowed; allowed: <range>" or a plain sentence.
class Error : public std::runtime_error {
public:
    /// A failure that is not about one field.
    Error(ErrorCode code, const std::string& message);

    /// A rejected value. `field` is the dotted name as the caller knows it ("planet.bottom_radius_m"), `value` what was
    /// given (printed), `allowed` the accepted range or set in words ("finite, > 0").
    Error(ErrorCode code, std::string_view field, std::string_view value, std::string_view allowed);

    [[nodiscard]] ErrorCode code() const noexcept { return code_; }                 ///< What kind of failure.
    [[nodiscard]] const std::string& field() const noexcept { return field_; }      ///< Empty if not about one field.
    [[nodiscard]] const std::string& value() const noexcept { return value_; }      ///< Empty if not about one field.
    [[nodiscard]] const std::string& allowed() const noexcept { return allowed_; }  ///< Empty if not about one field.

private:
    ErrorCode code_;
    std::string field_, value_, allowed_;
};

}  // namespace aureole
