#include "io/file.h"
#include "io/image.h"

#include <aureole/rhi/error.h>

#include <png.h>
#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <string>

namespace aureole::app {
namespace {

/// Bytes that one byte of a deflated stream can hold: a header that promises more is not worth the memory. (A packed row of
/// 1-bit pixels holds eight in a byte.)
constexpr std::size_t most_deflated = 1032 * 8;

/// What libpng's callbacks see. libpng leaves by longjmp, so nothing with a destructor lives in the functions that it leaves.
struct Source {
    const std::vector<std::byte>* bytes = nullptr;
    std::size_t position = 0;
    std::string problem;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    static_cast<Source*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep data, std::size_t count) {
    Source& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.bytes->size() - source.position) png_error(png, "the file ends too early");
    std::memcpy(data, source.bytes->data() + source.position, count);
    source.position += count;
}

struct Header {
    png_uint_32 width = 0, height = 0;
    int bits = 0, color = 0;
};

/// False with source.problem set if the file is broken.
bool read_header(png_structp png, png_infop info, Source& source, Header& header) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, &source, on_read);
    // Texts, colour profiles and the like are passed over: libpng would make room for as much as each says that it holds.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png, info);
    png_get_IHDR(png, info, &header.width, &header.height, &header.bits, &header.color, nullptr, nullptr, nullptr);
    return true;
}

bool read_rows(png_structp png, png_infop info, const Header& header, std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    if (header.bits < 8) png_set_expand_gray_1_2_4_to_8(png);
    png_read_update_info(png, info);
    png_read_image(png, rows.data());
    png_read_end(png, nullptr);
    return true;
}

struct Reader {
    explicit Reader(Source& source)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (!info) {
            png_destroy_read_struct(&png, &info, nullptr);
            throw Error(ErrorCode::out_of_memory, "libpng could not be started");
        }
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    png_structp png;
    png_infop info;
};

}  // namespace

GreyImage read_png_grey(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    Source source{&bytes, 0, {}};
    const auto fail = [&]() { return Error(ErrorCode::io, path.string() + ": not a readable PNG: " + source.problem); };
    Reader reader(source);
    Header header;
    if (!read_header(reader.png, reader.info, source, header)) throw fail();
    if (header.color != PNG_COLOR_TYPE_GRAY)
        throw Error(ErrorCode::invalid_argument, path.string() + ": colours of the PNG", "a palette, colour or transparency",
                    "greyscale with 8 or 16 bits");
    check_grey_size(path, header.width, header.height);

    const std::size_t channel_bytes = header.bits == 16 ? 2 : 1;
    const std::size_t pixel_bytes = std::size_t{header.width} * header.height * channel_bytes;
    if (pixel_bytes / most_deflated > bytes.size()) {
        source.problem = "the file ends too early";
        throw fail();
    }
    std::vector<png_byte> pixels(pixel_bytes);
    std::vector<png_bytep> rows(header.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * header.width * channel_bytes;
    if (!read_rows(reader.png, reader.info, header, rows)) throw fail();

    GreyImage image{header.width, header.height, {}};
    image.values.resize(std::size_t{header.width} * header.height);
    for (std::size_t i = 0; i < image.values.size(); ++i)
        image.values[i] = channel_bytes == 2 ? static_cast<float>(pixels[2 * i] * 256 + pixels[2 * i + 1])  // big-endian
                                             : static_cast<float>(pixels[i]);
    return image;
}

void write_png(const std::filesystem::path& path, const DisplayImage& image) {
    NewFile file(path);
    png_image description{};
    description.version = PNG_IMAGE_VERSION;
    description.width = image.width;
    description.height = image.height;
    description.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&description, file.temporary().c_str(), 0, image.rgb.data(), 0, nullptr))
        throw Error(ErrorCode::io, path.string() + ": cannot be written: " + description.message);
    file.commit();
}

std::vector<std::byte> encode_png(const LinearImage& image) {
    constexpr float most = 65535;
    std::vector<std::uint16_t> linear;
    for (const float value : image.rgb)
        linear.push_back(static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * most)));
    png_image description{};
    description.version = PNG_IMAGE_VERSION;
    description.width = image.width;
    description.height = image.height;
    description.format = PNG_FORMAT_LINEAR_RGB;
    std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(description));
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&description, bytes.data(), &size, 1, linear.data(), 0, nullptr))
        throw Error(ErrorCode::internal, std::string("a picture cannot become a PNG: ") + description.message);
    bytes.resize(size);
    return bytes;
}

}  // namespace aureole::app
