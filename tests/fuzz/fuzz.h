// What the programs of this folder share: each gives one reader bytes from anywhere. A reader reads, or throws Error; all else
// (another exception, a crash, a hang, memory without end) is a fault of the reader. docs/fuzzing.md.
#pragma once

#include <aureole/rhi/error.h>

#include "scratch_folder.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

/// One run of the program's reader. By libFuzzer, or by replay.cpp, which gives it what is kept in corpus/.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace aureole::fuzz {

inline void require(bool true_statement, const std::string& statement) {
    if (true_statement) return;
    std::fprintf(stderr, "not so: %s\n", statement.c_str());
    std::abort();
}

/// True if `reader` ends; false if it throws Error, which must say something. Other exceptions go on and end the program.
template <class Reader>
bool accepts(Reader&& reader) {
    try {
        reader();
    } catch (const Error& error) {
        require(error.what()[0] != '\0', "an Error has a message");
        return false;
    }
    return true;
}

/// For values: what is rejected is named, with the value and what is allowed. A device that lacks something names it.
template <class Reader>
bool accepts_value(Reader&& reader) {
    try {
        reader();
    } catch (const Error& error) {
        const std::string said = std::string("\"") + error.what() + "\" names field, value and allowed range";
        require(error.code() == ErrorCode::invalid_argument || error.code() == ErrorCode::unsupported, said);
        require(!error.field().empty() && !error.value().empty() && !error.allowed().empty(), said);
        return false;
    }
    return true;
}

/// The bytes as a file of this name, in a folder that goes with the program.
inline std::filesystem::path file_of(const std::uint8_t* data, std::size_t size, const char* name) {
    static const ScratchFolder folder;
    std::filesystem::path path = folder.path() / name;
    std::filesystem::remove(path);  // some file systems write a file that is truncated and filled again through to the disk
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    stream.close();
    require(stream.good(), "a file of " + std::to_string(size) + " bytes can be written to " + path.string());
    return path;
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

}  // namespace aureole::fuzz
