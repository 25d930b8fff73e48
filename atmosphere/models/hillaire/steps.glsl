// The two ways in which the published code steps along a ray of N steps: the medium is that at the point t, over the length dt.
#ifndef AUREOLE_HILLAIRE_STEPS_GLSL
#define AUREOLE_HILLAIRE_STEPS_GLSL

struct RayStep {
    real t, dt;
};

CONST(real, SAMPLE_POINT, real(0.3))  // of a step's cell

// Even: the tables of the air, and the froxels. t_i = (i + 0.3) / N of the whole, dt_i = t_i - t_(i-1): the medium stands at the end
// of each step, the first is 3/10 long, and the last 7/10 of a cell are left out.
RayStep even_step(real whole, int i, int steps) {
    RayStep s;
    s.t = whole * (real(i) + SAMPLE_POINT) / real(steps);
    s.dt = whole * (i == 0 ? SAMPLE_POINT : real(1)) / real(steps);
    return s;
}

// Growing: rays of the camera, by table or for each pixel. Cells between (i / N)^2 and ((i + 1) / N)^2 of the whole, the medium
// 3/10 into each.
RayStep growing_step(real whole, int i, int steps) {
    real scale = whole / (real(steps) * real(steps));
    real cell = real(2 * i + 1);
    RayStep s;
    s.t = scale * (real(i) * real(i) + SAMPLE_POINT * cell);
    s.dt = scale * cell;
    return s;
}

#endif
