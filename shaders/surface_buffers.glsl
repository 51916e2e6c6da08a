// All surfaces of a frame; filled by renderer/light/surface_buffers.cpp.
uniform samplerBuffer vertex_data;     // three texels a vertex: position (m), normal and sky light outside,
                                        // material coordinate (m) or in x the scalar, and sky light inside
uniform usamplerBuffer triangle_data;  // three vertices, and in one number its key light (2 bits: 0 in the shadow,
                                        // 1 in the light, 2 for pixels to find out), surface (12) and trim (18)
uniform samplerBuffer material_data;    // five texels a surface: outside colour (linear) and roughness; inside
                                        // colour and sheen; translucency, strength of the weave, row of the colour
                                        // map or -1 for cloth, layer of the base colour map or -1; kind of the weave,
                                        // threads in a metre, unevenness and roughness of the sheen; colour of
                                        // stitches, and 1 where they have one
#ifdef BASE_COLOUR_MAPS
uniform samplerBuffer corner_data;     // a texel for each corner of a triangle: where it is on a base colour map
#endif

// Seen in a sample: nothing, or a triangle and one of its sides.
bool is_front(uint visible) { return (visible & 1u) == 1u; }
int triangle_of(uint visible) { return int(visible >> 1u) - 1; }
int surface_of(uint numbers) { return int((numbers >> 2u) & 4095u); }
int trim_of(uint numbers) { return int(numbers >> 14u); }
