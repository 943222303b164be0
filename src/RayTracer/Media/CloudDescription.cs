using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Media;

/// <summary>Describes the density of a cumulus cloud, full at the bottom of its box and thinner upwards, as pbrt-v4's medium "cloud" makes it, on a grid of its own.</summary>
public sealed record CloudDescription
{
    /// <summary>Two opposite corners of the box that the cloud fills, before the transform; empty for the unit cube.</summary>
    [Parameter("Two opposite corners of the box that the cloud fills, in coordinates of its own, in which it is full below y = ½ and ends at y = 1. Without it, the unit cube.", Unit = "scene units")]
    public IReadOnlyList<Vector3> Box { get; init; } = [];

    /// <summary>The transform of the box; empty for the identity.</summary>
    [Parameter("How the box is moved in the world: steps, the first one applied first. It does not follow the transform of the shape that it fills.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>How much of the cloud there is.</summary>
    [Parameter("Factor on the noise, before the density is cut off at 1: larger numbers leave fewer holes.", Minimum = 0)]
    public float Density { get; init; } = 1;

    /// <summary>How much the noise is torn.</summary>
    [Parameter("How much the cloud is torn into wisps.", Minimum = 0)]
    public float Wispiness { get; init; } = 1;

    /// <summary>Cells of the noise in a unit.</summary>
    [Parameter("Cells of the first of five octaves of noise per unit of the box before its transform.", Unit = "1/scene unit", Minimum = 0)]
    public float Frequency { get; init; } = 5;

    /// <summary>Points of the grid along the longest side.</summary>
    [Parameter("Points of the grid on which the density is computed, along the longest side of the box; between them, it is linear.", Minimum = 2, Maximum = 512)]
    public int Resolution { get; init; } = 128;

    /// <summary>The density in its place; null after an error.</summary>
    internal PlacedGrid? Build(SceneBuilder builder) => new ComputedGrid(Box, Transform, Resolution, Work: 13).Build(this, builder, At);

    // The slope of the noise moves the places at which it is asked.
    private void At(in Vec3W place, in Vec3W unit, out FloatW density)
    {
        Vec3W at = place * Frequency;
        (float height, float frequency) = (0.05f * Wispiness, 10);
        for (int i = 0; i < 2 && Wispiness > 0; i++)
        {
            at = Vec3W.MultiplyAdd(Slope(at * frequency), height, at);
            height *= 0.5f;
            frequency *= PerlinTexture.Finer;
        }

        FloatW noise = PerlinTexture.Sum(at, 5, 0.5f, isMagnitude: false) * 0.5f;
        FloatW amount = FloatW.Max(0f, FloatW.Min((1f - place.Y) * noise * (4.5f * Density), 1f));
        density = FloatW.Min(FloatW.MultiplyAdd(FloatW.Max(0f, 0.5f - place.Y), 2f, amount), 1f);
    }

    private static Vec3W Slope(in Vec3W p)
    {
        const float Step = 0.01f;
        FloatW here = GradientNoise.Tabled(p);
        FloatW alongX = GradientNoise.Tabled(p + new Vec3W(Step, 0f, 0f)) - here;
        FloatW alongY = GradientNoise.Tabled(p + new Vec3W(0f, Step, 0f)) - here;
        FloatW alongZ = GradientNoise.Tabled(p + new Vec3W(0f, 0f, Step)) - here;
        return new Vec3W(alongX, alongY, alongZ) * (1 / Step);
    }
}
