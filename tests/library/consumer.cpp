#include <taut.h>

#include <cstdio>

// A program of another author, in C++. It prints the number of vertices of a garment file and checks that the first
// frame keeps the bound.
int main(int count, char** arguments) {
  TautOptions options;
  TautError error;
  TautInfo info;
  TautFrame frame;
  taut_options_init(&options, sizeof(options));
  taut_error_init(&error, sizeof(error));
  taut_info_init(&info, sizeof(info));
  taut_frame_init(&frame, sizeof(frame));
  options.scene = count > 1 ? arguments[1] : "tshirt";
  TautCloth cloth;
  if (taut_create(&options, &cloth, &error) != TAUT_OK) {
    std::printf("error %d: %s\n", static_cast<int>(error.result), error.text);
    return 1;
  }
  taut_get_info(cloth, &info);
  taut_step(cloth, &frame);
  std::printf("%d vertices, bound kept: %d\n", static_cast<int>(info.vertex_count),
              static_cast<int>(frame.is_bound_kept));
  return taut_destroy(cloth);
}
