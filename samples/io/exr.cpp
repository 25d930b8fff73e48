#include "io/exr_header.h"
#include "io/file.h"
#include "io/image.h"

#include <aureole/rhi/error.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/openexr.h>
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace aureole::app {
namespace {

std::string height_channel(const Imf::ChannelList& channels, const std::string& file) {
    std::string only, all;
    int count = 0;
    for (auto c = channels.begin(); c != channels.end(); ++c, ++count) {
        only = c.name();
        all.append(all.empty() ? "" : ", ").append(c.name());
    }
    for (const char* name : {"Y", "R"})
        if (channels.findChannel(name)) return name;
    if (count == 1) return only;
    throw Error(ErrorCode::invalid_argument, file + ": channels of the EXR", all.empty() ? "none" : all,
                "Y, R, or a single channel");
}

/// The header alone, by OpenEXR's core library, which compares it with the file's length: the C++ reader behind it asks for as
/// many lines as the header promises.
Imath::Box2i data_window(const std::filesystem::path& path) {
    struct Context {
        ~Context() { exr_finish(&file); }
        exr_context_t file = nullptr;
    } context;
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};  // by default they are printed
    exr_attr_box2i_t window{};
    exr_result_t result = exr_start_read(&context.file, path.c_str(), &settings);
    if (result == EXR_ERR_SUCCESS) result = exr_get_data_window(context.file, 0, &window);
    if (result != EXR_ERR_SUCCESS) throw std::runtime_error(exr_get_default_error_message(result));
    return {{window.min.x, window.min.y}, {window.max.x, window.max.y}};
}

}  // namespace

GreyImage read_exr_grey(const std::filesystem::path& path) {
    try {
        check_exr_header(read_file(path));  // which says in our words what is wrong with the name
        const Imath::Box2i window = data_window(path);
        const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
        const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
        check_grey_size(path, static_cast<std::uint64_t>(std::max<std::int64_t>(width, 0)),
                        static_cast<std::uint64_t>(std::max<std::int64_t>(height, 0)));
        Imf::InputFile file(path.c_str());
        if (!file.isComplete()) throw std::runtime_error("the file ends too early");
        const std::string channel = height_channel(file.header().channels(), path.string());
        if (const Imf::Channel& c = file.header().channels()[channel.c_str()]; c.xSampling != 1 || c.ySampling != 1)
            throw Error(ErrorCode::invalid_argument, path.string() + ": sampling of channel " + channel, "subsampled",
                        "a value a pixel");

        GreyImage image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
        image.values.resize(static_cast<std::size_t>(width * height));
        Imf::FrameBuffer buffer;
        buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, image.values.data(), window, sizeof(float),
                                                sizeof(float) * static_cast<std::size_t>(width)));
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(ErrorCode::io, path.string() + ": not a readable EXR: " + problem.what());
    }
}

void write_exr(const std::filesystem::path& path, const LinearImage& image) {
    NewFile out(path);
    // Ours, since OpenEXR's files swallow what goes wrong while they are closed.
    std::ofstream stream(out.temporary(), std::ios::binary);
    try {
        Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer buffer;
        const char* names[] = {"R", "G", "B"};
        const std::size_t pixel = 3 * sizeof(float);
        for (std::size_t c = 0; c < 3; ++c) {
            header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
            // OpenEXR takes the same non-const pointer for reading and writing.
            char* first = reinterpret_cast<char*>(const_cast<float*>(image.rgb.data() + c));
            buffer.insert(names[c], Imf::Slice(Imf::FLOAT, first, pixel, pixel * image.width));
        }
        {
            Imf::StdOFStream target(stream, path.c_str());
            Imf::OutputFile file(target, header);
            file.setFrameBuffer(buffer);
            file.writePixels(static_cast<int>(image.height));
        }  // its destructor writes the table of lines
    } catch (const std::exception& problem) {
        throw Error(ErrorCode::io, path.string() + ": cannot be written: " + problem.what());
    }
    stream.close();
    if (!stream) throw Error(ErrorCode::io, path.string() + ": cannot be written (is the disk full?)");
    out.commit();
}

}  // namespace aureole::app
