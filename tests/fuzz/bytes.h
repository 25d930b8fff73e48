// Bytes as values of structs: inside and outside of the allowed ranges, on their ends, and none at all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace aureole::fuzz {

/// Hands out the bytes from the front; zeros when there are no more.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

    [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }

    template <class T>
    T raw() {
        T value{};
        const std::size_t count = std::min(sizeof value, rest_.size());
        std::memcpy(&value, rest_.data(), count);
        rest_ = rest_.subspan(count);
        return value;
    }
    bool flag() { return (raw<std::uint8_t>() & 1) != 0; }
    /// In [0, count).
    std::size_t below(std::size_t count) { return raw<std::uint8_t>() % count; }

    /// Mostly in [low, high]: evenly, by powers, on the ends; now and then beyond them, special, or any bits.
    double number(double low, double high) {
        static constexpr double inf = std::numeric_limits<double>::infinity();
        static constexpr std::array special{0.0,
                                            -0.0,
                                            1.0,
                                            -1.0,
                                            1e-300,
                                            5e-324,
                                            1e300,
                                            std::numeric_limits<double>::max(),
                                            -std::numeric_limits<double>::max(),
                                            inf,
                                            -inf,
                                            std::numeric_limits<double>::quiet_NaN()};
        const std::uint8_t kind = raw<std::uint8_t>();
        const double share = raw<std::uint16_t>() / 65535.0;
        if (kind < 100) return low + share * (high - low);
        if (kind < 160) return by_powers(share, low, high);
        if (kind < 190) return low;
        if (kind < 220) return high;
        if (kind < 226) return std::nextafter(low, -inf);
        if (kind < 232) return std::nextafter(high, inf);
        if (kind < 244) return special[kind - 232];
        return raw<double>();
    }
    /// Mostly in [low, high].
    template <class Integer>
    Integer integer(std::int64_t low, std::int64_t high) {
        const std::uint8_t kind = raw<std::uint8_t>();
        if (kind >= 250) return raw<Integer>();
        if (kind >= 240) return static_cast<Integer>(kind < 245 ? low - 1 : high + 1);
        if (kind >= 180) return static_cast<Integer>(kind < 210 ? low : high);
        return static_cast<Integer>(low + raw<std::uint16_t>() % (high - low + 1));
    }
    /// Mostly one of the first `count`.
    template <class Enum>
    Enum choice(int count) {
        const std::uint8_t byte = raw<std::uint8_t>();
        return static_cast<Enum>(byte >= 250 ? byte : byte % count);
    }

private:
    /// From the least size to the greatest that [low, high] holds, thirty powers of ten at most.
    static double by_powers(double share, double low, double high) {
        const double most = std::max(std::abs(low), std::abs(high));
        const double least = low > 0 ? low : most * 1e-30;
        const double size = least * std::pow(most / least, share);
        return high > 0 ? std::min(size, high) : -size;
    }

    std::span<const std::uint8_t> rest_;
};

}  // namespace aureole::fuzz
