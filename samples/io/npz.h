// NumPy arrays: .npy texts, and the .npz archives that hold them. The archive is libzip's; an array's format is read here,
// because the libraries at hand trust headers and lengths that a broken file gets wrong.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// Numbers in C order (the last index runs fastest), whatever order the file had.
struct NpyArray {
    std::vector<std::size_t> shape;  ///< Empty: a single number.
    std::vector<double> values;
};

/// Format versions 1 to 3; integers of 1 to 8 bytes, floats of 4 or 8, bools; both byte orders. Anything else, and what is too
/// short or too long, throws Error(io) that starts with `name`.
[[nodiscard]] NpyArray parse_npy(std::span<const std::byte> bytes, const std::string& name);

/// An .npz archive, open for reading.
class NpzFile {
public:
    /// Throws Error(io).
    explicit NpzFile(const std::filesystem::path& path);
    ~NpzFile();
    NpzFile(const NpzFile&) = delete;
    NpzFile& operator=(const NpzFile&) = delete;

    /// Names of the arrays, without ".npy".
    [[nodiscard]] const std::vector<std::string>& names() const noexcept;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Unpacks and parses one array. Throws Error(io); also if there is none of that name.
    [[nodiscard]] NpyArray read(const std::string& name) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aureole::app
