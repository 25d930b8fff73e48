#include "io/npz.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <string_view>

namespace aureole::app {
namespace {

constexpr std::size_t most_values = std::size_t{1} << 28;
constexpr std::size_t most_dimensions = 32;  // NumPy's own limit, before version 2

struct Fault {
    const std::string& name;
    [[noreturn]] void operator()(const std::string& what) const {
        throw Error(ErrorCode::io, name + ": not a readable NumPy array: " + what);
    }
};

/// The text behind 'key': in the header, a Python dictionary of one line, e.g.
/// {'descr': '<i2', 'fortran_order': False, 'shape': (344, 403), }
std::string_view entry(std::string_view header, std::string_view key, const Fault& fault) {
    const std::string quoted = std::string("'").append(key).append("'");
    std::size_t at = header.find(quoted);
    if (at == std::string_view::npos) fault("its header has no " + std::string(key));
    at = header.find_first_not_of(" \n", at + quoted.size());
    if (at == std::string_view::npos || header[at] != ':') fault("its header has no value of " + std::string(key));
    at = header.find_first_not_of(" \n", at + 1);
    if (at == std::string_view::npos) fault("its header has no value of " + std::string(key));
    return header.substr(at);
}

std::vector<std::size_t> parse_shape(std::string_view text, const Fault& fault) {
    const std::size_t end = text.find(')');
    if (text.front() != '(' || end == std::string_view::npos) fault("its shape is no tuple");
    text = text.substr(1, end - 1);
    std::vector<std::size_t> shape;
    std::size_t total = 1;
    while (true) {
        const std::size_t first = text.find_first_not_of(' ');
        if (first == std::string_view::npos) return shape;  // () or behind the last comma
        text.remove_prefix(first);
        std::size_t length = 0;
        const auto [after, problem] = std::from_chars(text.data(), text.data() + text.size(), length);
        if (problem != std::errc()) fault("its shape holds what is no number");
        if (length > most_values || total * std::max<std::size_t>(length, 1) > most_values) fault("its shape is too large");
        total *= std::max<std::size_t>(length, 1);
        shape.push_back(length);
        if (shape.size() > most_dimensions) fault("its shape has more than 32 dimensions");
        text.remove_prefix(static_cast<std::size_t>(after - text.data()));
        const std::size_t comma = text.find_first_not_of(' ');
        if (comma == std::string_view::npos) return shape;
        if (text[comma] != ',') fault("its shape holds what is no number");
        text.remove_prefix(comma + 1);
    }
}

template <class T>
double decode(const std::byte* bytes, bool swapped) {
    std::byte copy[sizeof(T)];
    std::memcpy(copy, bytes, sizeof(T));
    if (swapped) std::reverse(std::begin(copy), std::end(copy));
    T value;
    std::memcpy(&value, copy, sizeof(T));
    return static_cast<double>(value);
}

struct Type {
    double (*decode)(const std::byte* bytes, bool swapped) = nullptr;
    std::size_t bytes = 0;
};
template <class T>
constexpr Type type{decode<T>, sizeof(T)};

/// `descr` without its byte order.
Type find_type(std::string_view descr, const Fault& fault) {
    static const std::map<std::string_view, Type> types{
        {"b1", type<std::uint8_t>},  {"i1", type<std::int8_t>},  {"u1", type<std::uint8_t>},  {"i2", type<std::int16_t>},
        {"u2", type<std::uint16_t>}, {"i4", type<std::int32_t>}, {"u4", type<std::uint32_t>}, {"i8", type<std::int64_t>},
        {"u8", type<std::uint64_t>}, {"f4", type<float>},        {"f8", type<double>}};
    const auto found = types.find(descr);
    if (found == types.end()) fault("its element type " + std::string(descr) + " is not one of b1 i1-i8 u1-u8 f4 f8");
    return found->second;
}

/// Index in C order of the element that stands at `position` in Fortran order.
std::size_t from_fortran(std::size_t position, const std::vector<std::size_t>& shape) {
    std::size_t index = 0, stride = 1;
    for (const std::size_t length : shape) stride *= length;
    for (const std::size_t length : shape) {
        stride /= length;
        index += position % length * stride;
        position /= length;
    }
    return index;
}

struct Layout {
    std::string_view header;
    std::size_t data = 0;  ///< Where the elements start.
};

Layout find_header(std::span<const std::byte> bytes, const Fault& fault) {
    if (bytes.size() < 10 || std::memcmp(bytes.data(), "\x93NUMPY", 6) != 0) fault("it does not start as one");
    const auto byte = [&](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
    const std::size_t version = byte(6);
    if (version < 1 || version > 3) fault("its format version is not 1, 2 or 3");
    if (version > 1 && bytes.size() < 12) fault("it ends in its header");
    const std::size_t start = version == 1 ? 10 : 12;
    const std::size_t length = version == 1 ? byte(8) | byte(9) << 8 : byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24;
    if (length > bytes.size() - start) fault("it ends in its header");
    return {{reinterpret_cast<const char*>(bytes.data()) + start, length}, start + length};
}

}  // namespace

NpyArray parse_npy(std::span<const std::byte> bytes, const std::string& name) {
    const Fault fault{name};
    const Layout layout = find_header(bytes, fault);

    std::string_view descr = entry(layout.header, "descr", fault);
    const std::size_t quote = descr.size() > 1 ? descr.find('\'', 1) : std::string_view::npos;
    if (descr.front() != '\'' || quote == std::string_view::npos || quote < 2) fault("its element type is no simple one");
    const char order = descr[1];
    if (std::string_view("<>|=").find(order) == std::string_view::npos) fault("its byte order is none of < > | =");
    const Type element = find_type(descr.substr(2, quote - 2), fault);
    const bool swapped = (order == '>' && std::endian::native == std::endian::little) ||
                         (order == '<' && std::endian::native == std::endian::big);

    const std::string_view fortran_text = entry(layout.header, "fortran_order", fault);
    const bool fortran = fortran_text.starts_with("True");
    if (!fortran && !fortran_text.starts_with("False")) fault("its fortran_order is neither True nor False");

    NpyArray array{parse_shape(entry(layout.header, "shape", fault), fault), {}};
    std::size_t count = 1;
    for (const std::size_t length : array.shape) count *= length;
    const std::size_t expected = count * element.bytes, found = bytes.size() - layout.data;
    if (found != expected)
        fault("it holds " + std::to_string(found) + " bytes where its shape needs " + std::to_string(expected));

    array.values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        array.values[fortran ? from_fortran(i, array.shape) : i] =
            element.decode(bytes.data() + layout.data + i * element.bytes, swapped);
    return array;
}

}  // namespace aureole::app
