// Between C and C++: nothing is thrown across, null pointers and unknown struct sizes are refused, and structs grow.
#pragma once

#include <aureole/c/base.h>
#include <aureole/rhi/error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace aureole::c_api {

[[nodiscard]] aureole_result result_of(ErrorCode code) noexcept;
[[nodiscard]] ErrorCode code_of(aureole_result result) noexcept;

/// Stores what is being thrown as this thread's last error.
[[nodiscard]] aureole_result caught() noexcept;

template <class Act>
[[nodiscard]] aureole_result guarded(const Act& act) noexcept {
    try {
        act();
        return AUREOLE_OK;
    } catch (...) {
        return caught();
    }
}

/// The text of aureole_set_callback_error, which is forgotten then.
[[nodiscard]] std::string take_callback_error();

/// Throws Error(invalid_argument) naming the argument.
template <class T>
T& given(T* pointer, std::string_view name) {
    if (!pointer) throw Error(ErrorCode::invalid_argument, name, "NULL", "a pointer to an object");
    return *pointer;
}

/// Size of a struct as it was first published: smaller ones have never been. To be specialized for those that grow.
template <class T>
inline constexpr std::uint32_t first_size = sizeof(T);

template <class T>
void check_size(std::uint32_t size, std::string_view name, std::uint32_t first = first_size<T>) {
    if (size >= first && size <= sizeof(T)) return;
    throw Error(ErrorCode::invalid_argument, std::string(name) + ".struct_size", std::to_string(size),
                std::to_string(first) + " to " + std::to_string(sizeof(T)) + ", as sizeof gives it");
}

/// A caller's struct, completed by `defaults` where it is of an older header.
template <class T>
[[nodiscard]] T read(const T* from, std::string_view name, const T& defaults, std::uint32_t first = first_size<T>) {
    const std::uint32_t size = given(from, name).struct_size;
    check_size<T>(size, name, first);
    T whole = defaults;
    std::memcpy(static_cast<void*>(&whole), from, size);
    whole.struct_size = sizeof(T);
    return whole;
}

/// As much of `whole` as the caller's struct has room for.
template <class T>
void write(T* to, std::string_view name, const T& whole, std::uint32_t first = first_size<T>) {
    const std::uint32_t size = given(to, name).struct_size;
    check_size<T>(size, name, first);
    std::memcpy(static_cast<void*>(to), &whole, size);
    to->struct_size = size;
}

/// Element `index` of a caller's array, whose elements all have the size that the first one states.
template <class T>
[[nodiscard]] T* element(T* first, std::uint32_t index) {
    using Bytes = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;
    return reinterpret_cast<T*>(reinterpret_cast<Bytes*>(first) + std::size_t{index} * first->struct_size);
}

/// Writes as many of `count` as the caller has room for, and their number.
template <class T>
void write_all(T* out, std::uint32_t capacity, std::uint32_t* out_count, std::string_view name, std::size_t count,
               const std::function<T(std::size_t)>& make) {
    given(out_count, "out_count");
    if (capacity > 0) check_size<T>(given(out, name).struct_size, name);
    const std::uint32_t size = capacity > 0 ? out->struct_size : 0;
    for (std::uint32_t i = 0; i < capacity && i < count; ++i) {
        T* const to = element(out, i);
        to->struct_size = size;
        write(to, name, make(i));
    }
    *out_count = static_cast<std::uint32_t>(count);
}

/// An enumerator of C++ that has the number of one in C.
template <class E>
[[nodiscard]] E enumerator(std::uint32_t number, E last, std::string_view name) {
    const auto most = static_cast<std::uint32_t>(last);
    if (number > most) throw Error(ErrorCode::invalid_argument, name, std::to_string(number), "0 to " + std::to_string(most));
    return static_cast<E>(number);
}
template <class E>
[[nodiscard]] constexpr std::uint32_t number(E value) noexcept {
    return static_cast<std::uint32_t>(value);
}

[[nodiscard]] inline bool boolean(std::uint32_t value, std::string_view name) {
    if (value > 1) throw Error(ErrorCode::invalid_argument, name, std::to_string(value), "0 or 1");
    return value == 1;
}
[[nodiscard]] inline std::string text(const char* words) { return words ? words : ""; }

}  // namespace aureole::c_api
