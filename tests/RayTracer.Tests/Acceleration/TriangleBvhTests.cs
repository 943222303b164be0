using System.Numerics;
using RayTracer.Acceleration;

namespace RayTracer.Tests.Acceleration;

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
        for (int round = 0; round < TestSettings.Scale(1, 20); round++)
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
}
