#include "states.h"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace aureole;
using namespace aureole::vulkan;
using rhi::State;

namespace {
constexpr State all_states[] = {State::undefined,        State::sampled,          State::depth_read,
                                State::storage_write,    State::color_attachment, State::copy_source,
                                State::copy_destination, State::constants,        State::general};
}

TEST_CASE("no state of a queue without graphics waits for graphics stages") {
    const VkPipelineStageFlags compute_stages = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT |
                                                VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    for (const State state : all_states) {
        if (state == State::color_attachment) continue;
        CAPTURE(rhi::to_string(state));
        CHECK((access_of(state, false).stages & ~compute_stages) == 0);
    }
    CHECK((access_of(State::sampled, true).stages & VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT) != 0);
}

TEST_CASE("states that write say so, states that read do not write") {
    for (const State state : {State::storage_write, State::color_attachment, State::copy_destination, State::general})
        CHECK(access_of(state, true).writes != 0);
    for (const State state : {State::sampled, State::depth_read, State::copy_source, State::constants}) {
        CHECK(access_of(state, true).writes == 0);
        CHECK(access_of(state, true).reads != 0);
    }
}

TEST_CASE("shaders read a texture in one layout, whatever the state is called") {
    for (const VkImageLayout layout :
         {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL})
        for (const State state : {State::sampled, State::depth_read}) CHECK(access_of(state, true, layout).layout == layout);
    CHECK(access_of(State::storage_write, true).layout == VK_IMAGE_LAYOUT_GENERAL);
    CHECK(access_of(State::copy_source, true).layout == VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

namespace {

/// The cells of a table's row.
std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> all;
    std::istringstream stream(row.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');) all.push_back(cell);
    return all;
}

/// The bits named between backticks.
VkFlags bits(const std::string& cell, const std::map<std::string, VkFlags>& names) {
    VkFlags sum = 0;
    for (std::size_t begin = cell.find('`'); begin != std::string::npos; begin = cell.find('`', begin + 1)) {
        const std::size_t end = cell.find('`', begin + 1);
        const std::string name = cell.substr(begin + 1, end - begin - 1);
        CAPTURE(name);
        REQUIRE(names.contains(name));
        sum |= names.at(name);
        begin = end;
    }
    return sum;
}

}  // namespace

TEST_CASE("the table of states on the integration page is what barriers do") {
    const std::map<std::string, VkFlags> layouts{
        {"UNDEFINED", VK_IMAGE_LAYOUT_UNDEFINED},
        {"SHADER_READ_ONLY_OPTIMAL", VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
        {"DEPTH_STENCIL_READ_ONLY_OPTIMAL", VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL},
        {"GENERAL", VK_IMAGE_LAYOUT_GENERAL},
        {"COLOR_ATTACHMENT_OPTIMAL", VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
        {"TRANSFER_SRC_OPTIMAL", VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
        {"TRANSFER_DST_OPTIMAL", VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL}};
    const std::map<std::string, VkFlags> stages{{"COMPUTE_SHADER", VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT},
                                                {"FRAGMENT_SHADER", VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT},
                                                {"COLOR_ATTACHMENT_OUTPUT", VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT},
                                                {"TRANSFER", VK_PIPELINE_STAGE_TRANSFER_BIT},
                                                {"ALL_COMMANDS", VK_PIPELINE_STAGE_ALL_COMMANDS_BIT}};
    const std::map<std::string, VkFlags> accesses{{"SHADER_READ", VK_ACCESS_SHADER_READ_BIT},
                                                  {"SHADER_WRITE", VK_ACCESS_SHADER_WRITE_BIT},
                                                  {"TRANSFER_READ", VK_ACCESS_TRANSFER_READ_BIT},
                                                  {"TRANSFER_WRITE", VK_ACCESS_TRANSFER_WRITE_BIT},
                                                  {"MEMORY_READ", VK_ACCESS_MEMORY_READ_BIT},
                                                  {"MEMORY_WRITE", VK_ACCESS_MEMORY_WRITE_BIT},
                                                  {"COLOR_ATTACHMENT_WRITE", VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT}};

    std::map<std::string, std::vector<std::string>> rows;  // by state
    std::ifstream page(AUREOLE_INTEGRATION_PAGE);
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| `")) continue;
        const std::vector<std::string> row = cells(line);
        if (row.size() == 5) rows[row[0].substr(2, row[0].size() - 4)] = row;
    }
    for (const State state : all_states) {
        if (state == State::constants) continue;  // of buffers alone
        const std::string name = rhi::to_string(state);
        CAPTURE(name);
        REQUIRE(rows.contains(name));
        const std::vector<std::string>& row = rows[name];
        // As TextureObject::read_layout chooses for a texture lent in this state.
        const StateAccess access = access_of(state, true,
                                             state == State::depth_read ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                                                        : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        CHECK(bits(row[1], layouts) == static_cast<VkFlags>(access.layout));
        CHECK(bits(row[3], stages) == (state == State::undefined ? 0 : access.stages));
        CHECK(bits(row[4], accesses) == (access.reads | access.writes));
    }
}
