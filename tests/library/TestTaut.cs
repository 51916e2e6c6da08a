using System;
using System.Reflection;

// Runs Taut.cs and TautBehaviour.cs against the library. Ends with 1 and what was found where that is wrong.
static class TestTaut {
  static void Require(bool holds, string what) {
    if (holds) return;
    Console.WriteLine("wrong: " + what);
    Environment.Exit(1);
  }

  static int ResultOf(Action action, string part) {
    try {
      action();
    } catch (Taut.TautException error) {
      Require(error.Message.Contains(part), error.Message + "; expected: " + part);
      return error.Result;
    }
    return 0;
  }

  const int Side = 9;

  static UnityEngine.Mesh Square() {
    var mesh = new UnityEngine.Mesh { vertices = new UnityEngine.Vector3[Side * Side],
                                      triangles = new int[6 * (Side - 1) * (Side - 1)] };
    for (int v = 0; v < Side * Side; ++v) mesh.vertices[v] = new UnityEngine.Vector3(0.05f * (v % Side), 0, 0.05f * (v / Side));
    int at = 0;
    for (int row = 0; row + 1 < Side; ++row)
      for (int column = 0; column + 1 < Side; ++column) {
        int v = row * Side + column;
        foreach (int corner in new[] { v, v + Side, v + 1, v + 1, v + Side, v + Side + 1 }) mesh.triangles[at++] = corner;
      }
    return mesh;
  }

  static float[] Numbers(UnityEngine.Mesh mesh) {
    var numbers = new float[3 * mesh.vertices.Length];
    for (int v = 0; v < mesh.vertices.Length; ++v) {
      numbers[3 * v] = mesh.vertices[v].x;
      numbers[3 * v + 1] = mesh.vertices[v].y;
      numbers[3 * v + 2] = mesh.vertices[v].z;
    }
    return numbers;
  }

  static void TestCloth() {
    var mesh = Square();
    var numbers = Numbers(mesh);
    using (var cloth = new Taut.Cloth(numbers, mesh.triangles, "solver.max_stretch = 0.01")) {
      cloth.SetPins(0, Side - 1);
      Require(cloth.Pins.Length == 2 && cloth.Pins[1] == Side - 1, "pins");
      Require((int)cloth.Info.VertexCount == Side * Side && cloth.Info.MaxStretch == 0.01, "info");
      Require(cloth.AddGround(-0.1) == 0, "the ground's number");
      var frame = new Taut.Frame();
      for (int k = 0; k < 20; ++k) frame = cloth.Step();
      Require(frame.Number == 20 && frame.IsBoundKept && !frame.IsAsleep && frame.CrossingPairs == -1, "frame");
      Require(frame.MaxSurfaceStretch > 1e-4 && frame.MaxSurfaceStretch < 0.0100001, "stretch");
      Require(frame.StateHash == cloth.StateHash, "hash");
      var state = cloth.Save();
      cloth.SetWind(0, 0, 3);
      cloth.SetForces(new uint[] { 40 }, new float[] { 0, 0.1f, 0 });
      cloth.MovePins(new uint[] { 0 }, new float[] { 0, 0.01f, 0 });
      cloth.Step();
      cloth.GetPositions(numbers);
      Require(numbers[1] == 0.01f, "the target of a pin");
      Require(cloth.Stretch.Length == Side * Side, "stretch of vertices");
      var picture = cloth.Draw(32, 24);
      Require(picture.Length == 3 * 32 * 24 && Array.Exists(picture, value => value != picture[0]), "picture");
      cloth.Restore(state);
      Require(cloth.StateHash == frame.StateHash, "restored hash");
      Require(ResultOf(() => cloth.SetPins(99), "found vertex 99") == 3, "a pin that is none");
      Require(ResultOf(() => cloth.Set("wind.sped", "1"), "did you mean 'wind.speed'") == 3, "a key that is none");
    }
    var gone = new Taut.Cloth("pinned-9x9-5");
    gone.Dispose();
    Require(ResultOf(() => gone.Step(), "there is no such cloth") == 1, "a cloth that is disposed of");
    Require(ResultOf(() => new Taut.Cloth("tshirtt"), "did you mean 'tshirt'") == 4, "a scene that is none");
  }

