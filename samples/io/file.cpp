#include "io/file.h"

#include <aureole/rhi/error.h>

#include <unistd.h>
#include <array>
#include <atomic>
#include <csignal>
#include <fstream>
#include <random>
#include <system_error>

namespace aureole::app {
namespace {

template <class Container>
Container read_whole(const std::filesystem::path& path, std::uint64_t most_bytes) {
    std::error_code problem;
    if (!std::filesystem::exists(path, problem)) throw Error(ErrorCode::io, path.string() + ": there is no such file");
    if (!std::filesystem::is_regular_file(path, problem)) throw Error(ErrorCode::io, path.string() + ": not a regular file");
    const std::uintmax_t size = std::filesystem::file_size(path, problem);
    if (problem) throw Error(ErrorCode::io, path.string() + ": cannot be read: " + problem.message());
    if (size > most_bytes)
        throw Error(ErrorCode::io, path.string() + ": size", std::to_string(size) + " bytes",
                    "at most " + std::to_string(most_bytes) + " bytes");
    Container bytes(static_cast<std::size_t>(size), {});
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream || stream.gcount() != static_cast<std::streamsize>(size))
        throw Error(ErrorCode::io, path.string() + ": cannot be read");
    return bytes;
}

/// Names of files on their way, for the handler of signals, which may neither lock nor allocate. Whoever takes a name out of
/// its slot owns it.
std::array<std::atomic<const char*>, 16> unfinished{};
static_assert(std::atomic<const char*>::is_always_lock_free);

/// The default action comes back with SA_RESETHAND: the program ends as it would have.
extern "C" void remove_unfinished(int signal) {
    for (std::atomic<const char*>& slot : unfinished)
        if (const char* name = slot.exchange(nullptr)) ::unlink(name);
    ::raise(signal);
}

void remember(const char* name) {
    remove_unfinished_on_signals();  // for every file: it costs nothing beside one
    for (std::atomic<const char*>& slot : unfinished) {
        const char* empty = nullptr;
        if (slot.compare_exchange_strong(empty, name)) return;
    }
    throw Error(ErrorCode::misuse, "too many files are being written at once");
}

/// A name that a handler in another thread has taken stays valid: this thread waits for the program's end.
void forget(const char* name) {
    for (std::atomic<const char*>& slot : unfinished) {
        const char* expected = name;
        if (slot.compare_exchange_strong(expected, nullptr)) return;
    }
    while (true) ::pause();
}

/// A name that no other process is writing to.
std::filesystem::path beside(const std::filesystem::path& path) {
    std::random_device random;
    return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(random()) + ".part");
}

}  // namespace

void remove_unfinished_on_signals() noexcept {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        struct sigaction action {};
        if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
        action.sa_handler = remove_unfinished;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
        ::sigaction(signal, &action, nullptr);
    }
}

std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
    return read_whole<std::vector<std::byte>>(path, most_bytes);
}

std::string read_text(const std::filesystem::path& path, std::uint64_t most_bytes) {
    return read_whole<std::string>(path, most_bytes);
}

NewFile::NewFile(std::filesystem::path path) : path_(std::move(path)), temporary_(beside(path_)) {
    std::error_code problem;
    if (path_.filename().empty() || std::filesystem::is_directory(path_, problem))
        throw Error(ErrorCode::io, path_.string() + ": is a folder, not the name of a file");
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, problem))
        throw Error(ErrorCode::io, path_.string() + ": cannot be written: there is no folder " + folder.string());
    remember(temporary_.c_str());
    // Made now, so that hours of work do not end at a folder that takes no files.
    if (std::ofstream(temporary_, std::ios::binary)) return;
    forget(temporary_.c_str());
    throw Error(ErrorCode::io, path_.string() + ": cannot be written");
}

NewFile::~NewFile() {
    std::error_code ignored;
    if (!committed_) std::filesystem::remove(temporary_, ignored);
    forget(temporary_.c_str());
}

void NewFile::commit() {
    std::error_code problem;
    std::filesystem::rename(temporary_, path_, problem);
    if (problem) throw Error(ErrorCode::io, path_.string() + ": cannot be written: " + problem.message());
    committed_ = true;
}

void write_text(const std::filesystem::path& path, std::string_view text) {
    NewFile file(path);
    std::ofstream stream(file.temporary(), std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) throw Error(ErrorCode::io, path.string() + ": cannot be written (is the disk full?)");
    file.commit();
}

}  // namespace aureole::app
