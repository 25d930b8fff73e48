#include "host/questions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <sstream>
#include <string>

#include "aureole_host_lookups_shaders.h"

namespace aureole::host {
namespace {

constexpr AnswerPart parts[] = {{"sky", &Answer::sky},
                                {"sky transmittance", &Answer::sky_transmittance},
                                {"air transmittance", &Answer::air_transmittance},
                                {"air radiance", &Answer::air_radiance},
                                {"sun transmittance", &Answer::sun_transmittance},
                                {"sun irradiance", &Answer::sun_irradiance},
                                {"sky irradiance", &Answer::sky_irradiance},
                                {"march transmittance", &Answer::march_transmittance},
                                {"march radiance", &Answer::march_radiance, 2e-5},
                                {"march loss", &Answer::march_loss, 2e-5}};
static_assert(std::size(parts) == answer_columns);

}  // namespace

std::span<const AnswerPart> answer_parts() { return parts; }

std::vector<glm::dvec4> encode(std::span<const Question> questions) {
    std::vector<glm::dvec4> texels;
    for (const Question& q : questions) {
        texels.emplace_back(q.direction, q.distance_m);
        texels.emplace_back(q.place, q.sun, q.begin_m);
        texels.emplace_back(q.offset_m, q.samples + q.jitter);
    }
    return texels;
}

std::vector<Answer> decode(std::span<const glm::dvec4> texels) {
    REQUIRE(texels.size() % answer_columns == 0);
    std::vector<Answer> answers(texels.size() / answer_columns);
    for (std::size_t i = 0; i < texels.size(); ++i)
        answers[i / answer_columns].*(parts[i % answer_columns].value) = Rgb(texels[i]);
    return answers;
}

std::vector<rhi::Specialization> specialization_of(const View& view) {
    std::vector<rhi::Specialization> values;
    std::istringstream lines(view.shader_defines());
    std::string define, name;
    const std::string prefix = "AUREOLE_SPEC_";
    for (int value = 0; lines >> define >> name >> value;) {
        REQUIRE(define == "#define");
        REQUIRE(name.substr(0, prefix.size()) == prefix);
        values.push_back(
            {static_cast<std::uint32_t>(std::stoul(name.substr(prefix.size()))), static_cast<std::uint32_t>(value)});
    }
    REQUIRE(lines.eof());
    return values;
}

std::vector<Answer> ask(passes::Rig& rig, std::span<const Question> questions) {
    rhi::Device& device = rig.backend.device();
    const auto count = static_cast<std::uint32_t>(questions.size());
    const rhi::Texture asked = rig.backend.make("questions", rhi::Format::rgba32_float, {{3, count, 1}, encode(questions)});
    const rhi::Texture answers =
        rig.backend.make_target(rhi::Format::rgba32_float, {answer_columns, count, 1}, rhi::State::storage_write);
    const std::vector<rhi::Specialization> specialization = rig.view.shader_constants();
    const rhi::Shader& shader = shaders::host_lookups;
    const rhi::Pipeline pipeline = device.create_compute_pipeline({"host_lookups", &shader, specialization});
    const rhi::Sampler linear = device.create_sampler({rhi::Filter::linear});
    const rhi::Sampler nearest = device.create_sampler({rhi::Filter::nearest});
    const rhi::Binding bindings[] = {{0, {}, {}, rig.view.air_block()},
                                     {1, {}, {}, rig.view.view_block()},
                                     {2, rig.view.sky_view_table(), linear, {}},
                                     {3, rig.air.transmittance_table(), linear, {}},
                                     {4, rig.view.aerial_perspective_table(), linear, {}},
                                     {5, rig.view.light_table(), linear, {}},
                                     {6, rig.view.phase_table(), nearest, {}},
                                     {7, rig.view.profile_table(), nearest, {}},
                                     {8, asked, nearest, {}},
                                     {9, answers, {}, {}}};
    const rhi::BindingSet set = device.create_binding_set({"host_lookups", pipeline, bindings});
    rig.backend.run([&](rhi::CommandList& commands) {
        rhi::DispatchDesc dispatch;
        dispatch.pipeline = pipeline;
        dispatch.bindings = set;
        dispatch.groups[0] = (count + shader.local_size[0] - 1) / shader.local_size[0];
        commands.dispatch(dispatch);
    });
    std::vector<Answer> result = decode(rig.backend.read(answers, rhi::State::storage_write).texels);
    for (const rhi::AnyHandle handle :
         {rhi::AnyHandle(set), rhi::AnyHandle(nearest), rhi::AnyHandle(linear), rhi::AnyHandle(pipeline)})
        device.destroy(handle, 0);
    return result;
}

std::vector<glm::dvec3> sphere(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {  // a spiral of equal areas, a golden angle a step
        const double z = 1 - (2 * i + 1.0) / count;
        const double angle = 2 * std::numbers::pi * i * (std::numbers::phi - 1);
        const double across = std::sqrt(1 - z * z);
        directions.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
    }
    return directions;
}

std::vector<Question> assorted(int count, int suns) {
    std::vector<Question> questions;
    const std::vector<glm::dvec3> directions = sphere(count);
    for (int i = 0; i < count; ++i) {
        Question q;
        q.direction = directions[static_cast<std::size_t>(i)];
        q.distance_m = std::pow(10.0, 6.0 * i / count);
        q.place = {std::fmod(0.618 * i, 1.0), std::fmod(0.377 * i, 1.0)};
        q.sun = i % suns;
        q.begin_m = q.distance_m * (i % 3) / 4;
        q.samples = 1 + i % 5;
        q.jitter = 0.125 * (i % 7);
        const double reach = std::pow(10.0, 5.3 * std::fmod(0.271 * i, 1.0));
        q.offset_m = reach * directions[static_cast<std::size_t>((7 * i) % count)];
        questions.push_back(q);
    }
    return questions;
}

Question pixel_question(const Camera& camera, rhi::Extent target, std::uint32_t x, std::uint32_t y) {
    Question q;
    q.place = {(x + 0.5) / target.width, (y + 0.5) / target.height};
    const double up = camera.row_order == RowOrder::top_first ? 1 - 2 * q.place.y : 2 * q.place.y - 1;
    const glm::dvec3 in_view((2 * q.place.x - 1) / camera.projection[0][0], up / camera.projection[1][1], -1);
    q.direction = glm::normalize(glm::transpose(glm::dmat3(camera.view)) * in_view);
    return q;
}

}  // namespace aureole::host
