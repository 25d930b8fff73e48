// FNV-1a: the same for the same bytes on every machine, another one for others (no defence against anybody).
#pragma once

#include <cstdint>
#include <string_view>

namespace aureole::app {

class Fnv1a {
public:
    void add(std::string_view text) {
        for (const char c : text) add_byte(static_cast<unsigned char>(c));
    }
    /// The least significant byte first.
    void add(std::uint64_t bits) {
        for (int shift = 0; shift < 64; shift += 8) add_byte(bits >> shift & 0xff);
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    void add_byte(std::uint64_t byte) { value_ = (value_ ^ byte) * 0x100000001b3; }
    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace aureole::app
