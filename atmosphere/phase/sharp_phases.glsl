// Which phase functions are kept out of a table's first layer, and in which layer the light that they scatter stands.
#ifndef AUREOLE_SHARP_PHASES_GLSL
#define AUREOLE_SHARP_PHASES_GLSL

SPEC_INT(5, SHARP_PHASES, 0)  // bit c: phase function c is kept out of layer 0

bool phase_is_sharp(int c) { return ((SHARP_PHASES >> c) & 1) != 0; }
// Of a sun's layers the one that holds phase function c, which is sharp; for c = MAX_PHASES how many layers a sun has.
int sharp_layer(int c) {
    int before = SHARP_PHASES & ((1 << c) - 1);
    return 1 + (before & 1) + ((before >> 1) & 1) + ((before >> 2) & 1) + ((before >> 3) & 1);
}

#endif
