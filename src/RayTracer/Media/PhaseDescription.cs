using RayTracer.Description;

namespace RayTracer.Media;

/// <summary>The curve of a phase function.</summary>
public enum PhaseShape
{
    /// <summary>Henyey and Greenstein's, of a mean cosine.</summary>
    HenyeyGreenstein,

    /// <summary>That of what is much smaller than a wavelength: air.</summary>
    Rayleigh,

    /// <summary>Numbers.</summary>
    Table,

    /// <summary>A mixture of two.</summary>
    Mix,

    /// <summary>That of tiny mirrors whose normals are those of an ellipsoid: no curve of the angle alone.</summary>
    Sggx,
}

/// <summary>Describes over which directions a medium spreads the light that it scatters.</summary>
public sealed record PhaseDescription
{
    /// <summary>How deep mixtures may be nested.</summary>
    public const int Deepest = 5;

    /// <summary>The most numbers of a table.</summary>
    public const int LongestTable = 65536;

    /// <summary>The curve.</summary>
    [Parameter("The curve: henyeyGreenstein, by anisotropy; rayleigh, as in clear air; table, by values; mix, of first and second; sggx, that of tiny mirrors in some order, by matrix, which "
        + "also says by how much the medium weakens light of each direction.")]
    public PhaseShape Shape { get; init; }

    /// <summary>Mean cosine of the angle of scattering.</summary>
    [Parameter("Only for henyeyGreenstein: mean cosine of the angle by which light is scattered. 0 scatters equally in all directions, above 0 mostly forward, below 0 mostly back.",
        Minimum = -0.99, Maximum = 0.99)]
    public float Anisotropy { get; init; }

    /// <summary>The curve at cosines from −1 to 1.</summary>
    [Parameter("Only for table: how much is scattered by angles whose cosines are evenly spaced from -1 (straight back) to 1 (straight on), and linear between them. A factor on all of them "
        + "has no effect.", Minimum = 0)]
    public IReadOnlyList<float> Values { get; init; } = [];

    /// <summary>The one part of a mixture; null for one that scatters equally in all directions.</summary>
    [Parameter("Only for mix: the one part. Without it, one that scatters equally in all directions.")]
    public PhaseDescription? First { get; init; }

    /// <summary>The other part of a mixture; null for one that scatters equally in all directions.</summary>
    [Parameter("Only for mix: the other part. Without it, one that scatters equally in all directions.")]
    public PhaseDescription? Second { get; init; }

    /// <summary>The share of the second part.</summary>
    [Parameter("Only for mix: the share of the second part.", Minimum = 0, Maximum = 1)]
    public float Weight { get; init; } = 0.5f;

    /// <summary>Factors on the share of the second part; null for none.</summary>
    [Parameter("Only for mix: numbers by which the weight is multiplied, from a file, so that the mixture depends on the place.")]
    public GridDescription? WeightGrid { get; init; }

    /// <summary>xx, yy, zz, xy, xz and yz of the symmetric matrix of flakes.</summary>
    [Parameter("Only for sggx: xx, yy, zz, xy, xz and yz of a symmetric matrix S (Heitz et al. 2015). The extinction is multiplied by √(ωᵀSω) along a direction ω, and light is mirrored by flakes whose "
        + "normals are those of the ellipsoid. Of a unit vector n, S = r² + (1 − r²)·nnᵀ makes sheets with the normal n, and S = 1 − (1 − r²)·nnᵀ fibres along n, of the roughness r.")]
    public IReadOnlyList<float> Matrix { get; init; } = [];

    /// <summary>The matrices at the points of a grid; null for the same one everywhere.</summary>
    [Parameter("Only for sggx: such matrices in space, from a file, instead of matrix; only where the density varies. Beyond its box, the outermost ones count.")]
    public GridDescription? MatrixGrid { get; init; }

    /// <summary>Says why mixtures cannot be nested deeper.</summary>
    internal static string DepthComplaint => $"mixtures of phase functions may be nested {Deepest} deep";

    /// <summary>Says why there can be no such table; null where there can.</summary>
    internal string? TableComplaint => Values.Count is < 2 or > LongestTable ? $"a table has from 2 to {LongestTable} values, not {Values.Count}"
        : Values.All(v => v == 0) ? "of the values, one must be above 0"
        : null;

