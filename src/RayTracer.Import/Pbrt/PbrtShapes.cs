using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes shapes: which they are, what they are made of, and whether they shine.</summary>
internal sealed class PbrtShapes(ImportReading reading, PbrtWorld world, PbrtTextures textures, PbrtMaterials materials, PbrtMedia media, PbrtLights lights)
{
    private static readonly string[] s_types = ["sphere", "disk", "cylinder", "trianglemesh", "plymesh", "bilinearmesh", "loopsubdiv", "curve"];

    // Takes our sphere, around which u = 0 faces −z and whose pole is y, to theirs: pole z, and u = 0 at x.
    private static readonly Transform s_upright = new(new(0, 0, -1, 0), new(-1, 0, 0, 0), new(0, 1, 0, 0));

    /// <summary>The objects that instances show, by their names.</summary>
    public Dictionary<string, ShapeDescription> Objects { get; } = new(StringComparer.Ordinal);

    /// <summary>The shapes that are seen.</summary>
    public ShapeDescription[] Read()
    {
        foreach ((string name, List<PbrtThing> shapes) in world.Objects)
        {
            ShapeDescription[] made = [.. shapes.Where(s => s.Kind == "shape").Select(s => Shape(s, isInObject: true)).OfType<ShapeDescription>()];
            if (made.Length > 0)
            {
                Objects[name] = new GroupDescription { Name = name, Shapes = made };
            }
        }

        return [.. world.Shapes.Select(s => s.Kind == "shape" ? Shape(s, isInObject: false) : Instance(s)).OfType<ShapeDescription>()];
    }

    private InstanceDescription? Instance(PbrtThing instance)
    {
        if (!world.Objects.ContainsKey(instance.Type))
        {
            return reading.Log.Unknown<InstanceDescription>(instance.Place, $"there is no object {Quotation.Of(instance.Type)}", instance.Type, [.. world.Objects.Keys]);
        }

        if (!Objects.TryGetValue(instance.Type, out ShapeDescription? of))
        {
            return null;
        }

        IReadOnlyList<KeyframeDescription> motion = PbrtMotion.Of(instance, instance.State.Places);
        return reading.At(instance.Place, new InstanceDescription { Of = of, Transform = motion.Count > 0 ? [] : MatrixSteps.Of(instance.State.Place), Motion = motion });
    }

    private ShapeDescription? Shape(PbrtThing shape, bool isInObject)
    {
        if (!s_types.Contains(shape.Type))
        {
            shape.UnknownType(s_types);
            return shape.Log.IsLenient ? new SphereDescription { Radius = 1, Material = PbrtMaterials.Magenta, Transform = MatrixSteps.Of(shape.State.Place) } : null;
        }

        IReadOnlyList<KeyframeDescription> motion = PbrtMotion.Of(shape, shape.State.Places.Moves ? shape.TakePlaces() : PbrtPlaces.World);
        PbrtThing? light = shape.State.Light;
        if (light is not null && isInObject)
        {
            reading.Log.Warn(shape.Place, "what shines does not do so within an object, as in pbrt");
            light = null;
        }

        MaterialDescription material = Material(shape, light is not null);
        ShapeDescription? made = shape.Type switch
        {
            "sphere" or "disk" or "cylinder" => Quadric(shape, material, light),
            "trianglemesh" => PbrtMeshes.Triangles(shape),
            "bilinearmesh" => PbrtMeshes.Patches(shape),
            "loopsubdiv" => PbrtMeshes.Subdivided(shape),
            "curve" => PbrtCurves.Read(shape),
            _ => PbrtMeshes.File(shape),
        };
        shape.Finish();
        if (made is null)
        {
            return null;
        }

        made = made with { Transform = made.Transform.Count > 0 ? made.Transform : MatrixSteps.Of(shape.State.Place) };
        made = light is null ? made with { Material = material } : lights.Shining(shape, light, made, material);
        return reading.At(shape.Place, made with { Motion = motion });
    }

