using System;
using System.Diagnostics;

// Cost.exe SCENE FRAMES: as cost.cpp, from C#.
static class Cost {
  static void Main(string[] arguments) {
    int frames = int.Parse(arguments[1]);
    using (var cloth = new Taut.Cloth(arguments[0], "solver.threads = 1")) {
      var positions = new float[3 * (int)cloth.Info.VertexCount];
      var frame = new Taut.Frame();
      var begin = Process.GetCurrentProcess().TotalProcessorTime;
      for (int k = 0; k < frames; ++k) {
        frame = cloth.Step();
        cloth.GetPositions(positions);
      }
      double ms = (Process.GetCurrentProcess().TotalProcessorTime - begin).TotalMilliseconds;
      Console.WriteLine("C#: {0:F3} ms, {1:x16}", ms / frames, frame.StateHash);
    }
  }
}
