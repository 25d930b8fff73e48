#include "states.h"

#include <doctest/doctest.h>

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
