using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Media;

/// <summary>
/// A medium of tiny mirrors whose normals are those of an ellipsoid: fibres or sheets that lie in some order (the SGGX distribution of Heitz, Dupuy, Crassin &amp; Dachsbacher 2015). A
/// symmetric matrix S says how large the flakes look from each direction ω: √(ωᵀSω) is the factor on the extinction there (their eq. 9), and the phase function is that of the
/// flakes that are seen. So the medium looks the same with light and eye exchanged.
/// </summary>
internal sealed class Microflakes
{
    // No pivot is below this part of the trace, and no density is divided by nothing.
    private const float LeastPivot = 1e-7f;
    private const float Least = 1e-30f;
    private readonly PlacedGrid? _grid;
    private readonly AffineW? _toGrid;

    // S of all places; or, of a grid, the most that each number of it comes to.
    private readonly RgbW _diagonal;
    private readonly RgbW _beside;

    /// <summary>Flakes that are the same everywhere.</summary>
    /// <param name="matrix">xx, yy, zz, xy, xz and yz of S.</param>
    public Microflakes(IReadOnlyList<float> matrix)
    {
        _diagonal = new(matrix[0], matrix[1], matrix[2]);
        _beside = new(matrix[3], matrix[4], matrix[5]);
    }

    /// <summary>Flakes that depend on the place.</summary>
    /// <param name="grid">The six numbers of S.</param>
    public Microflakes(PlacedGrid grid)
    {
        (_grid, _toGrid) = (grid, new(grid.ToVoxels));
        // No memory of the stack, which this assembly does not clear.
        float[] most = new float[6];
        ReadOnlySpan<float> values = grid.Grid.Values;
        for (int i = 0; i < values.Length; i++)
        {
            most[i % 6] = float.Max(most[i % 6], float.Abs(values[i]));
        }

        _diagonal = new(most[0], most[1], most[2]);
        _beside = new(most[3], most[4], most[5]);
    }

    /// <summary>True where they depend on the place.</summary>
    public bool Vary => _grid is not null;

    /// <summary>Says why six numbers are no matrix of flakes; null where they are.</summary>
    public static string? Complaint(ReadOnlySpan<float> m)
    {
        double least = LeastPivot * ((double)m[0] + m[1] + m[2]);
        double second = m[1] - ((double)m[3] * m[3] / m[0]);
        double side = m[5] - ((double)m[4] * m[3] / m[0]);
        double third = m[2] - ((double)m[4] * m[4] / m[0]) - (side * side / second);
        return m[0] > least && second > least && third > least ? null
            : $"the matrix of flakes, xx {m[0]}, yy {m[1]}, zz {m[2]}, xy {m[3]}, xz {m[4]}, yz {m[5]}, is not positive definite: it is no ellipsoid that is seen from all sides";
    }

    /// <summary>How large the flakes look.</summary>
    /// <param name="point">Where; used only where they depend on the place.</param>
    /// <param name="direction">Unit direction from which they are seen, or the opposite one.</param>
    public FloatW Area(in Vec3W point, in Vec3W direction)
    {
        Matrix(point, out RgbW diagonal, out RgbW beside);
        return Root(diagonal, beside, direction);
    }

    /// <summary>How large they look at most, anywhere: <see cref="Area"/> where they do not depend on the place.</summary>
    /// <param name="direction">Unit direction from which they are seen.</param>
    public FloatW LargestArea(in Vec3W direction) =>
        Root(_diagonal, _beside, Vary ? new(FloatW.Abs(direction.X), FloatW.Abs(direction.Y), FloatW.Abs(direction.Z)) : direction);

