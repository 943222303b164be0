using System.Numerics;
using RayTracer.Acceleration;

namespace RayTracer.Tests.Acceleration;

[Trait("Category", "Thorough")]
public sealed class TriangleBvhTests
{
    private static readonly TraversalMode[] s_modes = [TraversalMode.Single, TraversalMode.Blocks, TraversalMode.Sorted, TraversalMode.Automatic];

    public static TheoryData<string> Meshes =>
    [
        "empty", "one", "nine", "soup", "dense soup", "terrain", "needles", "equal", "layers", "huge", "tiny", "far away", "flat", "scales", "faulty",
    ];

    [Theory]
    [MemberData(nameof(Meshes))]
    public void Every_mode_finds_the_hits_of_testing_every_triangle(string name)
    {
        for (int round = 0; round < TestSettings.Scale(1, 15); round++)
        {
            int seed = TestSettings.Seed + (1000 * round);
            TestMesh mesh = TestMesh.Named(name, seed);
            TestRays rays = TestRays.Around(mesh, 1500, seed + 1);
            TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 2);
            (float[] distance, int[] primitive) = BruteForce.Closest(mesh, rays);
            if (mesh.Count > 8)
            {
                Assert.InRange(primitive.Count(p => p >= 0), rays.Count / 20, rays.Count);
            }

            foreach (TraversalMode mode in s_modes)
            {
                TestRays closest = rays.Traced(tree, any: false, mode);
                Assert.Equal(primitive, closest.Primitive);
                Assert.Equal(distance.Select(BitConverter.SingleToInt32Bits), closest.Distance.Select(BitConverter.SingleToInt32Bits));
                TestRays any = rays.Traced(tree, any: true, mode);
                Assert.Equal(primitive.Select(p => p >= 0 ? 0 : -1), any.Primitive);
            }
        }
    }

    [Theory]
    [InlineData("soup")]
    [InlineData("terrain")]
    public void Hits_are_those_of_an_ordinary_test_in_double_precision(string name)
    {
        TestMesh mesh = TestMesh.Named(name, TestSettings.Seed);
        TestRays rays = TestRays.Around(mesh, 1000, TestSettings.Seed + 5);
        TestRays found = rays.Traced(TriangleBvh.Build(mesh.Positions, mesh.Indices, 1), any: false, TraversalMode.Blocks);
        int compared = 0;
        for (int ray = 0; ray < rays.Count; ray++)
        {
            (double distance, double margin) = OrdinaryTest.Closest(mesh, rays.Origin(ray), rays.Direction(ray), rays.Distance[ray]);
            if (margin > 1e-3)
            {
                // No edge of any triangle near: there is nothing to argue about.
                compared++;
                Assert.Equal(double.IsFinite(distance), found.Primitive[ray] >= 0);
                Assert.True(!double.IsFinite(distance) || Math.Abs((found.Distance[ray] / distance) - 1) < 1e-4, $"ray {ray}: {found.Distance[ray]}, not {distance}");
            }
        }

        Assert.InRange(compared, rays.Count / 10, rays.Count);
    }

    [Fact]
    public void Of_equally_near_triangles_the_lowest_number_is_hit()
    {
        TestMesh mesh = TestMesh.Named("equal", 0);
        TestRays rays = TestRays.Around(mesh, 1000, TestSettings.Seed);
        TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 1);
        foreach (TraversalMode mode in s_modes)
        {
            int[] primitives = rays.Traced(tree, any: false, mode).Primitive;
            Assert.Contains(0, primitives);
            Assert.All(primitives, p => Assert.InRange(p, -1, 0));
        }
    }

    [Fact]
    public void Single_rays_agree_with_streams()
    {
        TestMesh mesh = TestMesh.Named("soup", TestSettings.Seed);
        TestRays rays = TestRays.Around(mesh, 500, TestSettings.Seed);
        TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 1);
        TestRays stream = rays.Traced(tree, any: false, TraversalMode.Blocks);
        for (int ray = 0; ray < rays.Count; ray++)
        {
            float distance = rays.Distance[ray];
            bool hit = tree.ClosestHit(rays.Origin(ray), rays.Direction(ray), ref distance, out int primitive);
            Assert.Equal((stream.Primitive[ray] >= 0, stream.Primitive[ray], stream.Distance[ray]), (hit, primitive, distance));
            Assert.Equal(hit, tree.AnyHit(rays.Origin(ray), rays.Direction(ray), rays.Distance[ray]));
        }
    }

    [Fact]
    public void Rays_without_sense_hit_nothing()
    {
        TestMesh mesh = TestMesh.Named("soup", 1);
        TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 1);
        float[] bad = [float.NaN, float.PositiveInfinity, float.NegativeInfinity];
        List<(Vector3, Vector3, float)> rays = [(new(0f), new(0f), 1f), (new(0f), new(1f), 0f), (new(0f), new(1f), -1f), (new(0f), new(1f), float.NaN)];
        foreach (float f in bad)
        {
            rays.AddRange([(new(f, 0, 0), new(1f), 9f), (new(0, f, 0), new(1f), 9f), (new(0, 0, f), new(1f), 9f)]);
            rays.AddRange([(new(0f), new(f, 1, 1), 9f), (new(0f), new(1, f, 1), 9f), (new(0f), new(1, 1, f), 9f)]);
        }

        foreach (TraversalMode mode in s_modes)
        {
            Assert.All(new TestRays(rays).Traced(tree, any: false, mode).Primitive, p => Assert.Equal(-1, p));
            Assert.All(new TestRays(rays).Traced(tree, any: true, mode).Primitive, p => Assert.Equal(-1, p));
        }
    }

    [Fact]
    public void Hits_count_above_zero_and_below_the_limit()
    {
        TriangleBvh tree = TriangleBvh.Build([new(-1f, -1f, 2f), new(1f, -1f, 2f), new(0f, 1f, 2f)], [0, 1, 2], 1);
        Assert.False(tree.AnyHit(new(0f), Vector3.UnitZ, 2f));
        Assert.True(tree.AnyHit(new(0f), Vector3.UnitZ, MathF.BitIncrement(2f)));
        Assert.False(tree.AnyHit(new(0f, 0f, 2f), Vector3.UnitZ, 9f));
        Assert.False(tree.AnyHit(new(0f, 0f, 3f), Vector3.UnitZ, 9f));
        Assert.True(tree.AnyHit(new(0f, 0f, 3f), -Vector3.UnitZ, 9f));
        float distance = float.PositiveInfinity;
        Assert.True(tree.ClosestHit(new(0f), 4f * Vector3.UnitZ, ref distance, out _));
        Assert.Equal(0.5f, distance);
    }

    [Fact]
    public void Triangles_that_cannot_be_hit_stay_outside()
    {
        TestMesh mesh = TestMesh.Named("faulty", 3);
        Assert.Equal(mesh.Count - 9, TriangleBvh.Build(mesh.Positions, mesh.Indices, 1).Count);
        Assert.Throws<ArgumentException>(() => TriangleBvh.Build(mesh.Positions, [0, 1], 1));
    }

    [Theory]
    [InlineData("soup")]
    [InlineData("terrain")]
    public void Cost_counts_nodes_and_triangles(string name)
    {
        TestMesh mesh = TestMesh.Named(name, 2);
        TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 1);
        TestRays rays = TestRays.Around(mesh, 200, 2);
        long most = 0;
        for (int ray = 0; ray < rays.Count; ray++)
        {
            long cost = tree.Cost(rays.Origin(ray), rays.Direction(ray), rays.Distance[ray]);
            Assert.InRange(cost, 1, tree.Statistics.Nodes + tree.Count);
            most = Math.Max(most, cost);
        }

        // Far less than all triangles, and more than a way to one leaf.
        Assert.InRange(most, tree.Statistics.Depth, mesh.Count / 4);
    }

    [Theory]
    [InlineData(1f, 0f)]
    [InlineData(1e-6f, 0f)]
    [InlineData(1e6f, 3e6f)]
    public void Closed_surfaces_do_not_leak(float scale, float away)
    {
        TestMesh mesh = TestMesh.Ball(12, TestSettings.Seed).Scaled(scale).Moved(new(away, -away, 0.5f * away));
        TriangleBvh tree = TriangleBvh.Build(mesh.Positions, mesh.Indices, 2);
        Vector3 middle = new(away, -away, 0.5f * away);
        Random random = new(TestSettings.Seed);
        int left = TestSettings.Scale(30_000, 1_500_000);
        while (left > 0)
        {
            int count = Math.Min(left, 20_000);
            left -= count;
            TestRays rays = new([.. Enumerable.Range(0, count).Select(i => AtEdge(mesh, middle, scale, i, random))]);
            foreach (TraversalMode mode in new[] { TraversalMode.Single, TraversalMode.Blocks, TraversalMode.Sorted })
            {
                Assert.DoesNotContain(-1, rays.Traced(tree, any: true, mode).Primitive);
                Assert.DoesNotContain(-1, rays.Traced(tree, any: false, mode).Primitive);
            }
        }
    }

    /// <summary>A ray from within a ball to a corner or a point of an edge, and on.</summary>
    private static (Vector3 Origin, Vector3 Direction, float Limit) AtEdge(TestMesh mesh, Vector3 middle, float scale, int ray, Random random)
    {
        int triangle = random.Next(mesh.Count);
        int corner = random.Next(3);
        float along = (ray % 4) switch { 0 => 0f, 1 => 0.5f, _ => random.NextSingle() };
        Vector3 target = Vector3.Lerp(mesh.Corner(triangle, corner), mesh.Corner(triangle, (corner + 1) % 3), along);
        Vector3 start = ray % 3 == 0 ? middle : middle + (scale * 0.3f * new Vector3(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f));
        return (start, target - start, float.PositiveInfinity);
    }
}
