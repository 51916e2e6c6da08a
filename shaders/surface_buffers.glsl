// All surfaces of a frame; filled by renderer/light/surface_buffers.cpp.
uniform samplerBuffer vertex_data;     // three texels a vertex: position (m), normal and sky light outside,
                                        // material coordinate (m) or in x the scalar, and sky light inside
uniform usamplerBuffer triangle_data;  // three vertices, and four times the surface plus its key light: 0 in the
                                        // shadow, 1 in the light, 2 for pixels to find out
uniform samplerBuffer material_data;       // four texels a surface: outside colour (linear) and roughness, inside
                                        // colour and sheen, translucency, strength of the weave, row of the colour
                                        // map or -1 for cloth; kind of the weave and threads in a metre

// What was seen in a sample: nothing, or a triangle and one of its sides.
bool is_front(uint visible) { return (visible & 1u) == 1u; }
int triangle_of(uint visible) { return int(visible >> 1u) - 1; }