    /// <summary>Makes the phase function; null after an error, and where it is not of the angle alone.</summary>
    internal PhaseFunction? Build(SceneBuilder builder, int depth = 0)
    {
        if (Complaint(depth) is { } complaint)
        {
            builder.Error(this, complaint.Property, complaint.Message);
            return null;
        }

        return Shape switch
        {
            PhaseShape.Rayleigh => new RayleighPhase(),
            PhaseShape.Table => new TablePhase(Values),
            PhaseShape.Mix => Mixed(builder, depth),
            PhaseShape.Sggx => null,
            _ => new HenyeyGreenstein(Anisotropy),
        };
    }

    /// <summary>Makes the flakes; null where it has none, and after an error.</summary>
    internal Microflakes? Flakes(SceneBuilder builder, bool mayVary)
    {
        if (Shape != PhaseShape.Sggx || Complaint(0) is not null)
        {
            return null;
        }

        if (MatrixGrid is null)
        {
            return Say(builder, nameof(Matrix), Microflakes.Complaint([.. Matrix])) ? null : new([.. Matrix]);
        }

        if (MatrixGrid.Build(builder, ofMatrices: true) is not { } grid)
        {
            return null;
        }

        ReadOnlySpan<float> values = grid.Grid.Values;
        string? complaint = null;
        bool varies = false;
        for (int i = 0; i < values.Length && complaint is null; i += 6)
        {
            complaint = Microflakes.Complaint(values.Slice(i, 6));
            varies |= !values.Slice(i, 6).SequenceEqual(values[..6]);
        }

        complaint ??= varies && !mayVary ? "the matrix varies only where the density does: add \"density\", \"noise\" or \"cloud\"" : null;
        return Say(builder, nameof(MatrixGrid), complaint) ? null : varies ? new(grid) : new([.. values[..6]]);
    }

    private bool Say(SceneBuilder builder, string property, string? complaint)
    {
        if (complaint is not null)
        {
            builder.Error(this, property, complaint);
        }

        return complaint is not null;
    }

    private MixedPhase? Mixed(SceneBuilder builder, int depth)
    {
        PlacedGrid? weights = WeightGrid?.Build(builder);
        if (weights is { Grid.Channels: not 1 })
        {
            builder.Error(this, nameof(WeightGrid), "a weight is one number, but the grid has red, green and blue");
        }

        PhaseFunction? first = (First ?? new()).Build(builder, depth + 1);
        PhaseFunction? second = (Second ?? new()).Build(builder, depth + 1);
        return first is null || second is null ? null : new(first, second, Weight, weights);
    }

    private (string Property, string Message)? Complaint(int depth) =>
        depth == Deepest && Shape == PhaseShape.Mix ? (nameof(Shape), DepthComplaint)
        : Shape != PhaseShape.Table && Values.Count > 0 ? (nameof(Values), "only the shape \"table\" has values")
        : Shape != PhaseShape.Mix && (First ?? Second) is not null ? (First is null ? nameof(Second) : nameof(First), "only the shape \"mix\" has parts")
        : Shape != PhaseShape.Mix && WeightGrid is not null ? (nameof(WeightGrid), "only the shape \"mix\" has a weight")
        : Shape != PhaseShape.HenyeyGreenstein && Anisotropy != 0 ? (nameof(Anisotropy), "only the shape \"henyeyGreenstein\" has an anisotropy")
        : Shape != PhaseShape.Sggx && (Matrix.Count > 0 || MatrixGrid is not null) ? (Matrix.Count > 0 ? nameof(Matrix) : nameof(MatrixGrid), "only the shape \"sggx\" has a matrix")
        : Shape == PhaseShape.Sggx && depth > 0 ? (nameof(Shape), "\"sggx\" cannot be part of a mixture: it also says how much light the medium weakens")
        : Shape == PhaseShape.Sggx && Matrix.Count > 0 == MatrixGrid is not null ? (nameof(Shape), "\"sggx\" needs either \"matrix\" or \"matrixGrid\"")
        : Shape == PhaseShape.Sggx && Matrix.Count is not (0 or 6) ? (nameof(Matrix), $"a symmetric matrix has 6 numbers, xx, yy, zz, xy, xz and yz, not {Matrix.Count}")
        : Shape == PhaseShape.Table && TableComplaint is { } complaint ? (nameof(Values), complaint)
        : null;
}
