using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;

namespace RayTracer.Benchmarks.Embree;

/// <summary>Rays of one kind, an array a quantity, and where their hits go.</summary>
internal sealed unsafe class BenchmarkRays
{
    /// <summary>Pixels along an edge of the picture.</summary>
    public const int Edge = 1024;

    private readonly PinnedBuffer<float> _distance;
    private readonly PinnedBuffer<int> _primitive;

    private BenchmarkRays(string name, IReadOnlyList<(Vector3 Origin, Vector3 Direction, float Limit)> rays, bool any)
    {
        Name = name;
        Any = any;
        Count = rays.Count;
        _distance = new(Count);
        _primitive = new(Count);
        for (int i = 0; i < 7; i++)
        {
            Numbers[i] = new(Count);
        }

        for (int ray = 0; ray < Count; ray++)
        {
            (Vector3 origin, Vector3 direction, float limit) = rays[ray];
            (Numbers[0].Pointer[ray], Numbers[1].Pointer[ray], Numbers[2].Pointer[ray]) = (origin.X, origin.Y, origin.Z);
            (Numbers[3].Pointer[ray], Numbers[4].Pointer[ray], Numbers[5].Pointer[ray]) = (direction.X, direction.Y, direction.Z);
            Numbers[6].Pointer[ray] = limit;
        }
    }

    public string Name { get; }

    /// <summary>Whether any hit is asked for, not the nearest.</summary>
    public bool Any { get; }

    /// <summary>Whether the peer knows that neighbours are alike.</summary>
    public bool Coherent => Name == "coherent";

    public int Count { get; }

    /// <summary>Origins, directions and limits.</summary>
    public PinnedBuffer<float>[] Numbers { get; } = new PinnedBuffer<float>[7];

    public float* Distance => _distance.Pointer;

    public int* Primitive => _primitive.Pointer;

    /// <summary>A part as a stream whose distances are limits again.</summary>
    public RayStream Part(int first, int count)
    {
        new ReadOnlySpan<float>(Numbers[6].Pointer + first, count).CopyTo(new(Distance + first, count));
        return new()
        {
            OriginX = Numbers[0].Pointer + first,
            OriginY = Numbers[1].Pointer + first,
            OriginZ = Numbers[2].Pointer + first,
            DirectionX = Numbers[3].Pointer + first,
            DirectionY = Numbers[4].Pointer + first,
            DirectionZ = Numbers[5].Pointer + first,
            Distance = Distance + first,
            Primitive = Primitive + first,
            Count = count,
        };
    }

    /// <summary>Primary rays through square blocks of pixels, then what follows from their hits: shadow rays, bounces, the same bounces in no order.</summary>
    public static BenchmarkRays[] Of(BenchmarkMesh mesh, TriangleBvh tree)
    {
        Random random = new(7);
        BenchmarkRays primary = new("coherent", Camera(tree), any: false);
        tree.ClosestHit(primary.Part(0, primary.Count));
        List<(Vector3, Vector3, float)> shadows = [];
        List<(Vector3, Vector3, float)> bounces = [];
        Vector3 extent = tree.Upper - tree.Lower;
        Vector3 light = tree.Lower + (extent * new Vector3(0.8f, 1.5f, 0.4f));
        for (int ray = 0; ray < primary.Count; ray++)
        {
            int triangle = primary.Primitive[ray];
            if (triangle < 0)
            {
                continue;
            }

            Vector3 direction = Vector(primary, 3, ray);
            Vector3 normal = Vector3.Normalize(Vector3.Cross(
                mesh.Corner(triangle, 1) - mesh.Corner(triangle, 0), mesh.Corner(triangle, 2) - mesh.Corner(triangle, 0)));
            normal = Vector3.Dot(normal, direction) > 0f ? -normal : normal;
            Vector3 start = Vector(primary, 0, ray) + (direction * primary.Distance[ray]) + (normal * (5e-6f * extent.Length()));
            Vector3 lamp = light + (extent * 0.15f * new Vector3(random.NextSingle(), 0f, random.NextSingle()));
            shadows.Add((start, lamp - start, 0.999f));
            Vector3 way = new((float)Normal(random), (float)Normal(random), (float)Normal(random));
            bounces.Add((start, Vector3.Normalize(normal + (Vector3.Normalize(way) * 0.9999f)), float.PositiveInfinity));
        }

        (Vector3, Vector3, float)[] shuffled = [.. bounces];
        random.Shuffle(shuffled);
        return
        [
            primary,
            new("shadow", shadows, any: true),
            new("bounce", bounces, any: false),
            new("shuffled", shuffled, any: false),
        ];
    }

    private static List<(Vector3 Origin, Vector3 Direction, float Limit)> Camera(TriangleBvh tree)
    {
        Vector3 extent = tree.Upper - tree.Lower;
        Vector3 eye = tree.Lower + (extent * new Vector3(0.15f, 1.05f, 0.1f));
        Vector3 forwards = Vector3.Normalize(tree.Lower + (extent * new Vector3(0.6f, 0.35f, 0.65f)) - eye);
        Vector3 right = Vector3.Normalize(Vector3.Cross(forwards, Vector3.UnitY));
        Vector3 up = Vector3.Cross(right, forwards);
        List<(Vector3, Vector3, float)> rays = new(Edge * Edge);
        for (int i = 0; i < Edge * Edge; i++)
        {
            float x = ((EveryOtherBit(i) + 0.5f) / Edge) - 0.5f;
            float y = 0.5f - ((EveryOtherBit(i >> 1) + 0.5f) / Edge);
            rays.Add((eye, Vector3.Normalize(forwards + (right * x) + (up * y)), float.PositiveInfinity));
        }

        return rays;
    }

    private static int EveryOtherBit(int code)
    {
        int number = 0;
        for (int bit = 0; bit < 10; bit++)
        {
            number |= (code >> (2 * bit) & 1) << bit;
        }

        return number;
    }

    private static Vector3 Vector(BenchmarkRays rays, int first, int ray) =>
        new(rays.Numbers[first].Pointer[ray], rays.Numbers[first + 1].Pointer[ray], rays.Numbers[first + 2].Pointer[ray]);

    private static double Normal(Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