    private MaterialDescription Material(PbrtThing shape, bool shines)
    {
        MaterialDescription material = materials.Of(shape.State);
        if (textures.Float(shape, "alpha") is { } alpha && alpha is not Textures.SolidTextureDescription { Color.R: >= 1 })
        {
            if (shines)
            {
                reading.Log.Unsupported(shape.PlaceOf("alpha"), "holes in what shines are not supported", "it has none");
            }
            else
            {
                material = reading.At(shape.Place, new MaskMaterialDescription { Opacity = alpha, Material = material });
            }
        }

        return media.Fill(shape, material);
    }

    // A shape of ours where that is the same; else a mesh of many triangles.
    private ShapeDescription? Quadric(PbrtThing shape, MaterialDescription material, PbrtThing? light)
    {
        QuadricPart part = QuadricPart.Read(shape);
        bool turns = shape.State.IsReversed && (light is not null || !LooksTheSame(material));
        bool needsUv = MaterialTextures.NeedUv(material) || light?.Has("filename") == true;
        if (!part.IsPossible(shape))
        {
            return null;
        }

        if (!part.IsWhole || turns || (needsUv && shape.Type != "sphere"))
        {
            return part.Mesh(shape.Type) with { FlipNormals = shape.State.IsReversed };
        }

        return shape.Type switch
        {
            "sphere" when needsUv => new SphereDescription { Radius = part.Radius, Transform = MatrixSteps.Of(shape.State.Place * s_upright) },
            "sphere" when shape.State.Place.UniformScale() is { } scale => new SphereDescription { Center = shape.State.Place.Point(Vector3.Zero), Radius = (float)(part.Radius * scale), Transform = [new()] },
            "sphere" => new SphereDescription { Radius = part.Radius },
            "disk" => new DiskDescription { Center = new(0, 0, part.ZMin), Normal = Vector3.UnitZ, Radius = part.Radius },
            _ => new CylinderDescription { Bottom = new(0, 0, part.ZMin), Top = new(0, 0, part.ZMax), Radius = part.Radius, Caps = false },
        };
    }

    private static bool LooksTheSame(MaterialDescription material) =>
        material is DiffuseMaterialDescription or MetalDescription or PlasticMaterialDescription or RoughPlasticMaterialDescription or TranslucentMaterialDescription;
}

/// <summary>A sphere, disk or cylinder of pbrt, or a part of one: around z.</summary>
/// <param name="Radius">Its radius.</param>
/// <param name="Inner">Of a disk, the radius of the hole.</param>
/// <param name="ZMin">The height where it begins; of a disk, where it is.</param>
/// <param name="ZMax">The height where it ends.</param>
/// <param name="Turn">The part of a full turn that it goes around z.</param>
internal sealed record QuadricPart(float Radius, float Inner, float ZMin, float ZMax, float Turn)
{
    private const int Around = 128;

    /// <summary>True where nothing of the shape is missing.</summary>
    public bool IsWhole { get; private init; }

    /// <summary>The area in the shape's own space, which is what pbrt counts with.</summary>
    public float Area { get; private init; }

    /// <summary>Reads one.</summary>
    public static QuadricPart Read(PbrtThing shape)
    {
        float radius = shape.Float("radius", 1);
        float turn = float.Clamp(shape.Float("phimax", 360), 0, 360) / 360;
        float full = 2 * float.Pi * turn;
        if (shape.Type == "disk")
        {
            float inner = shape.Float("innerradius", 0, 0);
            float height = shape.Float("height", 0);
            return new(radius, inner, height, height, turn) { IsWhole = turn == 1 && inner == 0, Area = 0.5f * full * ((radius * radius) - (inner * inner)) };
        }

        bool isSphere = shape.Type == "sphere";
        (float first, float second) = (shape.Float("zmin", isSphere ? -radius : -1), shape.Float("zmax", isSphere ? radius : 1));
        (float low, float high) = (float.Min(first, second), float.Max(first, second));
        if (isSphere)
        {
            (low, high) = (float.Clamp(low, -radius, float.Max(radius, -radius)), float.Clamp(high, -radius, float.Max(radius, -radius)));
        }

        return new(radius, 0, low, high, turn) { IsWhole = turn == 1 && (!isSphere || (low == -radius && high == radius)), Area = full * radius * (high - low) };
    }

