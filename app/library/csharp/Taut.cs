using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

/// Cloth that keeps a bound on its stretch and crosses nothing: libtaut for C#, in Unity and elsewhere. Metres,
/// kilograms, seconds, newtons; y is up. The header taut.h says what each call does. Positions are flat arrays, three
/// numbers for each vertex. Everything that fails throws a TautException.
namespace Taut {

public sealed class TautException : Exception {
  /// TautResult of taut.h.
  public readonly int Result;
  public TautException(int result, string text) : base(text) { Result = result; }
}

/// TautFrame of taut.h: what a frame is worth.
[StructLayout(LayoutKind.Sequential)]
public struct Frame {
  internal uint StructSize;
  public int Number;
  public double TimeS, MaxEdgeStretch, MaxSurfaceStretch, SmallestDistanceM;
  public long CrossingPairs;
  public ulong StateHash;
  public int Substeps;
  [MarshalAs(UnmanagedType.Bool)] public bool IsBoundKept;
  [MarshalAs(UnmanagedType.Bool)] public bool IsContactKept;
  [MarshalAs(UnmanagedType.Bool)] public bool IsAsleep;
  public ulong MeasuredCrossings;
  public double LeftOutShare, WindForceN, WindPowerW;
}

/// TautInfo of taut.h.
[StructLayout(LayoutKind.Sequential)]
public struct Info {
  internal uint StructSize;
  public int Frame;
  public double TimeS, FrameRateHz, MaxStretch;
  public UIntPtr VertexCount, TriangleCount, EdgeCount, PinCount, BodyCount, CrossingsAtStart;
}

/// An obstacle of the cloth: a closed mesh, or without positions the plane. One that the cloth is to be put on grows into
/// it in `Dress` frames before the first.
public sealed class Body {
  public float[] Positions;
  public int[] Corners, CornersPerFace;  // null: triangles
  public string Name;
  public double? Friction;
  public double[] PlanePoint = { 0, 0, 0 }, PlaneNormal = { 0, 1, 0 };
  public int Dress;
}

/// The source of a cloth: one of Scene, SceneText and Positions with Corners; TautOptions of taut.h.
public sealed class Options {
  public string Scene, SceneText, Importer;
  public float[] Positions, Start;
  public int[] Corners, CornersPerFace;  // null: triangles
  public Body[] Bodies = {};
  public string[] Settings = {};
  public int Threads;
  public bool CountsCrossings;
  public Action<string> Log;  // null under IL2CPP, which calls no delegate of an object back
}

/// The calls of taut.h.
static class Native {
  const string Library = "taut";

  [StructLayout(LayoutKind.Sequential)]
  internal struct Cloth { internal ulong Id; }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Points { internal IntPtr Data; internal UIntPtr Count, Stride; internal int Type; }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Mesh {
    internal uint StructSize;
    internal Points Positions;
    internal IntPtr Corners;
    internal UIntPtr CornerCount;
    internal IntPtr CornersPerFace;
    internal UIntPtr FaceCount;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Options {
    internal uint StructSize;
    internal int Threads;
    internal IntPtr Scene, SceneText, Mesh, Start, Settings;
    internal UIntPtr SettingCount;
    internal IntPtr Importer, Log, LogUser;
    internal int CountsCrossings;
    internal IntPtr Bodies;
    internal UIntPtr BodyCount;
  }

  [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
  internal delegate void Log(IntPtr user, IntPtr text);

  [StructLayout(LayoutKind.Sequential)]
  internal struct Body {
    internal uint StructSize;
    internal int HasFriction;
    internal IntPtr Name, Mesh;
    internal double PointX, PointY, PointZ, NormalX, NormalY, NormalZ, Friction;
    internal int Dress;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Error {
    internal uint StructSize;
    internal int Result;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 1016)] internal byte[] Text;
  }

