// Grey OpenEXR pictures.
#include "fuzz.h"

#include "io/image.h"

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::filesystem::path path = fuzz::file_of(data, size, "map.exr");
    fuzz::accepts([&] {
        const app::GreyImage image = app::read_exr_grey(path);
        fuzz::require(image.values.size() == std::size_t{image.width} * image.height, "a picture is as large as it says");
    });
    return 0;
}