    /// <summary>Returns true where there is such a shape; reports an error otherwise.</summary>
    public bool IsPossible(PbrtThing shape)
    {
        bool isPossible = Radius > 0 && Turn > 0 && Inner < Radius && (shape.Type == "disk" || ZMin < ZMax);
        if (!isPossible)
        {
            shape.Log.Error(shape.Place, $"there is nothing of the {shape.Type}: it needs a radius above 0, and some extent");
        }

        return isPossible;
    }

    /// <summary>The shape as triangles, with the uv that pbrt gives it and its smooth normals.</summary>
    public MeshDescription Mesh(string type)
    {
        int columns = int.Max(8, (int)float.Ceiling(Around * Turn));
        int rows = type == "sphere" ? Around / 2 : 1;
        (float from, float to) = (Angle(ZMin), Angle(ZMax));
        return GridMesh.Create(columns, rows, (u, v) =>
        {
            LaneMath.SinCosTurn(u * Turn, out float sin, out float cos);
            if (type == "disk")
            {
                float at = Radius + (v * (Inner - Radius));
                return (new(at * cos, at * sin, ZMin), Vector3.UnitZ);
            }

            if (type == "cylinder")
            {
                return (new(Radius * cos, Radius * sin, ZMin + (v * (ZMax - ZMin))), new(cos, sin, 0));
            }

            LaneMath.SinCosTurn((((1 - v) * from) + (v * to)) / (2 * float.Pi), out float around, out float up);
            Vector3 normal = new(around * cos, around * sin, up);
            return (Radius * normal, normal);
        });
    }

    // From the upper pole of a sphere.
    private float Angle(float z) => LaneMath.Atan2(float.Sqrt(float.Max((Radius * Radius) - (z * z), 0)), z);
}

/// <summary>Surfaces over a square of u and v, as triangles.</summary>
internal static class GridMesh
{
    /// <summary>A surface, whose front is where a left turn leads from u to v.</summary>
    /// <param name="columns">Steps along u.</param>
    /// <param name="rows">Steps along v.</param>
    /// <param name="at">The point and the unit normal at u and v.</param>
    public static MeshDescription Create(int columns, int rows, Func<float, float, (Vector3 Point, Vector3 Normal)> at)
    {
        (List<Vector3> points, List<Vector3> normals, List<Vector2> uv, List<TriangleIndices> triangles) = ([], [], [], []);
        for (int j = 0; j <= rows; j++)
        {
            for (int i = 0; i <= columns; i++)
            {
                Vector2 place = new(i / (float)columns, j / (float)rows);
                (Vector3 point, Vector3 normal) = at(place.X, place.Y);
                points.Add(point);
                normals.Add(normal);
                uv.Add(place);
            }
        }

        for (int j = 0; j < rows; j++)
        {
            for (int i = 0; i < columns; i++)
            {
                int a = (j * (columns + 1)) + i;
                int c = a + columns + 1;
                Add(a, a + 1, c + 1);
                Add(a, c + 1, c);
            }
        }

        return new() { Positions = points, Normals = normals, Uv = uv, Triangles = triangles };

        // At a pole, one of the two has no area.
        void Add(int a, int b, int c)
        {
            if (points[a] != points[b] && points[b] != points[c] && points[c] != points[a])
            {
                triangles.Add(new(a, b, c));
            }
        }
    }
}

