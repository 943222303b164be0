using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Media;

/// <summary>The interpolation between the points of a grid.</summary>
public enum GridInterpolation
{
    /// <summary>Linear between the eight nearest points.</summary>
    Trilinear,

    /// <summary>The nearest point: blocks.</summary>
    Nearest,
}

/// <summary>How a file without a header holds numbers.</summary>
public enum GridNumbers
{
    /// <summary>IEEE 754, 4 bytes each.</summary>
    Float32,

    /// <summary>IEEE 754, 2 bytes each.</summary>
    Float16,

    /// <summary>Whole numbers of 2 bytes, over 65,535.</summary>
    UInt16,

    /// <summary>Bytes, over 255.</summary>
    UInt8,
}

/// <summary>Describes numbers in space, from a file.</summary>
public sealed record GridDescription
{
    /// <summary>The file.</summary>
    [Parameter("The grid's file: Mitsuba's .vol, NanoVDB's .nvdb (grids of floats, uncompressed or ZIP), or nothing but numbers (any other extension; then size is "
        + "needed). Either a file or values are needed.", IsFile = true)]
    public string File { get; init; } = "";

    /// <summary>The numbers themselves; empty where a file has them.</summary>
    [Parameter("The numbers of the grid, in place of a file; together with size. Those along x come first, then y, then z.")]
    public IReadOnlyList<float> Values { get; init; } = [];

    /// <summary>The name of the grid within the file; empty for the first.</summary>
    [Parameter("The name of the grid, of a .nvdb file that has several. Without it, the first one of floats.")]
    public string Name { get; init; } = "";

    /// <summary>The points along x, y and z of values, or of a file without a header; empty for others.</summary>
    [Parameter("For values, or a file of nothing but numbers: how many points it has along x, y and z; those along x come first, then y, then z. A fourth number, 3, says that each has red, "
        + "green and blue, and 6, xx, yy, zz, xy, xz and yz of a symmetric matrix.")]
    public IReadOnlyList<int> Size { get; init; } = [];

    /// <summary>How a file without a header holds numbers.</summary>
    [Parameter("For a file of nothing but numbers: of which kind they are, all with the lowest byte first. Whole numbers are divided by the largest possible one.")]
    public GridNumbers Numbers { get; init; }

    /// <summary>Two opposite corners of the box that the grid fills, before the transform; empty for that of the file.</summary>
    [Parameter("Two opposite corners of the box that the grid fills, in the world's coordinates. Without it, the box that the file names, or the unit cube for a file "
        + "of nothing but numbers. The first corner is where x, y and z of the grid begin.", Unit = "scene units")]
    public IReadOnlyList<Vector3> Box { get; init; } = [];

    /// <summary>The transform of the box; empty for the identity.</summary>
    [Parameter("How the box is moved in the world: steps, the first one applied first. It does not follow the transform of the shape that it fills.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The interpolation between points.</summary>
    [Parameter("How numbers between the points are found: linear between the eight nearest, or that of the nearest one. Point i of n is at (i + ½)/n of the box.")]
    public GridInterpolation Interpolation { get; init; }

    /// <summary>What is beyond the outermost points.</summary>
    [Parameter("What counts between the outermost points and the faces of the box: these points, those of the opposite face, or the mirror image.")]
    public Wrapping Wrapping { get; init; } = Wrapping.Clamp;

    /// <summary>The grid in its place; null after an error.</summary>
    /// <param name="builder">Gives access to files and takes diagnostics.</param>
    /// <param name="ofMatrices">True for a grid of symmetric matrices.</param>
    internal PlacedGrid? Build(SceneBuilder builder, bool ofMatrices = false)
    {
        if (Numbered(builder) is not { } grid || GridBox.Place(this, Box, Transform, grid.Place, builder) is not { } place)
        {
            return null;
        }

        if (grid.Channels == 6 == ofMatrices)
        {
            return new(grid, place, Interpolation, Wrapping);
        }

        builder.Error(this, null, ofMatrices ? $"matrices have six numbers at each point, but the grid has {grid.Channels}" : "the grid has six numbers at each point, which are a matrix: only \"matrixGrid\" takes them");
        return null;
    }

    private VolumeGrid? Numbered(SceneBuilder builder)
    {
        if (Values.Count == 0 && File.Length > 0)
        {
            return builder.Grid(this, nameof(File), this);
        }

        string? complaint = Values.Count == 0 ? "a grid needs a \"file\", or \"values\""
            : File.Length > 0 ? "a grid has either a file or values, not both"
            : Size.Count is not (3 or 4) ? "values need \"size\", their points along x, y and z" : VolumeGrid.SizeComplaint(Size[0], Size[1], Size[2], Channels)
            ?? (Values.Count != (long)Size[0] * Size[1] * Size[2] * Channels ? $"{string.Join('×', Size)} numbers are needed, but there are {Values.Count}" : null)
            ?? (Channels != 6 && Values.Any(v => v < 0) ? "the numbers must be at least 0" : null);
        if (complaint is not null)
        {
            builder.Error(this, Values.Count > 0 ? nameof(Values) : null, complaint);
            return null;
        }

        return new(Size[0], Size[1], Size[2], Channels, [.. Values]);
    }

    private int Channels => Size.Count == 4 ? Size[3] : 1;
}

/// <summary>The boxes that grids fill.</summary>
internal static class GridBox
{
    /// <summary>The map from the unit cube to a box in the world; null after an error.</summary>
    /// <param name="subject">The record that the box belongs to.</param>
    /// <param name="box">Two opposite corners, or nothing.</param>
    /// <param name="steps">The transform of the box.</param>
    /// <param name="standard">The box where none is given; null for the unit cube.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    public static Transform? Place(object subject, IReadOnlyList<Vector3> box, IReadOnlyList<TransformDescription> steps, Transform? standard, SceneBuilder builder)
    {
        if (box.Count is not (0 or 2))
        {
            builder.Error(subject, "Box", $"the box has two corners, not {box.Count}");
            return null;
        }

        Transform inner = box.Count == 0 ? standard ?? Transform.Identity : Transform.Translation(box[0]) * Transform.Scaling(box[1] - box[0]);
        if (!inner.IsInvertible)
        {
            builder.Error(subject, "Box", "the box must have a volume: its corners must differ along x, y and z");
            return null;
        }

        Transform place = TransformSteps.Place(subject, steps, builder) * inner;
        if (place.IsInvertible)
        {
            return place;
        }

        builder.Error(subject, "Transform", "the transformed box has numbers too large or too small to compute with");
        return null;
    }
}
