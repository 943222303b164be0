using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>Meets rays with the triangles of a mesh table.</summary>
internal sealed unsafe class TriangleTree(MeshTable mesh)
{
    /// <summary>Finds the nearest hits of many rays.</summary>
    public void ClosestHit(in RayStream rays)
    {
        for (int i = 0; i < rays.Count; i++)
        {
            rays.Primitive[i] = -1;
            for (int triangle = 0; triangle < mesh.Count; triangle++)
            {
                if (Meet(rays, i, triangle, out float t) && t < rays.Distance[i])
                {
                    rays.Distance[i] = t;
                    rays.Primitive[i] = triangle;
                }
            }
        }
    }

    /// <summary>Finds out which of many rays meet anything.</summary>
    public void AnyHit(in RayStream rays)
    {
        for (int i = 0; i < rays.Count; i++)
        {
            rays.Primitive[i] = -1;
            for (int triangle = 0; triangle < mesh.Count; triangle++)
            {
                if (Meet(rays, i, triangle, out float t) && t < rays.Distance[i])
                {
                    rays.Primitive[i] = 0;
                    break;
                }
            }
        }
    }

    // Möller & Trumbore 1997.
    private bool Meet(in RayStream rays, int i, int triangle, out float t)
    {
        System.Numerics.Vector3 origin = new(rays.OriginX[i], rays.OriginY[i], rays.OriginZ[i]);
        System.Numerics.Vector3 direction = new(rays.DirectionX[i], rays.DirectionY[i], rays.DirectionZ[i]);
        (System.Numerics.Vector3 a, System.Numerics.Vector3 b, System.Numerics.Vector3 c) = mesh.Corners(triangle);
        System.Numerics.Vector3 p = direction.Cross(c - a);
        float inverse = 1 / p.Dot(b - a);
        System.Numerics.Vector3 q = (origin - a).Cross(b - a);
        float u = p.Dot(origin - a) * inverse;
        float v = q.Dot(direction) * inverse;
        t = q.Dot(c - a) * inverse;
        return u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    }
}
