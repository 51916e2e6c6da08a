// All surfaces of a frame; filled by renderer/light/surface_tables.cpp.
uniform samplerBuffer vertex_table;     // three texels a vertex: position (m), normal and sky light outside,
                                        // material coordinate (m) or in x the scalar, and sky light inside
uniform usamplerBuffer triangle_table;  // three vertices, and four times the surface plus its key light: 0 in the
                                        // shadow, 1 in the light, 2 for pixels to find out
uniform samplerBuffer look_table;       // three texels a surface: outside colour (linear) and roughness, inside
                                        // colour and sheen, translucency, strength of the weave, row of the colour
                                        // map or -1 for cloth

// What was seen in a sample: nothing, or a triangle and one of its sides.
bool is_front(uint seen) { return (seen & 1u) == 1u; }
int triangle_of(uint seen) { return int(seen >> 1u) - 1; }
