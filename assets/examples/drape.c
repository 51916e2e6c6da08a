/* A square of silk swings down from two of its corners; prints its largest stretch. */
#include <stdio.h>
#include <taut.h>

enum { side = 21 };

int main(void) {
  static float positions[side * side][3];
  static uint32_t corners[(side - 1) * (side - 1)][4], four[(side - 1) * (side - 1)];
  const uint32_t pins[2] = {0, side - 1};
  for (uint32_t v = 0; v < side * side; ++v) {
    positions[v][0] = 0.05F * (float)(v % side);
    positions[v][2] = 0.05F * (float)(v / side);
  }
  for (uint32_t f = 0; f < (side - 1) * (side - 1); ++f) {
    const uint32_t v = f / (side - 1) * side + f % (side - 1);
    const uint32_t face[4] = {v, v + side, v + side + 1, v + 1};
    for (int k = 0; k < 4; ++k) corners[f][k] = face[k];
    four[f] = 4;
  }
  const TautPoints points = {positions, side * side, sizeof positions[0], TAUT_FLOAT};
  const char *settings[] = {"cloth.fabric = silk", "solver.max_stretch = 0.01"};
  TautMesh mesh; TautOptions options; TautFrame frame; TautError error; TautCloth cloth;
  taut_mesh_init(&mesh, sizeof mesh); taut_options_init(&options, sizeof options);
  taut_frame_init(&frame, sizeof frame); taut_error_init(&error, sizeof error);
  mesh.positions = points; mesh.corners = corners[0]; mesh.corner_count = sizeof corners / sizeof(uint32_t);
  mesh.corners_per_face = four; mesh.face_count = sizeof four / sizeof four[0];
  options.mesh = &mesh; options.settings = settings; options.setting_count = 2;
  if (taut_create(&options, &cloth, &error) != TAUT_OK) return fprintf(stderr, "%s\n", error.text), 1;
  taut_set_pins(cloth, pins, 2);
  for (int k = 0; k < 60; ++k)
    if (taut_step(cloth, &frame) != TAUT_OK) return fprintf(stderr, "%s\n", taut_last_error(cloth)), 1;
  printf("largest stretch %.3f %% at %.2f s\n", 100.0 * frame.max_surface_stretch, frame.time_s);
  return taut_destroy(cloth);
}
