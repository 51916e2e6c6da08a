using UnityEngine;

/// Makes the mesh of this object a cloth that hangs by the vertices `pins`, which go with the object. Unity's axes are
/// left-handed, and so z changes its sign on the way in and out.
[RequireComponent(typeof(MeshFilter))]
public class TautBehaviour : MonoBehaviour {
  public int[] pins = new int[0];
  public string fabric = "cotton";
  public float maxStretch = 0.01f;
  public Vector3 wind;

  Taut.Cloth cloth;
  Mesh mesh;
  Vector3[] vertices;
  float[] numbers, targets;
  uint[] pinned;
  Vector3[] held;

  void Start() {
    mesh = GetComponent<MeshFilter>().mesh;
    vertices = mesh.vertices;
    numbers = new float[3 * vertices.Length];
    for (int v = 0; v < vertices.Length; ++v) Write(transform.TransformPoint(vertices[v]), numbers, v);
    var corners = mesh.triangles;
    System.Array.Reverse(corners);
    cloth = new Taut.Cloth(numbers, corners, "cloth.fabric = " + fabric, "time.frame_rate = 50",
                           "solver.max_stretch = " + maxStretch.ToString(System.Globalization.CultureInfo.InvariantCulture));
    pinned = System.Array.ConvertAll(pins, pin => (uint)pin);
    held = System.Array.ConvertAll(pins, pin => vertices[pin]);
    targets = new float[3 * pins.Length];
    cloth.SetPins(pinned);
  }

  // Unity calls it 50 times a second.
  void FixedUpdate() {
    cloth.SetWind(wind.x, wind.y, -wind.z);
    for (int k = 0; k < pinned.Length; ++k) Write(transform.TransformPoint(held[k]), targets, k);
    cloth.MovePins(pinned, targets);
    cloth.Step();
    cloth.GetPositions(numbers);
    for (int v = 0; v < vertices.Length; ++v)
      vertices[v] = transform.InverseTransformPoint(new Vector3(numbers[3 * v], numbers[3 * v + 1], -numbers[3 * v + 2]));
    mesh.vertices = vertices;
    mesh.RecalculateNormals();
  }

  void OnDestroy() {
    if (cloth != null) cloth.Dispose();
  }

  static void Write(Vector3 point, float[] to, int at) {
    to[3 * at] = point.x;
    to[3 * at + 1] = point.y;
    to[3 * at + 2] = -point.z;
  }
}
