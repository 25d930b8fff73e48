// NumPy arrays by themselves and in archives; height maps in them.
#include "fuzz.h"

#include "io/height_map.h"
#include "io/npz.h"

#include <span>

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    fuzz::accepts([&] {
        const app::NpyArray array = app::parse_npy(bytes, "array");
        std::size_t count = 1;
        for (const std::size_t length : array.shape) count *= length;
        fuzz::require(count == array.values.size(), "an array is as large as its shape");
    });
    if (size < 4 || data[0] != 'P') return 0;  // of no archive there is more to read
    const std::filesystem::path path = fuzz::file_of(data, size, "map.npz");
    fuzz::accepts([&] {
        const app::NpzFile file(path);
        for (const std::string& name : file.names()) fuzz::accepts([&] { (void)file.read(name); });
    });
    fuzz::accepts([&] { (void)app::read_height_map(path, {}); });
    return 0;
}
