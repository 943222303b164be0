using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Tests.Shapes;

[Trait("Category", "Thorough")]
public class MeshDoctorTests
{
    private static readonly Vector3[] s_square = [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)];

    [Fact]
    public void A_sound_mesh_is_left_as_it_is()
    {
        MeshData mesh = new(s_square, [0, 1, 2, 0, 2, 3]);
        MeshData mended = MeshDoctor.Mend(mesh, out string report);
        Assert.Equal("", report);
        Assert.Same(mesh.Indices, mended.Indices);
        Assert.Same(mesh.Positions, mended.Positions);
    }

    [Theory]
    [InlineData(new[] { 0, 1, 2, 0, 2, 4 }, "1 triangle whose corners do not exist dropped")]
    [InlineData(new[] { 0, 1, 2, 0, -1, 2, 7, 8, 9 }, "2 triangles whose corners do not exist dropped")]
    [InlineData(new[] { 0, 1, 2, 0, 0, 2, 1, 1, 1 }, "2 triangles without area dropped")]
    [InlineData(new[] { 0, 1, 2, 1, 2, 0, 2, 0, 1 }, "2 duplicate triangles dropped")]
    [InlineData(new[] { 0, 1, 2, 3 }, "the last 1 corner made no triangle and was dropped")]
    public void Triangles_that_cannot_be_used_are_dropped_and_counted(int[] indices, string expected)
    {
        MeshData mended = MeshDoctor.Mend(new(s_square, indices), out string report);
        Assert.Equal(expected, report);
        Assert.Equal([0, 1, 2], mended.Indices);
    }

    [Fact]
    public void Triangles_on_a_line_are_dropped_whatever_products_are_rounded_to()
    {
        // A fused cross product of parallel vectors is not zero.
        Vector3[] corners = [new(0.43615657f, 0.4966272f, 0.78528684f), new(1e-45f, 0.7706009f, 0.932166f), new(0.1293f, 0.826f, 0.3f)];
        MeshData mended = MeshDoctor.Mend(new(corners, [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 2]), out string report);
        Assert.Equal("3 triangles without area dropped", report);
        Assert.Equal([0, 1, 2], mended.Indices);
    }

    [Fact]
    public void The_back_of_a_triangle_is_no_duplicate()
    {
        MeshData mended = MeshDoctor.Mend(new(s_square, [0, 1, 2, 0, 2, 1]), out string report);
        Assert.Equal("", report);
        Assert.Equal(2, mended.TriangleCount);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Corners_that_are_no_numbers_take_their_triangles_with_them(float number)
    {
        MeshData mended = MeshDoctor.Mend(new([.. s_square, new(0, number, 0)], [0, 1, 4, 0, 1, 2]), out string report);
        Assert.Equal("1 triangle whose corners are no finite numbers dropped", report);
        Assert.Equal([0, 1, 2], mended.Indices);
    }

    [Fact]
    public void A_mesh_of_nothing_but_faults_is_empty()
    {
        MeshData mended = MeshDoctor.Mend(new([], [0, 1, 2]), out string report);
        Assert.Equal("1 triangle whose corners do not exist dropped; there is no triangle in it", report);
        Assert.Equal(0, mended.TriangleCount);
    }

    [Fact]
    public void Normals_without_a_direction_are_those_of_the_triangles_around()
    {
        MeshData mesh = new(s_square, [0, 1, 2, 0, 2, 3]) { Normals = [new(0, 0, 2), default, new(float.NaN, 0, 0), new(0, 1, 1)] };
        MeshData mended = MeshDoctor.Mend(mesh, out string report);
        Assert.Equal("2 normals without a direction computed from the triangles around", report);
        Assert.Equal([new(0, 0, 1), new(0, 0, 1), new(0, 0, 1), new Vector3(0, 1, 1).Unit()], mended.Normals!);
    }

    [Fact]
    public void Lists_that_are_too_short_are_left_out()
    {
        MeshData mesh = new(s_square, [0, 1, 2, 0, 2, 3]) { Uv = [default], Colors = [default, new(float.NaN, 0, 0), default, new(0, -1, 0)], MaterialOfTriangle = [1] };
        MeshData mended = MeshDoctor.Mend(mesh, out string report);
        Assert.Equal("1 triangle without a material of its own made of the first; 3 corners without uv: all uv left out; 2 colours that cannot be used replaced by zeros", report);
        Assert.Null(mended.Uv);
        Assert.Equal(default, mended.Colors![1]);
        Assert.Equal([1, 0], mended.MaterialOfTriangle!);
    }

    [Fact]
    public void The_few_triangles_that_face_otherwise_than_their_neighbours_are_turned()
    {
        // A grid of 5 × 4 squares, of which two triangles are wound the wrong way, and one that touches none of them.
        (MeshData mesh, int[] sound) = Grid(welded: true);
        MeshData mended = MeshDoctor.Mend(mesh, out string report);
        Assert.Equal("2 triangles that faced otherwise than their neighbours turned", report);
        Assert.Equal(sound.Length, mended.Indices.Length);
        Assert.All(Enumerable.Range(0, mended.TriangleCount), t => Assert.True(Facing(mended, t) > 0));
    }

    [Fact]
    public void Neighbours_are_known_by_where_their_corners_are()
    {
        (MeshData mesh, _) = Grid(welded: false);
        MeshData mended = MeshDoctor.Mend(mesh, out string report);
        Assert.Equal("2 triangles that faced otherwise than their neighbours turned", report);
        Assert.All(Enumerable.Range(0, mended.TriangleCount), t => Assert.True(Facing(mended, t) > 0));
    }

    [Fact]
    public void A_band_with_a_twist_is_reported_and_kept()
    {
        // Möbius: five squares in a ring, the last one joined upside down.
        Vector3[] corners = [.. Enumerable.Range(0, 5).SelectMany(i => new[] { At(i, -1), At(i, 1) })];
        int[] indices = [.. Enumerable.Range(0, 5).SelectMany(i =>
        {
            (int a, int b) = (2 * i, (2 * i) + 1);
            (int c, int d) = i < 4 ? (a + 2, b + 2) : (1, 0);
            return new[] { a, c, d, a, d, b };
        })];
        MeshData mended = MeshDoctor.Mend(new(corners, indices), out string report);
        Assert.Contains("the sides that neighbours face cannot be made to agree", report, StringComparison.Ordinal);
        Assert.Equal(10, mended.TriangleCount);

        static Vector3 At(int i, float side)
        {
            (float s, float c) = MathF.SinCos(2 * MathF.PI * i / 5);
            (float hs, float hc) = MathF.SinCos(MathF.PI * i / 5);
            return new((3 + (side * hc)) * c, (3 + (side * hc)) * s, side * hs);
        }
    }

    [Fact]
    public void Any_numbers_make_a_mesh_without_a_crash()
    {
        Random random = new(TestSettings.Seed);
        float[] odd = [0, -0f, 1, float.NaN, float.PositiveInfinity, float.MaxValue, -float.MaxValue, float.Epsilon, 1e-30f];
        for (int round = 0; round < TestSettings.Scale(500, 20000); round++)
        {
            Vector3[] positions = [.. Enumerable.Range(0, random.Next(12)).Select(_ => Any())];
            int[] indices = [.. Enumerable.Range(0, random.Next(60)).Select(_ => random.Next(-1, 13))];
            MeshData mesh = new(positions, indices)
            {
                Normals = random.Next(2) == 0 ? null : [.. Enumerable.Range(0, random.Next(14)).Select(_ => Any())],
                Uv = random.Next(2) == 0 ? null : [.. Enumerable.Range(0, random.Next(14)).Select(_ => new Vector2(Any().X, 0))],
                MaterialOfTriangle = random.Next(2) == 0 ? null : [.. Enumerable.Range(0, random.Next(25)).Select(_ => random.Next(-3, 3))],
            };
            MeshData mended = MeshDoctor.Mend(mesh, out _);
            Assert.All(mended.Indices, i => Assert.True(mended.Positions[i].IsFinite()));
            Assert.True(mended.Normals is null || mended.Normals.Length >= mended.Positions.Length);
            Assert.Equal("", Again(mended));
        }

        Vector3 Any() => new(Pick(), Pick(), Pick());
        float Pick() => random.Next(4) == 0 ? odd[random.Next(odd.Length)] : random.NextSingle();
    }

    // What is mended has no fault that could be mended once more; normals of corners in no triangle may still be zero.
    private static string Again(MeshData mended)
    {
        MeshDoctor.Mend(mended, out string report);
        return string.Join("; ", report.Split("; ").Where(f => !f.StartsWith("at ", StringComparison.Ordinal) && !f.StartsWith("there is", StringComparison.Ordinal) && !f.Contains("normal", StringComparison.Ordinal)));
    }

    private static float Facing(MeshData mesh, int triangle)
    {
        Vector3 a = mesh.Positions[mesh.Indices[3 * triangle]];
        return (mesh.Positions[mesh.Indices[(3 * triangle) + 1]] - a).Cross(mesh.Positions[mesh.Indices[(3 * triangle) + 2]] - a).Z;
    }

    private static (MeshData Mesh, int[] Sound) Grid(bool welded)
    {
        Vector3[] corners = [.. Enumerable.Range(0, 30).Select(i => new Vector3(i % 6, i / 6, 0))];
        int[] sound = [.. Enumerable.Range(0, 20).SelectMany(i =>
        {
            int a = (i % 5) + (6 * (i / 5));
            return new[] { a, a + 1, a + 7, a, a + 7, a + 6 };
        })];
        int[] indices = [.. sound];
        foreach (int wrong in new[] { 7, 22 })
        {
            (indices[3 * wrong], indices[(3 * wrong) + 1]) = (indices[(3 * wrong) + 1], indices[3 * wrong]);
        }

        MeshData mesh = welded ? new(corners, indices) : new([.. indices.Select(i => corners[i])], [.. Enumerable.Range(0, indices.Length)]);
        return (mesh, sound);
    }
}
