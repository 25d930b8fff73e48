#version 430
// A diffuse surface under OGRE's light and ambient light, which Aureole has coloured. The second target holds the depth that Aureole
// is told of: reversed, of an infinite far plane.
uniform vec4 towards_sun;
uniform vec4 sun_irradiance;
uniform vec4 sky_irradiance;  // of a surface that looks up
uniform float near_m;
in vec3 world_normal;
in vec4 albedo_and_open_sky;
in float view_depth;
layout(location = 0) out vec4 radiance;
layout(location = 1) out float stored_depth;

void main() {
    vec3 n = normalize(world_normal);
    float facing_sun = max(dot(n, normalize(towards_sun.xyz)), 0.0);
    float facing_sky = 0.5 + 0.5 * n.y;
    vec3 irradiance = sun_irradiance.rgb * facing_sun + sky_irradiance.rgb * facing_sky * albedo_and_open_sky.a;
    radiance = vec4(albedo_and_open_sky.rgb * irradiance / radians(180.0), 1.0);
    stored_depth = near_m / view_depth;
}
