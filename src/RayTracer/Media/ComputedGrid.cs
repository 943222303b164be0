using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Media;

/// <summary>The density at points of a grid.</summary>
/// <param name="place">The points, in coordinates of the box before its transform.</param>
/// <param name="unit">The same from 0 to 1 within the box.</param>
/// <param name="density">The density.</param>
internal delegate void DensityAt(in Vec3W place, in Vec3W unit, out FloatW density);

/// <summary>A grid of one's own, on which a formula for the density is computed once.</summary>
/// <param name="Box">Two opposite corners; empty for the unit cube.</param>
/// <param name="Transform">The transform of the box.</param>
/// <param name="Resolution">Points along the longest side.</param>
/// <param name="Work">The octaves of noise at a point.</param>
internal readonly record struct ComputedGrid(IReadOnlyList<Vector3> Box, IReadOnlyList<TransformDescription> Transform, int Resolution, int Work)
{
    /// <summary>The grid in its place; null after an error.</summary>
    /// <param name="subject">The record that describes the density, with its resolution.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    /// <param name="density">The formula.</param>
    public PlacedGrid? Build(object subject, SceneBuilder builder, DensityAt density)
    {
        if (GridBox.Place(subject, Box, Transform, null, builder) is not { } place)
        {
            return null;
        }

        Vector3 corner = Box.Count == 2 ? Box[0] : Vector3.Zero;
        Vector3 sides = Box.Count == 2 ? Box[1] - corner : Vector3.One;
        float longest = float.Max(float.Abs(sides.X), float.Max(float.Abs(sides.Y), float.Abs(sides.Z)));
        int resolution = Resolution;
        int Count(float side) => int.Max(1, (int)float.Round(resolution * (float.Abs(side) / longest)));
        (int nx, int ny, int nz) = (Count(sides.X), Count(sides.Y), Count(sides.Z));
        long numbers = (long)nx * ny * nz;
        if (builder.Budget.Take($"noise of {nx}×{ny}×{nz} points", 2 * sizeof(float) * numbers, numbers * Work) is { } tooMuch)
        {
            builder.Error(subject, nameof(Resolution), tooMuch);
            return null;
        }

        float[] values = new float[numbers];
        Parallel.For(0, ny * nz, row => Fill(values.AsSpan(row * nx, nx), corner, sides, ((row % ny) + 0.5f) / ny, ((row / ny) + 0.5f) / nz, density));
        return new(new(nx, ny, nz, 1, values), place, GridInterpolation.Trilinear, Wrapping.Clamp);
    }

    // One row of the grid, along x.
    private static unsafe void Fill(Span<float> row, Vector3 corner, Vector3 sides, float v, float w, DensityAt density)
    {
        float* lanes = stackalloc float[FloatW.Count];
        for (int i = 0; i < row.Length; i += FloatW.Count)
        {
            FloatW u = (FloatW.Iota + (i + 0.5f)) / row.Length;
            Vec3W at = new(FloatW.MultiplyAdd(u, sides.X, corner.X), corner.Y + (v * sides.Y), corner.Z + (w * sides.Z));
            density(at, new(u, v, w), out FloatW there);
            there.Store(lanes);
            new Span<float>(lanes, int.Min(FloatW.Count, row.Length - i)).CopyTo(row[i..]);
        }
    }
}
