using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes shapes: which they are, what they are made of, and whether they shine.</summary>
internal sealed class MitsubaShapes(ImportReading reading, MitsubaTextures textures, MitsubaBsdfs bsdfs, MitsubaEmitters emitters)
{
    private static readonly string[] s_types =
        ["rectangle", "sphere", "disk", "cylinder", "cube", "obj", "ply", "serialized", "linearcurve", "shapegroup", "instance", "merge"];

    private readonly Dictionary<MitsubaObject, ShapeDescription> _groups = [];

    /// <summary>The groups that instances show, by their names.</summary>
    public Dictionary<string, ShapeDescription> Groups { get; } = new(StringComparer.Ordinal);

    /// <summary>The shape that a thing is; null where nothing of it is seen by itself, or after an error.</summary>
    public ShapeDescription? Read(MitsubaObject shape)
    {
        ShapeDescription? made = shape.Type switch
        {
            "shapegroup" => Group(shape),
            "instance" => Instance(shape),
            "merge" => new GroupDescription { Shapes = [.. shape.Children("shape").Select(Read).OfType<ShapeDescription>()] },
            _ => Surface(shape),
        };
        shape.Finish();
        return made is null || shape.Type == "shapegroup" ? null : reading.At(shape.Place, made with { Name = shape.Id });
    }

    private ShapeDescription? Group(MitsubaObject shape)
    {
        if (!_groups.TryGetValue(shape, out ShapeDescription? group))
        {
            foreach (MitsubaObject nested in shape.Children("shape").Where(IsGrouped))
            {
                reading.Log.Error(nested.Place, $"a shapegroup cannot hold {(nested.Type == "instance" ? "an instance" : "another one")}");
            }

            group = reading.At(shape.Place, new GroupDescription { Name = shape.Id, Shapes = [.. shape.Children("shape").Where(s => !IsGrouped(s)).Select(Read).OfType<ShapeDescription>()] });
            _groups.Add(shape, group);
            Groups[shape.Id.Length > 0 ? shape.Id : $"group {Groups.Count + 1}"] = group;
        }

        return group;
    }

    private static bool IsGrouped(MitsubaObject shape) => shape.Type is "shapegroup" or "instance";

    private InstanceDescription? Instance(MitsubaObject shape)
    {
        Transform place = shape.Transform();
        if (shape.Only("shape") is not { Type: "shapegroup" } group)
        {
            if (!shape.LacksSomething)
            {
                reading.Log.Error(shape.Place, "an instance needs a shapegroup to show");
            }

            return null;
        }

        ShapeDescription? of = Group(group);
        group.Finish();
        return new() { Of = of, Transform = MatrixSteps.Of(place) };
    }

    private ShapeDescription? Surface(MitsubaObject shape)
    {
        if (!s_types.Contains(shape.Type))
        {
            shape.UnknownType("shapes", s_types);
            return shape.Log.IsLenient ? new SphereDescription { Radius = 1, Material = MitsubaBsdfs.Magenta, Transform = MatrixSteps.Of(shape.Transform()) } : null;
        }

        MaterialDescription material = Material(shape);
        if (shape.Type == "linearcurve")
        {
            return MitsubaCurves.Read(shape, material);
        }

        if (shape.Type is not ("obj" or "ply" or "serialized"))
        {
            return MitsubaSurfaces.Read(shape, material);
        }

        string[] attributes = textures.AttributesOf(material);
        return MitsubaMeshes.Read(shape, attributes.Length > 1 ? textures.WithSecond(material, attributes[1]) : material, attributes);
    }

    private MaterialDescription Material(MitsubaObject shape)
    {
        MitsubaObject? emitter = shape.Only("emitter");
        MaterialDescription material = shape.Only("bsdf") is { } bsdf ? bsdfs.Read(bsdf) : emitter is null ? MitsubaBsdfs.Standard : MitsubaBsdfs.Black;
        MaterialDescription filled = MitsubaMedia.Fill(shape, material, bsdfs.IsVolumetric);
        return emitter is null ? filled : emitters.Area(emitter, filled);
    }
}

/// <summary>Makes meshes of model files. Where a file has no normals they have smooth ones, unless faces are asked for.</summary>
internal static class MitsubaMeshes
{
    /// <summary>A mesh of a file.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">Its material.</param>
    /// <param name="attributes">The names of the attributes that the material shows.</param>
    public static ShapeDescription? Read(MitsubaObject shape, MaterialDescription material, string[] attributes)
    {
        if (attributes.Length > 2)
        {
            shape.Log.Unsupported(shape.Place, $"a mesh may show two of its attributes here, but this one shows {string.Join(" and ", attributes)}", "the first two are shown");
        }

        // The front of flat faces follows from the order of their corners after the transform, so a mirror turns it inwards.
        Transform place = shape.Transform();
        bool isFlat = shape.Boolean("face_normals", false);
        MeshDescription mesh = new()
        {
            File = shape.FileName() ?? "",
            Part = shape.Type == "serialized" ? shape.Integer("shape_index", 0, 0) : -1,
            Shading = isFlat ? MeshShading.Flat : MeshShading.Smooth,
            FlipNormals = shape.Boolean("flip_normals", false) != (isFlat && place.Determinant < 0),
            FlipV = shape.Boolean("flip_tex_coords", shape.Type == "obj"),
            IgnoreColors = attributes.Length == 0,
            ColorAttribute = attributes is [not "vertex_color" and var name, ..] && shape.Type == "ply" ? name : "",
            SecondColorAttribute = attributes.Length > 1 && shape.Type == "ply" ? attributes[1] : "",
            Material = material,
            Transform = MatrixSteps.Of(place),
        };
        return mesh.File.Length > 0 ? mesh : null;
    }
}

/// <summary>The cube from −1 to 1, as triangles.</summary>
internal static class CubeMesh
{
    // For each face, what is to the front, and along which directions u and v grow.
    private static readonly (Vector3 Front, Vector3 U, Vector3 V)[] s_faces =
    [
        (new(1, 0, 0), new(0, 1, 0), new(0, 0, -1)), (new(-1, 0, 0), new(0, 1, 0), new(0, 0, 1)),
        (new(0, 1, 0), new(-1, 0, 0), new(0, 0, -1)), (new(0, -1, 0), new(0, 0, 1), new(1, 0, 0)),
        (new(0, 0, 1), new(0, 1, 0), new(1, 0, 0)), (new(0, 0, -1), new(0, -1, 0), new(1, 0, 0)),
    ];

    /// <summary>The cube.</summary>
    /// <param name="hasUv">True where its corners have uv: on each face from 0 to 1.</param>
    public static MeshDescription Create(bool hasUv)
    {
        List<Vector3> positions = [];
        List<TriangleIndices> triangles = [];
        foreach ((Vector3 front, Vector3 u, Vector3 v) in s_faces)
        {
            int first = positions.Count;
            positions.AddRange([front - u - v, front + u - v, front + u + v, front - u + v]);
            bool isLeftTurn = u.Cross(v).Dot(front) > 0;
            triangles.AddRange(isLeftTurn
                ? [new(first, first + 1, first + 2), new(first, first + 2, first + 3)]
                : [new(first, first + 2, first + 1), new(first, first + 3, first + 2)]);
        }

        Vector2[] uv = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)];
        return new() { Positions = positions, Triangles = triangles, Uv = hasUv ? [.. s_faces.SelectMany(_ => uv)] : [] };
    }
}