  /// A box around the middle of the square.
  static Taut.Body Box(float height) {
    var box = new Taut.Body { Positions = new float[24], Name = "box", Friction = 0.5,
      Corners = new[] { 0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5 },
      CornersPerFace = new[] { 4, 4, 4, 4, 4, 4 } };
    for (int v = 0; v < 8; ++v) {
      box.Positions[3 * v] = 0.1f + 0.2f * (v & 1);
      box.Positions[3 * v + 1] = height + 0.05f * (v & 2);
      box.Positions[3 * v + 2] = 0.1f + 0.05f * (v & 4);
    }
    return box;
  }

  static void TestOptions() {
    var mesh = Square();
    var numbers = Numbers(mesh);
    var start = Array.ConvertAll(numbers, number => number);
    for (int v = 0; v < Side * Side; ++v) start[3 * v + 1] = 0.3f;
    var lines = new System.Collections.Generic.List<string>();
    var options = new Taut.Options { Positions = numbers, Corners = mesh.triangles, Start = start, Threads = 2,
                                     Bodies = new[] { Box(-0.05f), new Taut.Body { PlanePoint = new[] { 0, -0.2, 0 } } },
                                     CountsCrossings = true, Log = lines.Add };
    using (var cloth = new Taut.Cloth(options)) {
      Require((int)cloth.Info.BodyCount == 2 && (int)cloth.Info.CrossingsAtStart == 0 && lines.Count == 0, "bodies");
      Require(cloth.Triangles.Length == mesh.triangles.Length, "triangles");
      double[] lengths;
      var edges = cloth.Edges(out lengths);
      Require(edges.Length == 2 * lengths.Length && lengths.Length == (int)cloth.Info.EdgeCount, "edges");
      Require(Math.Abs(lengths[0] - 0.05) < 0.03, "lengths of edges");
      cloth.Set("cloth.fabric", Taut.Cloth.Fabrics[0]);
      for (int k = 0; k < 25; ++k) Require(cloth.Step().CrossingPairs == 0, "crossings are counted");
      cloth.GetPositions(numbers);
      Require(numbers[1] < 0 && numbers[3 * (Side * Side / 2) + 1] > 0.05, "the cloth lies on the box");
      GC.Collect();
      Require(cloth.AddBody(Box(0)) == 2 && (int)cloth.Info.CrossingsAtStart > 0, "a body in the way");
      Require(lines.Count == 1 && lines[0].Contains("with the body 'box'"), "what is logged: " + string.Join("; ", lines));
      var file = System.IO.Path.GetTempFileName();
      cloth.SaveFile(file);
      var hash = cloth.StateHash;
      cloth.SetPositions(start);
      Require(cloth.StateHash != hash, "other positions");
      cloth.RestoreFile(file);
      System.IO.File.Delete(file);
      Require(cloth.StateHash == hash, "the hash of a file");
    }
    using (var cloth = new Taut.Cloth(new Taut.Options { SceneText = "[garment.grid]\ncolumns = 4\n" }))
      Require((int)cloth.Info.VertexCount == 36, "a text");
    Require(Array.IndexOf(Taut.Cloth.Fabrics, "silk") >= 0 && Array.IndexOf(Taut.Cloth.Scenes, "tshirt") >= 0, "names");
    Require(Taut.Cloth.BuildInfo.Contains(Taut.Cloth.Version), "build info");
  }

  static void Call(object target, string method) {
    target.GetType().GetMethod(method, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(target, null);
  }

  static void TestBehaviour() {
    var behaviour = new TautBehaviour { pins = new[] { 0, Side - 1 } };
    var mesh = Square();
    behaviour.component = new UnityEngine.MeshFilter { mesh = mesh };
    Call(behaviour, "Start");
    for (int k = 0; k < 10; ++k) {
      behaviour.transform.height += 0.01f;
      Call(behaviour, "FixedUpdate");
    }
    Require(Math.Abs(mesh.vertices[0].y) < 1e-6 && Math.Abs(mesh.vertices[0].z) < 1e-6, "pins go with the object");
    Require(mesh.vertices[Side * Side - 1].y < -0.05 && mesh.timesNormals == 10, "the mesh hangs");
    Call(behaviour, "OnDestroy");
  }

  static void Main() {
    TestCloth();
    TestOptions();
    TestBehaviour();
    Console.WriteLine("taut " + Taut.Cloth.Version + " from C#: ok");
  }
}
