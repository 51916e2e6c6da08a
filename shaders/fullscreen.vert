#version 330 core
// One triangle that covers the viewport, on the far plane, without a buffer.
out vec2 place;  // 0..1, y up

void main() {
  place = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(place * 2.0 - 1.0, 1.0, 1.0);
}
