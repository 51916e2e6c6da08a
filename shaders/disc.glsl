// Points evenly spread over the unit disc (Vogel 1979): each is the previous one turned by the golden angle and moved
// outwards. Turning a direction costs four multiplications; sines and cosines would dominate every loop.
const mat2 golden_turn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

vec2 disc_direction(float turn) { return vec2(cos(turn), sin(turn)); }
float disc_radius(int i, int count) { return sqrt((float(i) + 0.5) / float(count)); }