/// <summary>Makes meshes, of numbers or of files.</summary>
internal static class PbrtMeshes
{
    // Steps along each side of a patch that is not flat.
    private const int PatchSteps = 16;
    private static readonly Vector2[] s_corners = [new(0, 0), new(1, 0), new(0, 1), new(1, 1)];

    /// <summary>Triangles. Where they have normals, their front is on the side of these.</summary>
    public static MeshDescription? Triangles(PbrtThing shape)
    {
        shape.Ignore("S");
        (Vector3[] points, int[] indices) = (shape.Vectors("P", "point3"), shape.Integers("indices"));
        Vector3[] normals = shape.Vectors("N", "normal3");
        Vector2[] uv = shape.Pairs("uv");
        indices = indices.Length == 0 && !shape.Has("indices") && points.Length == 3 ? [0, 1, 2] : indices;
        if (!IsWhole(shape, points, indices, 3, normals.Length, uv.Length))
        {
            return null;
        }

        TriangleIndices[] triangles = [.. indices.Chunk(3).Select(t => new TriangleIndices(t[0], t[1], t[2]))];
        if (normals.Length > 0)
        {
            triangles = [.. triangles.Select(t => Facing(t, points, normals))];
        }

        return new() { Positions = points, Triangles = triangles, Normals = normals, Uv = uv, FlipNormals = shape.State.IsReversed };
    }

    /// <summary>Patches between four corners each: bilinear surfaces.</summary>
    public static MeshDescription? Patches(PbrtThing shape)
    {
        shape.Refuse("emissionfilename", "a picture that a bilinearmesh sends (\"emissionfilename\") is not read");
        (Vector3[] points, int[] indices) = (shape.Vectors("P", "point3"), shape.Integers("indices"));
        Vector2[] places = shape.Pairs("uv");
        Vector3[] given = shape.Vectors("N", "normal3");
        indices = indices.Length == 0 && !shape.Has("indices") && points.Length == 4 ? [0, 1, 2, 3] : indices;
        if (!IsWhole(shape, points, indices, 4, given.Length, places.Length))
        {
            return null;
        }

        MeshDescription[] patches = [.. indices.Chunk(4).Select(p => Patch(
            points[p[0]], points[p[1]], points[p[2]], points[p[3]], places.Length > 0 ? [.. p.Select(i => places[i])] : s_corners, given.Length > 0 ? [.. p.Select(i => given[i])] : []))];
        (List<Vector3> all, List<Vector2> uv, List<Vector3> normals, List<TriangleIndices> triangles) = ([], [], [], []);
        foreach (MeshDescription patch in patches)
        {
            int first = all.Count;
            all.AddRange(patch.Positions);
            uv.AddRange(patch.Uv);
            normals.AddRange(patch.Normals);
            triangles.AddRange(patch.Triangles.Select(t => new TriangleIndices(first + t.A, first + t.B, first + t.C)));
        }

        if (given.Length > 0)
        {
            (Vector3[] at, Vector3[] towards) = ([.. all], [.. normals]);
            triangles = [.. triangles.Select(t => Facing(t, at, towards))];
        }

        return new() { Positions = all, Triangles = triangles, Normals = normals, Uv = uv, FlipNormals = shape.State.IsReversed };
    }

    /// <summary>Triangles that Loop's rules make fine and round. pbrt's normals of these look the other way: around each corner it goes clockwise.</summary>
    public static MeshDescription? Subdivided(PbrtThing shape)
    {
        (Vector3[] points, int[] indices) = (shape.Vectors("P", "point3"), shape.Integers("indices"));
        int levels = shape.Integer("levels", 3, 0);
        if (shape.Text("scheme") is { } scheme and not "loop")
        {
            shape.Log.Unknown(shape.PlaceOf("scheme"), $"surfaces are subdivided by \"loop\", not by {Quotation.Of(scheme)}", scheme, ["loop"]);
        }

        return !IsWhole(shape, points, indices, 3, 0, 0) ? null : new()
        {
            Positions = points,
            Triangles = [.. indices.Chunk(3).Select(t => new TriangleIndices(t[0], t[1], t[2]))],
            Refinement = new() { Subdivide = int.Min(levels, 10), Scheme = SubdivisionScheme.Loop },
            Shading = MeshShading.Smooth,
            FlipNormals = !shape.State.IsReversed,
        };
    }

