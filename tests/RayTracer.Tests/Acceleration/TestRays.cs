using System.Numerics;
using RayTracer.Acceleration;

namespace RayTracer.Tests.Acceleration;

/// <summary>Rays to send at a mesh, and what became of them.</summary>
internal sealed unsafe class TestRays
{
    private readonly float[][] _numbers = new float[7][];

    public TestRays(IReadOnlyList<(Vector3 Origin, Vector3 Direction, float Limit)> rays)
    {
        for (int i = 0; i < 7; i++)
        {
            _numbers[i] = new float[rays.Count];
        }

        Primitive = new int[rays.Count];
        for (int i = 0; i < rays.Count; i++)
        {
            (Vector3 origin, Vector3 direction, float limit) = rays[i];
            float[] values = [origin.X, origin.Y, origin.Z, direction.X, direction.Y, direction.Z, limit];
            for (int k = 0; k < 7; k++)
            {
                _numbers[k][i] = values[k];
            }
        }
    }

    public int Count => Primitive.Length;

    public int[] Primitive { get; private init; }

    public float[] Distance => _numbers[6];

    public Vector3 Origin(int ray) => new(_numbers[0][ray], _numbers[1][ray], _numbers[2][ray]);

    public Vector3 Direction(int ray) => new(_numbers[3][ray], _numbers[4][ray], _numbers[5][ray]);

    /// <summary>Traces copies of the rays.</summary>
    public TestRays Traced(TriangleBvh tree, bool any, TraversalMode mode)
    {
        TestRays copy = new([.. Enumerable.Range(0, Count).Select(i => (Origin(i), Direction(i), Distance[i]))]);
        copy.Use(stream =>
        {
            if (any)
            {
                tree.AnyHit(stream, mode);
            }
            else
            {
                tree.ClosestHit(stream, mode);
            }
        });
        return copy;
    }

    /// <summary>Rays of many kinds around a mesh: through its box, at its corners and edges, along the axes, with directions of any length.</summary>
    public static TestRays Around(TestMesh mesh, int count, int seed)
    {
        Random random = new(seed);
        float Symmetric() => (2f * random.NextSingle()) - 1f;
        Vector3 lower = new(float.PositiveInfinity);
        Vector3 upper = new(float.NegativeInfinity);
        foreach (Vector3 p in mesh.Positions.Where(p => float.IsFinite(p.X + p.Y + p.Z) && MathF.Abs(p.X + p.Y + p.Z) < 1e18f))
        {
            lower = Vector3.Min(lower, p);
            upper = Vector3.Max(upper, p);
        }

        Vector3 middle = mesh.Count > 0 ? (lower + upper) / 2f : default;
        Vector3 extent = mesh.Count > 0 ? (upper - lower) / 2f : new(1f);
        extent = Vector3.Max(extent, new(0.1f * MathF.Max(extent.X, MathF.Max(extent.Y, extent.Z))));
        Vector3 Within(float factor) => middle + (extent * factor * new Vector3(Symmetric(), Symmetric(), Symmetric()));
        List<(Vector3, Vector3, float)> rays = [];
        for (int i = 0; i < count; i++)
        {
            Vector3 origin = Within(i % 3 == 0 ? 1f : i % 3 == 1 ? 3f : 30f);
            Vector3 target = Within(1f);
            if (i % 2 == 0 && mesh.Count > 0)
            {
                int triangle = random.Next(mesh.Count);
                float along = random.Next(3) switch { 0 => 0f, 1 => 1f, _ => random.NextSingle() };
                int[] corners = [mesh.Indices[3 * triangle], mesh.Indices[(3 * triangle) + 1]];
                target = corners.All(c => c >= 0 && c < mesh.Positions.Length) ? Vector3.Lerp(mesh.Positions[corners[0]], mesh.Positions[corners[1]], along) : target;
            }

            if (i % 7 == 0)
            {
                // Along an axis, or in a plane of two.
                origin = random.Next(3) switch { 0 => target with { X = origin.X }, 1 => target with { Y = origin.Y }, _ => origin with { Z = target.Z } };
            }

            Vector3 direction = (target - origin) * MathF.Pow(10f, 3f * Symmetric());
            float limit = (i % 5) switch { 0 => 1f, 1 => random.NextSingle(), _ => float.PositiveInfinity };
            rays.Add((origin, direction, limit));
        }

        return new(rays);
    }

    /// <summary>Lends the rays as a stream.</summary>
    public void Use(Action<RayStream> use)
    {
        fixed (float* ox = _numbers[0], oy = _numbers[1], oz = _numbers[2], dx = _numbers[3], dy = _numbers[4], dz = _numbers[5], distance = _numbers[6])
        fixed (int* primitive = Primitive)
        {
            use(new()
            {
                OriginX = ox,
                OriginY = oy,
                OriginZ = oz,
                DirectionX = dx,
                DirectionY = dy,
                DirectionZ = dz,
                Distance = distance,
                Primitive = primitive,
                Count = Count,
            });
        }
    }
}