    /// <summary>The fraction of the light that is scattered from one direction of travel to another, per steradian: D(h) / 4√(ωᵀSω), with h half-way between (their eq. 18).</summary>
    /// <param name="point">Where.</param>
    /// <param name="before">Unit direction of travel before.</param>
    /// <param name="after">Unit direction of travel afterwards.</param>
    public FloatW Evaluate(in Vec3W point, in Vec3W before, in Vec3W after)
    {
        Matrix(point, out RgbW diagonal, out RgbW beside);
        Factor(diagonal, beside, out RgbW pivots, out RgbW below);
        Vec3W half = after - before;
        FloatW x = half.X / pivots.R;
        FloatW y = FloatW.NegatedMultiplyAdd(below.R, x, half.Y) / pivots.G;
        FloatW z = FloatW.NegatedMultiplyAdd(below.B, y, FloatW.NegatedMultiplyAdd(below.G, x, half.Z)) / pivots.B;

        // D of the ellipsoid, 1/(π √|S| (hᵀS⁻¹h)²) for an h of length 1.
        FloatW ratio = Vec3W.Dot(half, half) / FloatW.Max(FloatW.MultiplyAdd(x, x, FloatW.MultiplyAdd(y, y, z * z)), Least);
        FloatW volume = pivots.R * pivots.G * pivots.B;
        return ratio * ratio * (1f / (4 * float.Pi)) / (volume * Root(diagonal, beside, before));
    }

    /// <summary>Chooses a direction of travel, with the density of <see cref="Evaluate"/>: reflects at a flake that is seen.</summary>
    /// <param name="point">Where.</param>
    /// <param name="before">Unit direction of travel before.</param>
    /// <param name="u">A random number.</param>
    /// <param name="v">Another one.</param>
    public Vec3W Scatter(in Vec3W point, in Vec3W before, FloatW u, FloatW v)
    {
        // The ellipsoid is the image of a ball by L, where S = LLᵀ. So its normals that are seen along ω are those of the ball that are seen along Lᵀω, which fall off with the cosine, times L.
        Matrix(point, out RgbW diagonal, out RgbW beside);
        Factor(diagonal, beside, out RgbW pivots, out RgbW below);
        Vec3W seen = new(
            -FloatW.MultiplyAdd(pivots.R, before.X, FloatW.MultiplyAdd(below.R, before.Y, below.G * before.Z)),
            -FloatW.MultiplyAdd(pivots.G, before.Y, below.B * before.Z),
            -(pivots.B * before.Z));
        Onb.FromNormal(Vec3W.Normalize(seen), out Onb frame);
        Vec3W ball = frame.ToWorld(Warp.CosineHemisphere(u, v));
        Vec3W normal = new(
            pivots.R * ball.X,
            FloatW.MultiplyAdd(below.R, ball.X, pivots.G * ball.Y),
            FloatW.MultiplyAdd(below.G, ball.X, FloatW.MultiplyAdd(below.B, ball.Y, pivots.B * ball.Z)));
        Vec3W after = Vec3W.MultiplyAdd(normal, -2f * Vec3W.Dot(before, normal) / Vec3W.Dot(normal, normal), before);
        return Vec3W.Normalize(after);
    }

    private void Matrix(in Vec3W point, out RgbW diagonal, out RgbW beside)
    {
        (diagonal, beside) = (_diagonal, _beside);
        if (_grid is not null)
        {
            _toGrid!.Point(point, out Vec3W there);
            _grid.Matrix(there, out diagonal, out beside);
        }
    }

    // Cholesky's factor: its diagonal, and its xy, xz and yz below.
    private static void Factor(in RgbW diagonal, in RgbW beside, out RgbW pivots, out RgbW below)
    {
        FloatW least = (diagonal.R + diagonal.G + diagonal.B) * LeastPivot;
        FloatW first = FloatW.Sqrt(FloatW.Max(diagonal.R, least));
        FloatW xy = beside.R / first;
        FloatW xz = beside.G / first;
        FloatW second = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(xy, xy, diagonal.G), least));
        FloatW yz = FloatW.NegatedMultiplyAdd(xy, xz, beside.B) / second;
        FloatW third = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(yz, yz, FloatW.NegatedMultiplyAdd(xz, xz, diagonal.B)), least));
        (pivots, below) = (new(first, second, third), new(xy, xz, yz));
    }

    // √(ωᵀSω).
    private static FloatW Root(in RgbW diagonal, in RgbW beside, in Vec3W d)
    {
        FloatW squares = FloatW.MultiplyAdd(d.X * d.X, diagonal.R, FloatW.MultiplyAdd(d.Y * d.Y, diagonal.G, d.Z * d.Z * diagonal.B));
        FloatW products = FloatW.MultiplyAdd(d.X * d.Y, beside.R, FloatW.MultiplyAdd(d.X * d.Z, beside.G, d.Y * d.Z * beside.B));
        return FloatW.Sqrt(FloatW.Max(FloatW.MultiplyAdd(products, 2f, squares), 0f));
    }
}