    /// <summary>The mesh of a PLY file.</summary>
    public static MeshDescription? File(PbrtThing shape)
    {
        shape.Refuse("displacement", "meshes that are displaced are not supported");
        shape.Ignore("displacement.edgelength");
        return shape.FileName() is { } file ? new() { File = file, IgnoreColors = true, FlipNormals = shape.State.IsReversed } : null;
    }

    // Corners: at (0, 0), (1, 0), (0, 1) and (1, 1). What a texture asks for lies between those of the corners as the points do.
    private static MeshDescription Patch(Vector3 a, Vector3 b, Vector3 c, Vector3 d, Vector2[] places, Vector3[] given)
    {
        bool isFlat = (given.Length == 0 || given.Distinct().Count() == 1) && (a - b - c + d).Norm() <= 1e-5f * ((b - a).Norm() + (c - a).Norm()) && places[0] - places[1] - places[2] + places[3] == Vector2.Zero;
        int steps = isFlat ? 1 : PatchSteps;
        MeshDescription patch = GridMesh.Create(steps, steps, (u, v) =>
        {
            Vector3 alongU = ((1 - v) * (b - a)) + (v * (d - c));
            Vector3 alongV = ((1 - u) * (c - a)) + (u * (d - b));
            Vector3 normal = given.Length == 0 ? alongU.Cross(alongV).Unit() : Between(given, u, v).Unit();
            return (((1 - v) * (((1 - u) * a) + (u * b))) + (v * (((1 - u) * c) + (u * d))), normal.IsFinite() ? normal : Vector3.UnitZ);
        });
        return patch with { Uv = [.. patch.Uv.Select(At)] };

        static Vector3 Between(Vector3[] n, float u, float v) => ((1 - v) * (((1 - u) * n[0]) + (u * n[1]))) + (v * (((1 - u) * n[2]) + (u * n[3])));

        Vector2 At(Vector2 place) =>
            ((1 - place.Y) * (((1 - place.X) * places[0]) + (place.X * places[1]))) + (place.Y * (((1 - place.X) * places[2]) + (place.X * places[3])));
    }

    private static TriangleIndices Facing(TriangleIndices t, Vector3[] points, Vector3[] normals)
    {
        Vector3 front = (points[t.B] - points[t.A]).Cross(points[t.C] - points[t.A]);
        return front.Dot(normals[t.A] + normals[t.B] + normals[t.C]) < 0 ? new(t.A, t.C, t.B) : t;
    }

    private static bool IsWhole(PbrtThing shape, Vector3[] points, int[] indices, int corners, int normals, int uv)
    {
        string? complaint = points.Length == 0 ? $"{shape.Describe()} needs points, \"point3 P\""
            : indices.Length == 0 || indices.Length % corners != 0 ? $"{shape.Describe()} needs \"integer indices\", a multiple of {corners} of them, but has {indices.Length}"
            : Array.FindIndex(indices, i => i < 0 || i >= points.Length) is var bad and >= 0 ? $"index {bad} (from 0) of the {shape.Type} is none of its {points.Length} points"
            : normals > 0 && normals != points.Length ? $"{shape.Describe()} has {points.Length} points, but {normals} normals"
            : uv > 0 && uv != points.Length ? $"{shape.Describe()} has {points.Length} points, but {uv} uv"
            : null;
        return complaint is null || shape.Log.Fail<bool>(shape.PlaceOf(points.Length == 0 ? "P" : "indices"), complaint);
    }
}
