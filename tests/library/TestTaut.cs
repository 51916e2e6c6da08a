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
      Require(frame.Number == 20 && frame.IsBoundKept == 1 && frame.CrossingPairs == -1, "frame");
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
    TestBehaviour();
    Console.WriteLine("taut " + Taut.Cloth.Version + " from C#: ok");
  }
}
