// How far the host's geometry is from the camera at a pixel. Needs composite/inputs.glsl.
#ifndef AUREOLE_SCENE_DISTANCE_GLSL
#define AUREOLE_SCENE_DISTANCE_GLSL

// Along the pixel's ray, km; negative: nothing is there.
real scene_distance(ivec2 pixel, ViewRay ray) {
    if (!SCENE_DEPTH) return real(-1);
    real d = texelFetch(scene_depth, pixel, 0).x;
    real divisor = view.depth.z * d + view.depth.w;
    // The far end of the depth range is nothing; at infinity the divisor vanishes; 1e7 km is beyond any geometry.
    real depth = abs(divisor) > real(1e-12) ? (view.depth.x * d + view.depth.y) / divisor : real(-1);
    bool there = d != view.composite.z && depth > 0 && depth < real(1e7);
    return there ? depth * ray.stretch : real(-1);
}

#endif
