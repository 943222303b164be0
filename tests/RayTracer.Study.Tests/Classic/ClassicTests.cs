using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study.Tests;

/// <summary>
/// The classic structures find what the plain loop finds, to the bit: they test triangles alike, and may only leave out what is not hit.
/// Covers `KdTree`.
/// </summary>
[Trait("Category", "Thorough")]
public class ClassicTests
{
    public static TheoryData<string, int> Meshes() => new()
    {
        { "soup", 1 }, { "soup", 2 }, { "soup", 50 }, { "soup", 2000 }, { "flat", 300 }, { "in a row", 100 }, { "far away", 500 }, { "all equal", 20 }, { "slivers", 400 },
    };

    [Theory]
    [MemberData(nameof(Meshes))]
    public void Every_structure_finds_what_the_loop_finds(string kind, int count)
    {
        Random random = new(TestSettings.Seed);
        MeshData mesh = Create(kind, count, random);
        PlainLoop loop = new(mesh);
        Accelerator[] others = [new UniformGrid(mesh), new KdTree(mesh)];
        int hits = 0;
        for (int i = 0; i < TestSettings.Scale(3000, 30_000); i++)
        {
            Ray ray = CreateRay(mesh, random, i);
            float limit = i % 5 == 0 ? 0.5f : float.PositiveInfinity;
            float expected = limit;
            int triangle = loop.ClosestHit(ray, ref expected);
            hits += triangle >= 0 ? 1 : 0;
            foreach (Accelerator other in others)
            {
                float distance = limit;
                Assert.Equal((other.Name, triangle, expected), (other.Name, other.ClosestHit(ray, ref distance), distance));
            }
        }

        Assert.True(hits > 50, "the rays miss");
    }

    [Fact]
    public void Nothing_is_hit_where_nothing_is()
    {
        MeshData mesh = new([], []);
        foreach (Accelerator accelerator in new Accelerator[] { new PlainLoop(mesh), new UniformGrid(mesh), new KdTree(mesh) })
        {
            float distance = float.PositiveInfinity;
            Assert.Equal(-1, accelerator.ClosestHit(new Ray(Vector3.Zero, Vector3.UnitX), ref distance));
        }
    }

    private static MeshData Create(string kind, int count, Random random)
    {
        Vector3 Point() => new(random.NextSingle(), random.NextSingle(), random.NextSingle());
        float size = 1.5f / MathF.Cbrt(count);
        Vector3[] positions = [.. Enumerable.Range(0, count).SelectMany(i =>
        {
            Vector3 a = kind switch
            {
                "in a row" => new(i / (float)count, 0.5f, 0.5f),
                "all equal" => new(0.5f),
                _ => Point(),
            };
            (Vector3 b, Vector3 c) = kind == "all equal" ? (Vector3.UnitX, Vector3.UnitY) : ((Point() - new Vector3(0.5f)) * size, (Point() - new Vector3(0.5f)) * size);
            c = kind == "slivers" ? b * 0.999f + (c * 1e-3f) : c;
            return new[] { a, a + b, a + c }.Select(p => kind switch
            {
                "flat" => p with { Y = 0.25f },
                "far away" => p + new Vector3(1000, -500, 2000),
                _ => p,
            });
        })];
        return new(positions, [.. Enumerable.Range(0, 3 * count)]);
    }

    // To points of triangles and into the air; some along the axes, and some starting within.
    private static Ray CreateRay(MeshData mesh, Random random, int i)
    {
        Vector3 Random() => new((2 * random.NextSingle()) - 1, (2 * random.NextSingle()) - 1, (2 * random.NextSingle()) - 1);
        int triangle = random.Next(mesh.TriangleCount);
        Vector3 to = (mesh.Positions[3 * triangle] + mesh.Positions[(3 * triangle) + 1] + mesh.Positions[(3 * triangle) + 2]) / 3;
        to = i % 3 == 0 ? to + (0.3f * Random()) : to;
        Vector3 direction = (i % 4) switch { 0 => Vector3.UnitX, 1 => -Vector3.UnitY, _ => Random() };
        return new(to - (direction * (i % 7 == 0 ? 0.1f : 2)), direction);
    }
}
