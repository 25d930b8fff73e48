// Reading and writing whole files. What is written appears complete under its name or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// Throws Error(io) if the file cannot be read or is larger than `most_bytes`.
[[nodiscard]] std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t most_bytes = 1ull << 31);
[[nodiscard]] std::string read_text(const std::filesystem::path& path, std::uint64_t most_bytes = 1ull << 31);

/// Each of these signals that would end the program as it is removes NewFile's files first, from here on. What every NewFile
/// does; for handlers of the program's own that give a signal back to the system. May be called by a handler.
void remove_unfinished_on_signals() noexcept;

/// A file on its way: written under `temporary()` in the same folder, it gets its name in `commit()`. Without that, whatever
/// has been written is removed again, also when SIGHUP, SIGINT or SIGTERM ends the program (unless the program has a handler of
/// its own for it, which then has the say).
class NewFile {
public:
    /// Throws Error(io) if the folder does not exist or takes no files.
    explicit NewFile(std::filesystem::path path);
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    [[nodiscard]] const std::filesystem::path& temporary() const noexcept { return temporary_; }
    /// Throws Error(io); the old file, if there was one, then stays.
    void commit();

private:
    std::filesystem::path path_, temporary_;
    bool committed_ = false;
};

/// Throws Error(io).
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace aureole::app
