#include "host/host_shader.h"

namespace aureole::host {
namespace {

/// The shadows of host_lookups.comp.glsl.
constexpr const char* own_shadows = R"(
float shade(vec3 p) { return clamp(0.5 + 10.0 * (abs(fract(p.x / 20000.0) - 0.5) - 0.25), 0.0, 1.0); }
#define AUREOLE_SUN_VISIBILITY(offset_m) shade(offset_m)
)";

std::string header(const HostShader& shader) {
    std::string text = "#version 450\n#extension GL_GOOGLE_include_directive : require\n";
    text += shader.opengl ? "#define AUREOLE_PLAIN_GLSL\n" : "#define AUREOLE_SET " + std::to_string(shader.set) + "\n";
    text += "#define AUREOLE_DEFINED_CONSTANTS\n" + shader.defines;
    if (shader.first_slot != 0) {
        int slot = shader.first_slot;
        for (const char* name :
             {"AIR", "VIEW", "SKY_VIEW", "TRANSMITTANCE", "AERIAL_PERSPECTIVE", "LIGHT", "PHASES", "PROFILES"})
            text += std::string("#define AUREOLE_SLOT_") + name + " " + std::to_string(slot++) + "\n";
    }
    return text + (shader.shadows ? own_shadows : "") +
           "#include \"aureole.glsl\"\n#include \"aureole.glsl\"\n";  // a second time through another of the host's files
}

/// Words that the include uses inside: here they mean something else.
constexpr const char* own_names = R"(
const float PI = 3.0, SUN_COUNT = 17.0;
struct Ray { vec2 origin; };
struct AerialPerspective { float haze; };
vec3 sky_view_layer(float x) { return vec3(x); }
float bottom_radius() { return 1.0; }
float visible_share(Ray ray) { return ray.origin.x; }
#define real(x) (2.0 * (x))
#define SAMPLE 7
#define CONST 1
)";

constexpr const char* compute_main = R"(
layout(local_size_x = 64) in;
layout(constant_id = 5) const int COLUMNS = 10;  // ids are the host's own: the include takes none
layout(std430, set = 0, binding = 0) readonly buffer Questions { vec4 questions[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { vec4 answers[]; };

void main() {
    uint view = gl_GlobalInvocationID.x;
    if (3 * view >= questions.length()) return;
    vec4 ray = questions[3 * view], place = questions[3 * view + 1];
    vec3 atm = questions[3 * view + 2].xyz;
    int sun = int(place.z);
    AureoleAir air = aureole_aerial_perspective(place.x, place.y, ray.w, ray.xyz);
    AureoleBeam beam = aureole_march(sun, ray.xyz, place.w, ray.w, int(questions[3 * view + 2].w), fract(questions[3 * view + 2].w));
    uint at = COLUMNS * view;
    answers[at] = vec4(aureole_sky(ray.xyz), 1);
    answers[at + 1] = vec4(aureole_sky_transmittance(ray.xyz), 1);
    answers[at + 2] = vec4(air.transmittance, 1);
    answers[at + 3] = vec4(air.radiance, 1);
    answers[at + 4] = vec4(aureole_sun_transmittance(sun, atm), 1);
    answers[at + 5] = vec4(aureole_sun_irradiance(sun, atm), 1);
    answers[at + 6] = vec4(aureole_sky_irradiance(ray.xyz), 1);
    answers[at + 7] = vec4(beam.transmittance, 1);
    answers[at + 8] = vec4(beam.radiance, 1);
    answers[at + 9] = vec4(beam.loss, 1);
}
)";

constexpr const char* other_main = R"(
layout(location = 0) out vec4 result;
layout(location = 1) in vec3 direction;
void main() {
    AureoleAir air = aureole_aerial_perspective(0.5, 0.5, 100.0, direction);
    result.rgb = aureole_sky(direction) * aureole_sky_transmittance(direction) + air.transmittance + air.radiance;
    result.rgb += aureole_sun_transmittance(0, direction) + aureole_sun_irradiance(0, direction) + aureole_sky_irradiance(direction);
    AureoleBeam beam = aureole_march(0, direction, 0.0, 1000.0, 8, 0.25);
    result.rgb += beam.transmittance + beam.radiance + beam.loss;
    result.a = PI;
}
)";

}  // namespace

std::string text_of(const HostShader& shader) {
    std::string text = header(shader) + own_names + (shader.stage == "comp" ? compute_main : other_main);
    if (!shader.shadows)  // nothing to march with
        for (std::size_t at; (at = text.find("beam")) != std::string::npos;) {
            const std::size_t begin = text.rfind('\n', at);
            text.erase(begin, text.find('\n', at) - begin);
        }
    if (shader.stage == "comp") {
        if (shader.opengl)
            for (std::size_t at; (at = text.find("set = 0, ")) != std::string::npos;) text.erase(at, 9);
    }
    return text;
}

}  // namespace aureole::host