  [DllImport(Library)] internal static extern IntPtr taut_version();
  [DllImport(Library)] internal static extern IntPtr taut_build_info();
  [DllImport(Library)]
  internal static extern int taut_list(int kind, byte[] buffer, UIntPtr capacity, out UIntPtr size);
  [DllImport(Library)] internal static extern int taut_create(ref Options options, out Cloth cloth, ref Error error);
  [DllImport(Library)] internal static extern int taut_destroy(Cloth cloth);
  [DllImport(Library)] internal static extern IntPtr taut_last_error(Cloth cloth);
  [DllImport(Library)] internal static extern int taut_get_info(Cloth cloth, ref Info info);
  [DllImport(Library)] internal static extern int taut_step(Cloth cloth, ref Frame frame);
  [DllImport(Library)] internal static extern int taut_set(Cloth cloth, byte[] key, byte[] value);
  [DllImport(Library)] internal static extern int taut_set_wind(Cloth cloth, double x, double y, double z);
  [DllImport(Library)] internal static extern int taut_set_gravity(Cloth cloth, double x, double y, double z);
  [DllImport(Library)] internal static extern int taut_set_forces(Cloth cloth, uint[] vertices, ref Points forces);
  [DllImport(Library)] internal static extern int taut_set_pins(Cloth cloth, uint[] vertices, UIntPtr count);
  [DllImport(Library)] internal static extern int taut_get_pins(Cloth cloth, uint[] vertices, UIntPtr count);
  [DllImport(Library)] internal static extern int taut_move_pins(Cloth cloth, uint[] vertices, ref Points targets);
  [DllImport(Library)] internal static extern int taut_add_body(Cloth cloth, ref Body body, out int number);
  [DllImport(Library)] internal static extern int taut_move_body(Cloth cloth, int number, ref Points positions);
  [DllImport(Library)] internal static extern int taut_place_body(Cloth cloth, int number, ref Points positions);
  [DllImport(Library)] internal static extern int taut_get_positions(Cloth cloth, ref Points positions);
  [DllImport(Library)] internal static extern int taut_set_positions(Cloth cloth, ref Points positions);
  [DllImport(Library)] internal static extern int taut_get_stretch(Cloth cloth, double[] stretch, UIntPtr count);
  [DllImport(Library)] internal static extern int taut_get_triangles(Cloth cloth, uint[] vertices, UIntPtr count);
  [DllImport(Library)]
  internal static extern int taut_get_edges(Cloth cloth, uint[] vertices, double[] lengths, UIntPtr count);
  [DllImport(Library)]
  internal static extern int taut_draw(Cloth cloth, int width, int height, byte[] rgb, UIntPtr size);
  [DllImport(Library)] internal static extern int taut_state_hash(Cloth cloth, out ulong hash);
  [DllImport(Library)]
  internal static extern int taut_save(Cloth cloth, byte[] buffer, UIntPtr capacity, out UIntPtr size);
  [DllImport(Library)] internal static extern int taut_restore(Cloth cloth, byte[] buffer, UIntPtr size);
  [DllImport(Library)] internal static extern int taut_save_file(Cloth cloth, byte[] path);
  [DllImport(Library)] internal static extern int taut_restore_file(Cloth cloth, byte[] path);

  internal static byte[] Utf8(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }

  internal static string Text(IntPtr utf8) {
    var bytes = new List<byte>();
    for (byte next; (next = Marshal.ReadByte(utf8, bytes.Count)) != 0;) bytes.Add(next);
    return Encoding.UTF8.GetString(bytes.ToArray());
  }
}

/// Arrays that keep their places while a call reads or fills them.
sealed class Pinned : IDisposable {
  readonly List<GCHandle> handles = new List<GCHandle>();

  internal IntPtr At(object array) {
    if (array == null) return IntPtr.Zero;
    handles.Add(GCHandle.Alloc(array, GCHandleType.Pinned));
    return handles[handles.Count - 1].AddrOfPinnedObject();
  }
  internal IntPtr Text(string text) { return text == null ? IntPtr.Zero : At(Native.Utf8(text)); }
  internal Native.Points Points(float[] numbers) {
    return new Native.Points { Data = At(numbers), Count = (UIntPtr)(numbers.Length / 3), Stride = (UIntPtr)12 };
  }
  internal Native.Mesh Mesh(float[] positions, int[] corners, int[] cornersPerFace) {
    return new Native.Mesh { StructSize = (uint)Marshal.SizeOf(typeof(Native.Mesh)), Positions = Points(positions),
                             Corners = At(corners), CornerCount = (UIntPtr)corners.Length,
                             CornersPerFace = At(cornersPerFace),
                             FaceCount = (UIntPtr)(cornersPerFace == null ? 0 : cornersPerFace.Length) };
  }
  internal Native.Body Body(Body body) {
    return new Native.Body {
      StructSize = (uint)Marshal.SizeOf(typeof(Native.Body)), Name = Text(body.Name),
      HasFriction = body.Friction.HasValue ? 1 : 0, Friction = body.Friction.GetValueOrDefault(), Dress = body.Dress,
      Mesh = body.Positions == null ? IntPtr.Zero : At(Mesh(body.Positions, body.Corners, body.CornersPerFace)),
      PointX = body.PlanePoint[0], PointY = body.PlanePoint[1], PointZ = body.PlanePoint[2],
      NormalX = body.PlaneNormal[0], NormalY = body.PlaneNormal[1], NormalZ = body.PlaneNormal[2] };
  }
  public void Dispose() {
    foreach (var handle in handles) handle.Free();
  }
}

public sealed class Cloth : IDisposable {
  Native.Cloth cloth;

