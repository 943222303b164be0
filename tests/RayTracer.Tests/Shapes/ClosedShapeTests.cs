using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Tests.Shapes;

/// <summary>
/// No ray leaves a closed shape, even if it is aimed at an edge or a corner.
/// Covers `RayOffset` and `ShapeBatch`.
/// </summary>
[Trait("Category", "Thorough")]
public class ClosedShapeTests
{
    private static readonly Material s_material = new DiffuseMaterial(new SolidTexture(Rgb.White));

    public static TheoryData<string, float> Shapes()
    {
        TheoryData<string, float> cases = [];
        foreach (string name in new[] { "tetrahedron", "cube", "icosahedron", "box of rectangles", "sphere" })
        {
            foreach (float away in new[] { 0f, 3f, 100f })
            {
                cases.Add(name, away);
            }
        }

        return cases;
    }

    [Theory]
    [MemberData(nameof(Shapes))]
    public void No_ray_leaks_out_of_a_closed_shape(string name, float away)
    {
        Random random = new(TestSettings.Seed);
        int turns = TestSettings.Scale(20, 200);
        for (int turn = 0; turn < turns; turn++)
        {
            (Vector3[] corners, Shape[] faces, (int A, int B)[] edges) = Make(name, away, random);
            ShapeBatch batch = faces[0].CreateBatch(faces);
            for (int packet = 0; packet < 1000; packet++)
            {
                AimAtEdges(corners, edges, random, out Vec3W origin, out Vec3W direction);
                FloatW distance = float.PositiveInfinity;
                UIntW primitive = 99u;
                batch.ClosestHit(origin, direction, ref distance, ref primitive);
                Assert.False(UIntW.Equal(primitive, 99u).Any, "a ray met nothing");
                MaskW free = MaskW.All;
                batch.Occlude(origin, direction, 1000f, skip: -1, ref free);
                Assert.False(free.Any, "a segment was free");
            }
        }
    }

    // From random points inside towards points of edges and corners, as near as floats come to them.
    private static void AimAtEdges(Vector3[] corners, (int A, int B)[] edges, Random random, out Vec3W origin, out Vec3W direction)
    {
        Span<float> numbers = stackalloc float[6 * FloatW.Count];
        Vector3 center = corners.Aggregate(Vector3.Zero, (sum, c) => sum + (c / corners.Length));
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            float[] weights = [.. corners.Select(_ => -MathF.Log(1 - random.NextSingle()))];
            Vector3 inside = corners.Zip(weights).Aggregate(Vector3.Zero, (sum, c) => sum + (c.First * (c.Second / weights.Sum())));
            Vector3 from = Vector3.Lerp(center, inside, 0.9f);
            (int a, int b) = edges[random.Next(edges.Length)];
            Vector3 target = random.Next(4) == 0 ? corners[a] : Vector3.Lerp(corners[a], corners[b], random.NextSingle());
            Vector3 towards = Vector3.Normalize(target - from);
            for (int axis = 0; axis < 3; axis++)
            {
                numbers[(axis * FloatW.Count) + lane] = from[axis];
                numbers[((axis + 3) * FloatW.Count) + lane] = towards[axis];
            }
        }

        origin = new(Lanes(numbers, 0), Lanes(numbers, 1), Lanes(numbers, 2));
        direction = new(Lanes(numbers, 3), Lanes(numbers, 4), Lanes(numbers, 5));
    }

    private static FloatW Lanes(Span<float> numbers, int row) => new(new Vector<float>(numbers[(row * FloatW.Count)..]));

    private static (Vector3[] Corners, Shape[] Faces, (int A, int B)[] Edges) Make(string name, float away, Random random)
    {
        float Uniform() => (2 * random.NextSingle()) - 1;
        Quaternion turn = Quaternion.CreateFromYawPitchRoll(3 * Uniform(), 3 * Uniform(), 3 * Uniform());
        Vector3 place = new Vector3(Uniform(), Uniform(), Uniform()) * away;
        float size = 0.75f + (0.5f * random.NextSingle());
        if (name is "box of rectangles" or "sphere")
        {
            // Rectangles parallel to the axes have corners that are floats.
            turn = Quaternion.Identity;
        }

        Vector3[] corners = [.. CornersOf(name).Select(c => Vector3.Transform(c * size, turn) + place)];
        (int, int)[] edges = [.. EdgesOf(corners)];
        Shape[] faces = name switch
        {
            "sphere" => [new Sphere(s_material, "", place, Vector3.Distance(corners[0], place) * 1.001f)],
            "box of rectangles" => [.. Box(corners)],
            _ => [.. Triangles(name, corners).Select(f => new Triangle(s_material, "", corners[f.A], corners[f.B], corners[f.C], default, default, default))],
        };
        return (corners, faces, edges);
    }

    private static IEnumerable<Shape> Box(Vector3[] corners)
    {
        Vector3 size = corners[7] - corners[0];
        Vector3 center = (corners[7] + corners[0]) / 2;
        foreach (Vector3 axis in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ })
        {
            for (int side = -1; side <= 1; side += 2)
            {
                // Width and height are along the rectangle's own axes.
                Plane whole = new(s_material, "", center + (axis * size * (0.5f * side)), axis * side, null);
                Vector2 extent = new(Vector3.Dot(Vector3.Abs(whole.Tangent), size), Vector3.Dot(Vector3.Abs(whole.Bitangent), size));
                yield return new Plane(s_material, "", whole.Point, whole.Normal, extent);
            }
        }
    }

    private static Vector3[] CornersOf(string name)
    {
        float golden = (1 + MathF.Sqrt(5)) / 2;
        return name switch
        {
            "tetrahedron" => [new(1, 1, 1), new(1, -1, -1), new(-1, 1, -1), new(-1, -1, 1)],
            "icosahedron" => [.. from a in new[] { -1f, 1f } from b in new[] { -golden, golden } from c in new[] { new Vector3(0, a, b), new(a, b, 0), new(b, 0, a) } select c],
            _ => [.. Enumerable.Range(0, 8).Select(i => new Vector3(((i & 1) * 2) - 1, (i & 2) - 1, ((i & 4) >> 1) - 1))],
        };
    }

    // The shortest distances between corners.
    private static IEnumerable<(int A, int B)> EdgesOf(Vector3[] corners)
    {
        float shortest = corners.Skip(1).Min(c => Vector3.Distance(c, corners[0]));
        return from i in Enumerable.Range(0, corners.Length)
               from j in Enumerable.Range(i + 1, corners.Length - i - 1)
               where Vector3.Distance(corners[i], corners[j]) < 1.1f * shortest
               select (i, j);
    }

    private static IEnumerable<(int A, int B, int C)> Triangles(string name, Vector3[] corners)
    {
        if (name == "cube")
        {
            // Two triangles a face, which share a diagonal.
            int[][] faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
            return faces.SelectMany(f => new[] { (f[0], f[1], f[2]), (f[0], f[2], f[3]) });
        }

        HashSet<(int, int)> edges = [.. EdgesOf(corners)];
        return from i in Enumerable.Range(0, corners.Length)
               from j in Enumerable.Range(0, corners.Length)
               from k in Enumerable.Range(0, corners.Length)
               where edges.Contains((i, j)) && edges.Contains((j, k)) && edges.Contains((i, k))
               select (i, j, k);
    }
}
