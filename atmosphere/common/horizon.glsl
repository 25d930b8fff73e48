// A direction, by the cosine and sine of its zenith angle, against the camera's horizon. Needs `view`.
#ifndef AUREOLE_HORIZON_GLSL
#define AUREOLE_HORIZON_GLSL

// Sine of the angle by which it lies above the ground's horizon.
real sine_above_horizon(real mu, real sine) { return mu * view.horizon.x + sine * view.horizon.y; }

// Chord between it and the horizon below or above it, 2 sin(angle / 2): with the direction's parts (sine, mu) and the horizon's
// (cos dip, -sin dip). Costs no inverse trigonometry, and is exact at the horizon.
real chord_to_horizon(real mu, real sine) {
    real across = sine - view.horizon.x;
    real along = mu + view.horizon.y;
    return sqrt(across * across + along * along);
}

#endif
