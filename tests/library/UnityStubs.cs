// As much of UnityEngine as TautBehaviour asks for, so that it can be compiled and run without Unity.
using System;

namespace UnityEngine {

public struct Vector3 {
  public float x, y, z;
  public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
}

public class RequireComponent : Attribute {
  public RequireComponent(Type type) {}
}

public class Mesh {
  public Vector3[] vertices;
  public int[] triangles;
  public int timesNormals;
  public void RecalculateNormals() { ++timesNormals; }
}

public class MeshFilter {
  public Mesh mesh;
}

public class Transform {
  public float height;
  public Vector3 TransformPoint(Vector3 p) { return new Vector3(p.x, p.y + height, p.z); }
  public Vector3 InverseTransformPoint(Vector3 p) { return new Vector3(p.x, p.y - height, p.z); }
}

public class MonoBehaviour {
  public Transform transform = new Transform();
  public object component;
  public T GetComponent<T>() { return (T)component; }
}

}