  readonly Native.Log log;  // it lives as long as the cloth

  public Cloth(Options options) {
    log = (user, text) => {
      try {
        options.Log(Native.Text(text));
      } catch (Exception error) {
        Console.Error.WriteLine(error);  // it must not go on through the library
      }
    };
    using (var pinned = new Pinned()) {
      var native = new Native.Options {
        StructSize = (uint)Marshal.SizeOf(typeof(Native.Options)), Threads = options.Threads,
        Scene = pinned.Text(options.Scene), SceneText = pinned.Text(options.SceneText),
        Importer = pinned.Text(options.Importer), CountsCrossings = options.CountsCrossings ? 1 : 0,
        Settings = pinned.At(Array.ConvertAll(options.Settings, setting => pinned.Text(setting))),
        SettingCount = (UIntPtr)options.Settings.Length,
        Bodies = pinned.At(Array.ConvertAll(options.Bodies, body => pinned.At(pinned.Body(body)))),
        BodyCount = (UIntPtr)options.Bodies.Length };
      if (options.Positions != null)
        native.Mesh = pinned.At(pinned.Mesh(options.Positions, options.Corners, options.CornersPerFace));
      if (options.Start != null) native.Start = pinned.At(pinned.Points(options.Start));
      if (options.Log != null) native.Log = Marshal.GetFunctionPointerForDelegate(log);
      var error = new Native.Error { StructSize = (uint)Marshal.SizeOf(typeof(Native.Error)), Text = new byte[1016] };
      int result = Native.taut_create(ref native, out cloth, ref error);
      if (result != 0)
        throw new TautException(result, Encoding.UTF8.GetString(error.Text, 0, Array.IndexOf(error.Text, (byte)0)));
    }
  }

  /// A cloth of a scene, a garment file or a scene that comes with Taut. Settings are "wind.speed = 4".
  public Cloth(string scene, params string[] settings) : this(new Options { Scene = scene, Settings = settings }) {}

  /// A cloth of triangles, which nothing holds.
  public Cloth(float[] positions, int[] triangles, params string[] settings)
      : this(new Options { Positions = positions, Corners = triangles, Settings = settings }) {}

  ~Cloth() { Native.taut_destroy(cloth); }

  public void Dispose() {
    Native.taut_destroy(cloth);
    GC.SuppressFinalize(this);
  }

  void Check(int result) {
    if (result != 0) throw new TautException(result, Native.Text(Native.taut_last_error(cloth)));
  }

  public static string Version { get { return Native.Text(Native.taut_version()); } }
  public static string BuildInfo { get { return Native.Text(Native.taut_build_info()); } }

  /// The names that come with Taut: for a cloth, and for Set("cloth.fabric", name).
  public static string[] Scenes { get { return Names(0); } }
  public static string[] Fabrics { get { return Names(1); } }

  static string[] Names(int kind) {
    UIntPtr size;
    if (Native.taut_list(kind, null, UIntPtr.Zero, out size) != 0) throw new TautException(4, "found no scenes and fabrics");
    var names = new byte[(int)size];
    Native.taut_list(kind, names, size, out size);
    return Encoding.UTF8.GetString(names).Split(new[] { '\n', '\0' }, StringSplitOptions.RemoveEmptyEntries);
  }

  public Info Info {
    get {
      var info = new Info { StructSize = (uint)Marshal.SizeOf(typeof(Info)) };
      Check(Native.taut_get_info(cloth, ref info));
      return info;
    }
  }

  /// Goes on by so many frames and returns what the last is worth.
  public Frame Step(int frames = 1) {
    var frame = new Frame { StructSize = (uint)Marshal.SizeOf(typeof(Frame)) };
    for (int k = 0; k < frames; ++k) Check(Native.taut_step(cloth, ref frame));
    return frame;
  }

  public void Set(string key, string value) { Check(Native.taut_set(cloth, Native.Utf8(key), Native.Utf8(value))); }
  public void SetWind(double x, double y, double z) { Check(Native.taut_set_wind(cloth, x, y, z)); }
  public void SetGravity(double x, double y, double z) { Check(Native.taut_set_gravity(cloth, x, y, z)); }
  public void SetPins(params uint[] vertices) {
    Check(Native.taut_set_pins(cloth, vertices, (UIntPtr)vertices.Length));
  }

