using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>Makes the data of described meshes fit to be rendered, each once.</summary>
/// <param name="builder">Takes what is reported.</param>
internal sealed class MeshMender(SceneBuilder builder)
{
    private readonly Dictionary<object, MeshData> _mended = new(ReferenceEqualityComparer.Instance);

    /// <summary>The triangles of a mesh, with what a shape wants of it; null where they have a fault, which is reported.</summary>
    /// <param name="wanted">The shape that shows the mesh.</param>
    /// <param name="mesh">The mesh, which may come from a file that the shape names.</param>
    public MeshData? Mended(MeshDescription wanted, MeshDescription mesh)
    {
        // What one file's mesh becomes in one shape is not kept for others.
        object key = (object?)mesh.Data ?? mesh;
        if (MeshVariant.IsOwn(wanted) && _mended.TryGetValue(key, out MeshData? known))
        {
            return known;
        }

        int[] missing = mesh.Data is not null ? [] : [.. mesh.Triangles.SelectMany(t => new[] { t.A, t.B, t.C }).Where(c => (uint)c >= (uint)mesh.Positions.Count).Take(1)];
        if (missing is [var corner])
        {
            builder.Error(mesh, nameof(MeshDescription.Triangles), $"a triangle has the corner {corner}, but there are {mesh.Positions.Count}, counted from 0");
            return null;
        }

        if (Lacks(wanted, mesh, nameof(MeshDescription.ColorAttribute), wanted.ColorAttribute) || Lacks(wanted, mesh, nameof(MeshDescription.SecondColorAttribute), wanted.SecondColorAttribute))
        {
            return null;
        }

        if (wanted.SecondColorAttribute.Length > 0 && IsRefined(wanted, mesh))
        {
            builder.Error(wanted, nameof(MeshDescription.SecondColorAttribute), $"{Name(mesh)} is refined, and shows one set of colours only");
        }

        MeshData data = MeshDoctor.Mend(MeshVariant.Of(mesh.Data ?? Inline(mesh), wanted), out string report);
        if (MeshVariant.IsOwn(wanted))
        {
            _mended.Add(key, data);
        }

        if (report.Length > 0)
        {
            builder.Warn(mesh, null, $"{Name(mesh)}: {report}");
        }

        return data.TriangleCount > 0 && IsRefined(wanted, mesh) ? Refined(wanted, mesh, data) : data;
    }

    private bool Lacks(MeshDescription wanted, MeshDescription mesh, string property, string name)
    {
        string[] names = [.. mesh.Data?.Attributes.Select(a => a.Name) ?? []];
        bool lacks = name.Length > 0 && !names.Contains(name);
        if (lacks)
        {
            builder.Error(wanted, property, $"{Name(mesh)} has no colours {Quotation.Of(name)}: {(names.Length == 0 ? "there are none" : $"there are {string.Join(", ", names)}")}");
        }

        return lacks;
    }

    // Creases matter to what is smooth, too: but not where a mesh has normals of its own.
    private static bool IsRefined(MeshDescription wanted, MeshDescription mesh) => wanted.Refinement.MovesCorners
        || (wanted.Shading == MeshShading.Smooth && wanted.Refinement.CreaseAngle < 180 && (mesh.Data is { } data ? data.Normals is null : mesh.Normals.Count == 0));

    private MeshData? Refined(MeshDescription wanted, MeshDescription mesh, MeshData data)
    {
        RefinementDescription refinement = wanted.Refinement;
        Texture? displacement = refinement.Displace is { } texture ? builder.NumberTexture(texture) : null;
        (long bytes, long triangles) = MeshRefiner.Cost(data, refinement);
        if (builder.Budget.TakeWork($"a mesh of {triangles} triangles", bytes, triangles * SceneBudget.StepsPerTriangle) is { } complaint)
        {
            builder.Error(wanted, nameof(MeshDescription.Refinement), complaint);
            return null;
        }

        // What was without area, or becomes so, is no fault of the scene's.
        return MeshDoctor.Mend(MeshRefiner.Refine(data, refinement, displacement, wanted.Shading == MeshShading.Flat), out _);
    }

    private static MeshData Inline(MeshDescription mesh) => new([.. mesh.Positions], [.. mesh.Triangles.SelectMany(t => new[] { t.A, t.B, t.C })])
    {
        Normals = mesh.Normals.Count > 0 ? [.. mesh.Normals] : null,
        Uv = mesh.Uv.Count > 0 ? [.. mesh.Uv] : null,
        Colors = mesh.Colors.Count > 0 ? [.. mesh.Colors.Select(c => new Rgb(c.X, c.Y, c.Z))] : null,
        MaterialOfTriangle = mesh.MaterialOfTriangle.Count > 0 ? [.. mesh.MaterialOfTriangle] : null,
        FaceOfTriangle = mesh.FaceOfTriangle.Count > 0 ? [.. mesh.FaceOfTriangle] : null,
    };

    /// <summary>The name of a mesh in messages.</summary>
    public static string Name(MeshDescription mesh) => mesh.Name.Length > 0 ? $"mesh \"{mesh.Name}\"" : "the mesh";
}
