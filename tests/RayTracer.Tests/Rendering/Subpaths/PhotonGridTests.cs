using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Which vertices of light paths are merged. Covers `PhotonGrid`.</summary>
public sealed unsafe class PhotonGridTests
{
    [Theory]
    [InlineData(0.03f)]
    [InlineData(0.1f)]
    [InlineData(0.45f)]
    public void All_vertices_near_a_point_are_found_once_but_those_in_media(float radius)
    {
        Random random = new(TestSettings.Seed + 3);
        Vector3 Anywhere() => new(Random(random), Random(random), Random(random));
        const int Paths = 900;
        LightVertex[] all = [.. Enumerable.Range(0, 3 * Paths).Select(i => new LightVertex
        {
            // Half of them on a plane, where grids have their edges.
            Point = i % 2 == 0 ? Anywhere() : Anywhere() with { Y = 0 },
            Path = (uint)(i / 3),
            State = (uint)(i % 3) | (i % 7 < 2 ? PathState.IsInMedium : 0),
            Power = new(i, 0, 0),
        })];
        LightVertices vertices = new(Paths);
        vertices.SetBlock(0, all);
        vertices.Join(threads: 1);
        PhotonGrid grid = new();
        grid.Build(vertices, radius);
        List<uint>[] found = [.. Enumerable.Range(0, FloatW.Count).Select(_ => new List<uint>())];
        int most = 0;
        for (int i = 0; i < 60; i++)
        {
            Vector3[] points = [.. Enumerable.Range(0, FloatW.Count).Select(_ => i % 2 == 0 ? Anywhere() : Anywhere() with { Y = 0 })];
            Assert.Equal(grid.Find(Load(points), MaskW.All, found), found.Max(f => f.Count));
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                HashSet<int> numbers = [.. found[lane].Select(f => (int)grid.Photons[f].Power.R)];
                Assert.Equal(found[lane].Count, numbers.Count);
                for (int v = 0; v < all.Length; v++)
                {
                    // Rounding decides on the circle itself.
                    double distance = (all[v].Point - points[lane]).Length();
                    bool isOn = Math.Abs(distance - radius) < 1e-4 * radius;
                    if (!isOn && numbers.Contains(v) != (distance < radius && v % 7 >= 2))
                    {
                        Assert.Fail($"vertex {v}, {distance} from {points[lane]}");
                    }
                }

                most = Math.Max(most, numbers.Count);
            }
        }

        Assert.True(most > (radius > 0.05f ? 3 : 0));
    }

    [Fact]
    public void Vertices_of_light_paths_are_found_again_where_they_are_on_surfaces()
    {
        Scene scene = TestScenes.Build("""
            {
              "camera": { "position": [0, 1, 4], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
              "render": { "integrator": "vcm", "width": 24, "height": 24, "samplesPerPixel": 4, "maxDepth": 6, "mergeRadius": 0.1 },
              "shapes": [
                { "type": "box", "a": [-2, -1, -2], "b": [2, 2, 2], "material": { "type": "invisible", "interior": { "extinction": [0.5, 0.7, 0.9], "albedo": [0.9, 0.9, 0.9] } } },
                { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
                { "type": "point", "position": [0.3, 1, 0.2], "intensity": [3, 3, 3] }
              ]
            }
            """);
        LightPass pass = new(scene, new(), threads: 1, seed: 7);
        Assert.True(pass.Trace(0, default));
        List<uint>[] found = [.. Enumerable.Range(0, FloatW.Count).Select(_ => new List<uint>())];
        int[] counts = [0, 0];
        for (int i = 0; i < Math.Min(pass.Vertices.Count, 1000); i++)
        {
            LightVertex vertex = pass.Vertices.Vertices[i];
            bool isOnSurface = vertex.Primitive < scene.World.Count;
            pass.Photons!.Find(vertex.Point, MaskW.First(1), found);
            Assert.Equal(isOnSurface ? 1 : 0, found[0].Count(f => pass.Photons.Photons[f].Point == vertex.Point));
            counts[isOnSurface ? 1 : 0]++;
        }

        Assert.All(counts, c => Assert.True(c > 50, $"{counts[0]} in fog, {counts[1]} on surfaces"));
    }

    private static float Random(Random random) => (2 * random.NextSingle()) - 1;

    private static Vec3W Load(Vector3[] points)
    {
        float[][] lanes = [[.. points.Select(p => p.X)], [.. points.Select(p => p.Y)], [.. points.Select(p => p.Z)]];
        return new(new(new Vector<float>(lanes[0])), new(new Vector<float>(lanes[1])), new(new Vector<float>(lanes[2])));
    }
}
