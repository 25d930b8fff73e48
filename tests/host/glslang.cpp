#include "host/glslang.h"

#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace aureole::host {
namespace {

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

Compiled compile(const std::string& text, const std::string& stage, Api api) {
    const ScratchFolder folder;
    const std::string source = folder.path() / ("host." + stage), output = folder.path() / "host.spv",
                      log = folder.path() / "host.log";
    std::ofstream(source, std::ios::binary) << text;
    const std::string target = api == Api::vulkan ? "-V --target-env vulkan1.1" : "-G --target-env opengl";
    const std::string command = std::string("\"") + AUREOLE_GLSLANG + "\" " + target + " -S " + stage + " -I\"" +
                                AUREOLE_GLSL_DIR + "\" -o " + output + " " + source + " > " + log + " 2>&1";
    const int status = std::system(command.c_str());
    Compiled compiled;
    compiled.messages = read_file(log);
    const std::string bytes = status == 0 ? read_file(output) : "";
    REQUIRE(bytes.size() % sizeof(std::uint32_t) == 0);
    compiled.spirv.resize(bytes.size() / sizeof(std::uint32_t));
    if (!bytes.empty()) std::memcpy(compiled.spirv.data(), bytes.data(), bytes.size());
    return compiled;
}

}  // namespace aureole::host
