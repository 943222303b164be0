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
    internal PlacedGrid? Build(SceneBuilder builder) => new ComputedGrid(Box, Transform, Resolution, Octaves).Build(this, builder, At);

    private void At(in Vec3W place, in Vec3W unit, out FloatW density)
    {
        FloatW noise = GradientNoise.Sum(place * Scale, (uint)Seed, Octaves, Gain, Turbulent);
        FloatW x = FloatW.MultiplyAdd(unit.X, 2f, -1f);
        FloatW y = (2f * unit.Y) - 1f;
        FloatW z = (2f * unit.Z) - 1f;
        FloatW fromMiddle = FloatW.MultiplyAdd(x, x, FloatW.MultiplyAdd(y, y, z * z));
        FloatW amount = FloatW.NegatedMultiplyAdd(Falloff, fromMiddle, Turbulent ? noise : FloatW.MultiplyAdd(noise, 0.5f, 0.5f));
        density = FloatW.Max(0f, FloatW.Min((amount - Threshold) * (1 / (1 - Threshold)), 1f));
    }
}
