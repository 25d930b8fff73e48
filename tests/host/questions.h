// Questions to the look-ups of host/aureole.glsl, and their answers on any backend.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "passes/rig.h"

namespace aureole::host {

struct Question {
    glm::dvec3 direction{0, 0, 1};  ///< Unit; also the normal for the sky's irradiance.
    double distance_m = 0;
    glm::dvec2 place{0.5, 0.5};  ///< On the target.
    int sun = 0;
    glm::dvec3 offset_m{0, 0, 0};
    double begin_m = 0;   ///< Of the march, which ends at the distance.
    int samples = 4;      ///< Of the march.
    double jitter = 0.5;  ///< Of its samples, in [0, 1).
};

/// In the order of the columns of host_lookups.comp.glsl.
struct Answer {
    Rgb sky, sky_transmittance, air_transmittance, air_radiance, sun_transmittance, sun_irradiance, sky_irradiance;
    Rgb march_transmittance, march_radiance, march_loss;
};
inline constexpr std::size_t answer_columns = 10;
static_assert(sizeof(Answer) == answer_columns * sizeof(Rgb));

/// The members by name, for messages and loops.
struct AnswerPart {
    const char* name;
    Rgb Answer::*value;
    double floor = 1e-6;  ///< Of the largest, that backends may differ by.
};
[[nodiscard]] std::span<const AnswerPart> answer_parts();

/// Four floats a texel, three texels a question: what the test kernel and the host's own shader read.
[[nodiscard]] std::vector<glm::dvec4> encode(std::span<const Question> questions);
/// From `answer_columns` texels an answer.
[[nodiscard]] std::vector<Answer> decode(std::span<const glm::dvec4> texels);

/// Runs host_lookups.comp.glsl on the rig's tables as they were last recorded.
[[nodiscard]] std::vector<Answer> ask(passes::Rig& rig, std::span<const Question> questions);

/// View::shader_defines() as values for a pipeline.
[[nodiscard]] std::vector<rhi::Specialization> specialization_of(const View& view);

/// `count` directions, evenly over the sphere.
[[nodiscard]] std::vector<glm::dvec3> sphere(int count);
/// A little of everything: directions all around with distances, places and offsets of many sizes, suns in turn.
[[nodiscard]] std::vector<Question> assorted(int count, int suns);

/// The ray of a pixel of a perspective camera, found by inverting its matrices.
[[nodiscard]] Question pixel_question(const Camera& camera, rhi::Extent target, std::uint32_t x, std::uint32_t y);

}  // namespace aureole::host
