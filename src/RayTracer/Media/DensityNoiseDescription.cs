using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Media;

/// <summary>Describes the density of a cloud that noise makes, on a grid of its own.</summary>
public sealed record DensityNoiseDescription
{
    /// <summary>Two opposite corners of the box that the cloud fills, before the transform; empty for the unit cube.</summary>
    [Parameter("Two opposite corners of the box that the cloud fills, in the world's coordinates. Without it, the unit cube.", Unit = "scene units")]
    public IReadOnlyList<Vector3> Box { get; init; } = [];

    /// <summary>The transform of the box; empty for the identity.</summary>
    [Parameter("How the box is moved in the world: steps, the first one applied first. It does not follow the transform of the shape that it fills.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>Cells of the first octave in a unit.</summary>
    [Parameter("Cells of the noise per unit of the box before its transform: larger numbers make it finer.", Unit = "1/scene unit", Minimum = 0)]
    public float Scale { get; init; } = 2;

    /// <summary>Number of octaves.</summary>
    [Parameter("Octaves of noise that are summed, each twice as fine as the one before.", Minimum = 1, Maximum = 16)]
    public int Octaves { get; init; } = 5;

    /// <summary>Height of each octave over that of the one before.</summary>
    [Parameter("Amplitude of each octave relative to the one before: larger numbers make it rougher.", Minimum = 0, Maximum = 1)]
    public float Gain { get; init; } = 0.5f;

    /// <summary>True where magnitudes are summed.</summary>
    [Parameter("Whether the magnitudes of the octaves are summed, which gives billows with creases.")]
    public bool Turbulent { get; init; }

    /// <summary>The amount of noise from which there is something.</summary>
    [Parameter("The noise, which is ½ on average (0 with turbulent) and at most 1, below which there is nothing; from there the density grows to 1.", Minimum = 0, Maximum = 0.99)]
    public float Threshold { get; init; } = 0.3f;

    /// <summary>How much the noise falls off towards the faces of the box.</summary>
    [Parameter("How much is taken from the noise towards the faces of the box: this much in the middle of a face, by the square of the distance from the middle of the box. 0 fills the box evenly.",
        Minimum = 0, Maximum = 10)]
    public float Falloff { get; init; } = 0.5f;

    /// <summary>Points of the grid along the longest side.</summary>
    [Parameter("Points of the grid on which the noise is computed, along the longest side of the box; between them, it is linear.", Minimum = 2, Maximum = 512)]
    public int Resolution { get; init; } = 96;

    /// <summary>Selects the noise.</summary>
    [Parameter("Selects the noise.", Minimum = 0, Maximum = 1e9)]
    public int Seed { get; init; }

    /// <summary>The density in its place; null after an error.</summary>
    internal PlacedGrid? Build(SceneBuilder builder)
    {
        if (GridBox.Place(this, Box, Transform, null, builder) is not { } place)
        {
            return null;
        }

        Vector3 corner = Box.Count == 2 ? Box[0] : Vector3.Zero;
        Vector3 sides = Box.Count == 2 ? Box[1] - corner : Vector3.One;
        float longest = float.Max(float.Abs(sides.X), float.Max(float.Abs(sides.Y), float.Abs(sides.Z)));
        int Count(float side) => int.Max(1, (int)float.Round(Resolution * (float.Abs(side) / longest)));
        (int nx, int ny, int nz) = (Count(sides.X), Count(sides.Y), Count(sides.Z));
        long numbers = (long)nx * ny * nz;
        if (builder.Budget.Take($"noise of {nx}×{ny}×{nz} points", 2 * sizeof(float) * numbers, numbers * Octaves) is { } tooMuch)
        {
            builder.Error(this, nameof(Resolution), tooMuch);
            return null;
        }

        float[] values = new float[numbers];
        Parallel.For(0, ny * nz, row => Fill(values.AsSpan(row * nx, nx), corner, sides, ((row % ny) + 0.5f) / ny, ((row / ny) + 0.5f) / nz));
        return new(new(nx, ny, nz, 1, values), place, GridInterpolation.Trilinear, Wrapping.Clamp);
    }

    // One row of the grid, along x.
    private unsafe void Fill(Span<float> row, Vector3 corner, Vector3 sides, float v, float w)
    {
        float* lanes = stackalloc float[FloatW.Count];
        FloatW y = (2 * v) - 1;
        FloatW z = (2 * w) - 1;
        for (int i = 0; i < row.Length; i += FloatW.Count)
        {
            FloatW u = (FloatW.Iota + (i + 0.5f)) / row.Length;
            Vec3W at = new(FloatW.MultiplyAdd(u, sides.X, corner.X), corner.Y + (v * sides.Y), corner.Z + (w * sides.Z));
            FloatW noise = GradientNoise.Sum(at * Scale, (uint)Seed, Octaves, Gain, Turbulent);
            FloatW x = FloatW.MultiplyAdd(u, 2f, -1f);
            FloatW fromMiddle = FloatW.MultiplyAdd(x, x, FloatW.MultiplyAdd(y, y, z * z));
            FloatW amount = FloatW.NegatedMultiplyAdd(Falloff, fromMiddle, Turbulent ? noise : FloatW.MultiplyAdd(noise, 0.5f, 0.5f));
            FloatW.Max(0f, FloatW.Min((amount - Threshold) * (1 / (1 - Threshold)), 1f)).Store(lanes);
            new Span<float>(lanes, int.Min(FloatW.Count, row.Length - i)).CopyTo(row[i..]);
        }
    }
}
