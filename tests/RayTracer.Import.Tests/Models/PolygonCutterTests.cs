using System.Numerics;
using RayTracer.Import;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

public class PolygonCutterTests
{
    public static TheoryData<string, Vector2[]> Polygons => new()
    {
        { "arrow, concave at its first corner", [new(1, 1), new(0, 0), new(4, 1), new(0, 2)] },
        { "arrow, concave at its second corner", [new(0, 2), new(1, 1), new(0, 0), new(4, 1)] },
        { "arrow, concave at its last corner", [new(0, 0), new(4, 1), new(0, 2), new(1, 1)] },
        { "L", [new(0, 0), new(2, 0), new(2, 1), new(1, 1), new(1, 3), new(0, 3)] },
        { "star", [.. Enumerable.Range(0, 10).Select(i => (i % 2 == 0 ? 1 : 0.3f) * new Vector2(MathF.Cos(i * MathF.PI / 5), MathF.Sin(i * MathF.PI / 5)))] },
        { "comb", [new(9, -1), new(9, 3), .. Enumerable.Range(0, 17).Select(i => new Vector2(8.5f - (i / 2f), i % 2 == 0 ? 0 : 3)), new(0, -1)] },
        { "square with corners on its sides", [new(0, 0), new(1, 0), new(2, 0), new(2, 1), new(2, 2), new(1, 2), new(0, 2), new(0, 1)] },
        { "frame around a hole, joined by a bridge", [new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(0, 0), new(1, 1), new(1, 3), new(3, 3), new(3, 1), new(1, 1)] },
        { "spiral", [.. Enumerable.Range(0, 40).Select(i => Spiral(i, 1)), .. Enumerable.Range(0, 40).Reverse().Select(i => Spiral(i, 0.7f))] },
    };

    // Triangles that all turn as the polygon does, and whose areas sum up to its own, neither overlap nor leave anything out; in any plane and from either side.
    [Theory]
    [MemberData(nameof(Polygons), DisableDiscoveryEnumeration = true)]
    public void Triangles_cover_a_polygon_exactly(string name, Vector2[] polygon)
    {
        double area = Area(polygon);
        var cutter = new PolygonCutter();
        foreach (Func<Vector2, Vector3> place in new Func<Vector2, Vector3>[] { p => new(p.X, p.Y, 7), p => new(p.Y, p.X, 0.1f * p.X), p => new(3, p.X, p.Y), p => new(p.X, -2, p.Y), p => new(p.X, p.Y, p.X + p.Y) })
        {
            List<int> triangles = [];
            cutter.Cut([.. polygon.Select(place)], triangles);
            Assert.Equal(3 * (polygon.Length - 2), triangles.Count);
            double[] areas = [.. triangles.Chunk(3).Select(t => Area([.. t.Select(i => polygon[i])]) * Math.Sign(area))];
            Assert.All(areas, a => Assert.True(a >= -1e-6, name));
            Assert.Equal(Math.Abs(area), areas.Sum(), 1e-4);
        }

        Assert.Equal(0, cutter.Unresolved);
    }

    [Fact]
    public void Convex_polygons_are_cut_like_a_fan()
    {
        List<int> triangles = [];
        new PolygonCutter().Cut([new(0, 0, 0), new(1, 0, 0), new(2, 1, 0), new(1, 2, 0), new(0, 1, 0)], triangles);
        Assert.Equal([0, 1, 2, 0, 2, 3, 0, 3, 4], triangles);
    }

    [Fact]
    public void Polygons_that_cut_themselves_have_no_area_or_are_no_numbers_give_their_number_of_triangles()
    {
        var cutter = new PolygonCutter();
        foreach (Vector3[] polygon in new Vector3[][]
        {
            [new(0, 0, 0), new(1, 1, 0), new(3, 0, 0), new(0, 3, 0), new(2, -1, 0)], [.. Enumerable.Repeat(Vector3.One, 6)],
            [new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(3, 0, 0)], [new(float.NaN, 0, 0), new(1, 0, 0), new(2, float.PositiveInfinity, 0), new(3, 0, 0)],
            [.. Enumerable.Range(0, 3000).Select(i => new Vector3(i * 7919 % 1000, i * 104729 % 997, 0))],
        })
        {
            List<int> triangles = [];
            cutter.Cut(polygon, triangles);
            Assert.Equal(3 * (polygon.Length - 2), triangles.Count);
            Assert.All(triangles, t => Assert.InRange(t, 0, polygon.Length - 1));
        }

        Assert.InRange(cutter.Unresolved, 1, 2);
    }

    private static Vector2 Spiral(int i, float factor) => factor * (1 + (i * 0.1f)) * new Vector2(MathF.Cos(i * 0.3f), MathF.Sin(i * 0.3f));

    private static double Area(Vector2[] p) => p.Select((a, i) => (a, b: p[(i + 1) % p.Length])).Sum(e => ((double)e.a.X * e.b.Y) - ((double)e.a.Y * e.b.X)) / 2;
}
