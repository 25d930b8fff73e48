// Slices of the volumes over the screen: slice k of n lies at the distance last (k / (n - 1))^2, from 0 at the camera.
#ifndef AUREOLE_SLICES_GLSL
#define AUREOLE_SLICES_GLSL

// Position of a distance, `share` of the last slice's. Were it just the square root, near geometry would be behind up to
// last / (4 (n - 1)^2) of air too much: 25 m by default.
real slice_position(real share, int slices) {
    real last = real(slices - 1);
    real slice = min(floor(sqrt(share) * last), last - 1);
    return (slice + (share * last * last - slice * slice) / (2 * slice + 1)) / last;
}

#endif
