using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Tests.Shapes;

/// <summary>
/// Subdivision against the limits that are known in closed form, and against Euler's formula; displacement; creases.
/// Covers `Subdivision`, `MeshRefiner`, `PolygonMesh`, `MeshTopology`.
/// </summary>
public class RefinementTests
{
    private static readonly MeshData s_octahedron = new(
        [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1)],
        [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5]);

    // Quadrilaterals as pairs of triangles, which share no corner with those of other faces and have uv from 0 to 1.
    private static readonly MeshData s_cube = Cube();

    private static readonly MeshData s_square = new([new(-1, -1, 0), new(1, -1, 0), new(1, 1, 0), new(-1, 1, 0)], [0, 1, 2, 0, 2, 3])
    {
        Uv = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)],
        FaceOfTriangle = [0, 0],
    };

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Loops_octahedron_keeps_Eulers_number_and_its_corners_have_their_limit(int levels)
    {
        MeshData fine = Refine(s_octahedron, new() { Subdivide = levels, Scheme = SubdivisionScheme.Loop });
        Assert.Equal(8 << (2 * levels), fine.TriangleCount);
        AssertClosed(fine, euler: 2);

        // Warren's weight is 3/32 for four neighbours, so that the limit is v (1 − 4/8) and an eighth of their sum, which is 0.
        Assert.Contains(fine.Positions, p => (p - new Vector3(0.5f, 0, 0)).Norm() < 1e-6f);
        Assert.Equal(0.5f, fine.Positions.Max(p => float.Max(p.X, float.Max(p.Y, p.Z))), 1e-6f);
        Assert.All(fine.Normals!.Zip(fine.Positions), pair => Assert.True(pair.First.Dot(pair.Second.Unit()) > 0.9f));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(4)]
    public void Catmull_and_Clarks_cube_keeps_Eulers_number_and_its_corners_have_their_limit(int levels)
    {
        MeshData fine = Refine(s_cube, new() { Subdivide = levels });
        Assert.Equal(12 << (2 * levels), fine.TriangleCount);
        AssertClosed(fine, euler: 2);

        // (9 v + 4 Σ neighbours + Σ diagonals) / 24 = (9 + 4 − 1) / 24.
        Assert.Contains(fine.Positions, p => (p - new Vector3(0.5f, 0.5f, 0.5f)).Norm() < 1e-5f);

        // The middle of a face, by the mask of four once the cube is cut: (16 · 1 + 4 · 4 · 3/4 + 4 · 5/9) / 36.
        float reach = fine.Positions.Max(p => p.X);
        Assert.All(new[] { fine.Positions.Max(p => p.Y), fine.Positions.Max(p => p.Z), -fine.Positions.Min(p => p.X) }, r => Assert.Equal(reach, r, 1e-5f));
        Assert.Equal(68f / 81, reach, 1e-5f);
    }

    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.CatmullClark)]
    public void What_lies_on_the_limit_stays_there(SubdivisionScheme scheme)
    {
        MeshData coarse = Refine(Bumpy(), new() { Subdivide = 1, Scheme = scheme });
        MeshData fine = Refine(Bumpy(), new() { Subdivide = 3, Scheme = scheme });
        Assert.All(coarse.Positions, p => Assert.True(fine.Positions.Min(q => (p - q).Norm()) < 2e-6f));
        AssertClosed(coarse, euler: 2);
    }

    [Fact]
    public void Borders_become_cubic_B_splines_and_uv_stay_linear()
    {
        MeshData fine = Refine(s_square, new() { Subdivide = 3 });
        Assert.All(fine.Positions, p => Assert.Equal(0, p.Z));
        Assert.All(fine.Normals!, n => Assert.Equal(1, n.Z, 1e-6f));

        // The corner's limit: a sixth of its neighbours along the border, and two thirds of itself.
        int corner = Array.FindIndex(fine.Uv!, uv => uv == Vector2.One);
        Assert.True((fine.Positions[corner] - new Vector3(2f / 3, 2f / 3, 0)).Norm() < 1e-6f);
        Assert.Equal(81, fine.Uv!.Length);
        Assert.All(fine.Uv, uv => Assert.Equal(uv * 8, new Vector2(float.Round(uv.X * 8), float.Round(uv.Y * 8))));
    }

    [Fact]
    public void A_cube_of_creases_stays_a_cube()
    {
        MeshData fine = Refine(s_cube, new() { Subdivide = 2, CreaseAngle = 60 });
        Assert.Equal(24, Area(fine), 1e-4);
        AssertClosed(fine, euler: 2);
        Assert.All(fine.Normals!, n => Assert.Equal(1, float.Max(float.Abs(n.X), float.Max(float.Abs(n.Y), float.Abs(n.Z))), 1e-6f));
    }

    [Fact]
    public void One_crease_holds_a_roof_and_rounds_the_rest()
    {
        // A ridge along y between two slopes of 45°: the crease stays straight, at the height of the ridge.
        MeshData roof = new([new(-1, -1, 0), new(0, -1, 1), new(0, 1, 1), new(-1, 1, 0), new(1, 1, 0), new(1, -1, 0)], [0, 1, 2, 0, 2, 3, 1, 5, 4, 1, 4, 2]) { FaceOfTriangle = [0, 0, 1, 1] };
        Assert.Equal(1, Refine(roof, new() { Subdivide = 3, CreaseAngle = 80 }).Positions.Max(p => p.Z), 1e-5f);
        Assert.InRange(Refine(roof, new() { Subdivide = 3 }).Positions.Max(p => p.Z), 0.5f, 0.9f);
    }

    [Fact]
    public void A_texture_moves_corners_along_their_normals()
    {
        SolidTexture half = new(new Rgb(0.75f, 0, 0));
        MeshData fine = MeshRefiner.Refine(s_square, new() { Subdivide = 1, Height = 0.4f, Middle = 0.25f }, half, isFlat: false);
        Assert.All(fine.Positions, p => Assert.Equal(0.2f, p.Z, 1e-6f));

        // Of a fine ball, to a ball as much larger.
        MeshData ball = Refine(s_octahedron, new() { Subdivide = 4, Scheme = SubdivisionScheme.Loop });
        MeshData larger = MeshRefiner.Refine(s_octahedron, new() { Subdivide = 4, Scheme = SubdivisionScheme.Loop, Height = 1 }, half, isFlat: false);
        Assert.Equal(0.75f, larger.Positions.Max(p => p.Norm()) - ball.Positions.Max(p => p.Norm()), 1e-3f);
    }

    [Fact]
    public void There_are_no_cracks_where_uv_of_faces_differ()
    {
        MeshData fine = MeshRefiner.Refine(s_cube, new() { Subdivide = 3, Height = 0.1f }, new SlopeTexture(), isFlat: false);
        AssertClosed(fine, euler: 2);
        Assert.True(fine.Positions.Length > fine.Positions.Distinct().Count());
    }

    [Fact]
    public void Smooth_shading_stops_at_creases()
    {
        Assert.All(Refine(s_cube, new()).Normals!, n => Assert.Equal(float.Abs(n.X), float.Abs(n.Z), 1e-6f));
        Assert.All(Refine(s_cube, new() { CreaseAngle = 45 }).Normals!, n => Assert.Equal(1, float.Abs(n.X) + float.Abs(n.Y) + float.Abs(n.Z), 1e-6f));
        Assert.Null(MeshRefiner.Refine(s_cube, new() { Subdivide = 1 }, null, isFlat: true).Normals);
    }

    [Theory]
    [InlineData(""" "refinement": { "subdivide": 2 }""", 192)]
    [InlineData(""" "refinement": { "subdivide": 2, "scheme": "loop" }""", 128)]
    [InlineData(""" "shading": "smooth", "refinement": { "creaseAngle": 30 }""", 8)]
    public void Scenes_ask_for_it(string parameters, int triangles)
    {
        string positions = string.Join(", ", s_octahedron.Positions.Select(p => $"[{p.X}, {p.Y}, {p.Z}]"));
        string corners = string.Join(", ", s_octahedron.Indices.Chunk(3).Select(t => $"[{string.Join(", ", t)}]"));
        Scene scene = TestScenes.Build($$"""{ "shapes": [{ "type": "mesh", "positions": [{{positions}}], "triangles": [{{corners}}], {{parameters}} }] }""");
        Assert.Equal(triangles, scene.World.Itself.Mesh!.Count);
    }

    [Fact]
    public void A_model_is_refined_as_it_says_wherever_else_its_file_is_shown()
    {
        MeshDescription mesh = new() { Data = s_octahedron };
        SceneDescription file = new() { Shapes = [mesh, new InstanceDescription { Of = mesh }] };
        SceneBuilder builder = new(loadModel: _ => new(file, []));
        ModelDescription plain = new() { File = "x" };
        ModelDescription fine = plain with { Refinement = new() { Subdivide = 1, Scheme = SubdivisionScheme.Loop } };
        Scene scene = builder.Build(new() { Shapes = [plain, fine, plain with { Smooth = true }] })!;
        Assert.Equal(8 + 32 + 8, scene.World.Itself.Mesh!.Count);
        Assert.Equal([8, 32, 8], Enumerable.Range(1, 3).Select(i => scene.World.Instances!.SpaceOf(i).Mesh!.Count));
        Assert.Equal([false, true, true], Enumerable.Range(1, 3).Select(i => scene.World.Instances!.SpaceOf(i).Contents.Meshes[0].Data.Normals is not null));
    }

    private static MeshData Refine(MeshData mesh, RefinementDescription wanted) => MeshRefiner.Refine(mesh, wanted, null, isFlat: false);

    // Every edge, by places, once in either direction.
    private static void AssertClosed(MeshData mesh, int euler)
    {
        Vector3[] places = [.. mesh.Positions.Distinct()];
        HashSet<(Vector3, Vector3)> edges = [];
        for (int i = 0; i < mesh.Indices.Length; i++)
        {
            Assert.True(edges.Add((mesh.Positions[mesh.Indices[i]], mesh.Positions[mesh.Indices[i % 3 == 2 ? i - 2 : i + 1]])));
        }

        Assert.All(edges, e => Assert.Contains((e.Item2, e.Item1), edges));
        Assert.Equal(euler, places.Length - (edges.Count / 2) + mesh.TriangleCount);
    }

    private static double Area(MeshData mesh) => mesh.Indices.Chunk(3)
        .Sum(t => (mesh.Positions[t[1]] - mesh.Positions[t[0]]).Cross(mesh.Positions[t[2]] - mesh.Positions[t[0]]).Norm() / 2);

    private static MeshData Bumpy() => new([.. s_octahedron.Positions.Select((p, i) => p * (1 + (0.2f * i)))], s_octahedron.Indices);

    private static MeshData Cube()
    {
        List<Vector3> positions = [];
        List<int> indices = [];
        List<Vector2> uv = [];
        foreach (int axis in Enumerable.Range(0, 3))
        {
            foreach (float side in new[] { -1f, 1f })
            {
                Vector3 front = default, along = default;
                front[axis] = side;
                along[(axis + 1) % 3] = 1;
                Vector3 across = front.Cross(along);
                int first = positions.Count;
                positions.AddRange([front - along - across, front + along - across, front + along + across, front - along + across]);
                indices.AddRange([first, first + 1, first + 2, first, first + 2, first + 3]);
                uv.AddRange([new(0, 0), new(1, 0), new(1, 1), new(0, 1)]);
            }
        }

        return new([.. positions], [.. indices]) { Uv = [.. uv], FaceOfTriangle = [.. Enumerable.Range(0, 12).Select(t => t / 2)] };
    }

    // Where faces meet, they see other values of it.
    private sealed class SlopeTexture : Texture
    {
        public override void Evaluate(in TexturePointW at, out RgbW color)
        {
            FloatW value = FloatW.MultiplyAdd(at.V, 2f, at.U);
            color = new(value, value, value);
        }
    }
}
