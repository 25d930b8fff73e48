// Light of three wavelengths in the places of red, green and blue, as linear Rec.709: the columns of a triplet's matrix M_k / E
// (models/spectral/spectral_sum.glsl), times the light.
#ifndef AUREOLE_TO_REC709_GLSL
#define AUREOLE_TO_REC709_GLSL

vec3 to_rec709(vec3 light, vec4 first, vec4 second, vec4 third) {
    return light.x * vec3(first) + light.y * vec3(second) + light.z * vec3(third);
}

#endif
