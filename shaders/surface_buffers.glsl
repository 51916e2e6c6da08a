// Surfaces of a frame; filled by renderer/light/surface_buffers.cpp.
uniform sampler2D vertex_data;        // three texels per vertex: position (m), normal, and material
                                        // coordinate (m) or the scalar in x
uniform usampler2D triangle_data;      // three vertices, and one number of surface (14 bits) and trim (18)
uniform sampler2D material_data;       // five texels per surface: outside colour (linear) and roughness; inside
                                        // colour and sheen; translucency, strength of the weave, row of the colour
                                        // map or -1 for cloth, layer of the base colour map or -1; kind of the weave,
                                        // threads per metre, unevenness and roughness of the sheen; colour of
                                        // stitches, and 1 if they have one
#ifdef BASE_COLOUR_MAPS
uniform sampler2D corner_data;        // one texel per triangle corner: its position on a base colour map
#endif
uniform sampler2D vertex_light;         // one texel per vertex: light from the sky and from the floor outside, and inside
// Texels in a row of each of these textures; renderer/light/surface_buffers.hpp has it too.
const int texels_per_row = 1024;
ivec2 texel(int number) { return ivec2(number & (texels_per_row - 1), number / texels_per_row); }

// Content of a sample: nothing, or a triangle and one of its sides.
bool is_front(uint visible) { return (visible & 1u) == 1u; }
int triangle_of(uint visible) { return int(visible >> 1u) - 1; }
int surface_of(uint numbers) { return int(numbers & 16383u); }
int trim_of(uint numbers) { return int(numbers >> 14u); }
