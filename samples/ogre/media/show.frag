#version 430
// The engine's own last step: exposure, a shoulder, the curve of sRGB, and noise of a step of 8 bits, so that the sky has no bands.
uniform sampler2D picture;
uniform float exposure;
in vec2 place;
out vec4 shown;

void main() {
    vec3 exposed = vec3(1.0) - exp(-exposure * texture(picture, place).rgb);
    vec3 dark = 12.92 * exposed, bright = 1.055 * pow(exposed, vec3(1.0 / 2.4)) - 0.055;
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));  // Jimenez 2014
    shown = vec4(mix(bright, dark, lessThan(exposed, vec3(0.0031308))) + (noise - 0.5) / 255.0, 1.0);
}