  delegate int PointsCall(ref Native.Points points);

  void CheckWith(float[] numbers, PointsCall call) {
    using (var pinned = new Pinned()) {
      var points = pinned.Points(numbers);
      Check(call(ref points));
    }
  }

  static void RequirePoints(uint[] vertices, float[] numbers) {
    if (numbers.Length != 3 * vertices.Length) throw new TautException(3, "expected three numbers for each vertex");
  }

  public void SetForces(uint[] vertices, float[] forces) {
    RequirePoints(vertices, forces);
    CheckWith(forces, (ref Native.Points points) => Native.taut_set_forces(cloth, vertices, ref points));
  }
  public void MovePins(uint[] vertices, float[] targets) {
    RequirePoints(vertices, targets);
    CheckWith(targets, (ref Native.Points points) => Native.taut_move_pins(cloth, vertices, ref points));
  }

  /// Returns the body's number. Cloth that crosses it may stay so: it is logged, and counted in Info.CrossingsAtStart.
  public int AddBody(Body body) {
    using (var pinned = new Pinned()) {
      var native = pinned.Body(body);
      int number;
      Check(Native.taut_add_body(cloth, ref native, out number));
      return number;
    }
  }
  public int AddBody(float[] positions, int[] triangles) {
    return AddBody(new Body { Positions = positions, Corners = triangles });
  }
  public int AddGround(double height) { return AddBody(new Body { PlanePoint = new[] { 0, height, 0 } }); }

  public void MoveBody(int number, float[] positions) {
    CheckWith(positions, (ref Native.Points points) => Native.taut_move_body(cloth, number, ref points));
  }
  public void PlaceBody(int number, float[] positions) {
    CheckWith(positions, (ref Native.Points points) => Native.taut_place_body(cloth, number, ref points));
  }
  public void GetPositions(float[] positions) {
    CheckWith(positions, (ref Native.Points points) => Native.taut_get_positions(cloth, ref points));
  }
  public void SetPositions(float[] positions) {
    CheckWith(positions, (ref Native.Points points) => Native.taut_set_positions(cloth, ref points));
  }

  T[] Filled<T>(int length, Func<T[], UIntPtr, int> fill) {
    var array = new T[length];
    Check(fill(array, (UIntPtr)length));
    return array;
  }

  public double[] Stretch {
    get { return Filled<double>((int)Info.VertexCount, (to, count) => Native.taut_get_stretch(cloth, to, count)); }
  }

  /// Three vertices for each triangle that is simulated.
  public uint[] Triangles {
    get { return Filled<uint>(3 * (int)Info.TriangleCount, (to, count) => Native.taut_get_triangles(cloth, to, count)); }
  }

  /// Two vertices for each edge, and its length at rest.
  public uint[] Edges(out double[] lengths) {
    lengths = new double[(int)Info.EdgeCount];
    var edges = new uint[2 * lengths.Length];
    Check(Native.taut_get_edges(cloth, edges, lengths, (UIntPtr)lengths.Length));
    return edges;
  }

  public uint[] Pins {
    get { return Filled<uint>((int)Info.PinCount, (to, count) => Native.taut_get_pins(cloth, to, count)); }
  }

  /// The picture that `taut render` draws of this frame: red, green and blue of each pixel, row by row from above.
  public byte[] Draw(int width, int height) {
    return Filled<byte>(3 * width * height, (to, count) => Native.taut_draw(cloth, width, height, to, count));
  }

  public ulong StateHash {
    get {
      ulong hash;
      Check(Native.taut_state_hash(cloth, out hash));
      return hash;
    }
  }

  public byte[] Save() {
    UIntPtr size;
    Check(Native.taut_save(cloth, null, UIntPtr.Zero, out size));
    var bytes = new byte[(int)size];
    Check(Native.taut_save(cloth, bytes, size, out size));
    return bytes;
  }

  public void Restore(byte[] state) { Check(Native.taut_restore(cloth, state, (UIntPtr)state.Length)); }
  /// The same as a file, which is written whole or not at all; `taut simulate --checkpoint` writes such, too.
  public void SaveFile(string path) { Check(Native.taut_save_file(cloth, Native.Utf8(path))); }
  public void RestoreFile(string path) { Check(Native.taut_restore_file(cloth, Native.Utf8(path))); }
}

}
