using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.SamplePlugin;

/// <summary>Describes <see cref="Stripes"/>.</summary>
[SceneType("stripes", "Two colours in turn along u.")]
public sealed record StripesDescription : TextureDescription
{
    /// <summary>The number of stripes.</summary>
    [Parameter("Pairs of stripes from u = 0 to 1.", Minimum = 1, Maximum = 1000)]
    public int Count { get; init; } = 8;

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new Stripes(Count);
}

/// <summary>White and grey in turn along u.</summary>
public sealed class Stripes(int count) : Texture(TextureInputs.Uv)
{
    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        FloatW place = at.U * count;
        color = (place - FloatW.Floor(place) < 0.5f).Select(new Rgb(0.9f, 0.9f, 0.9f), new Rgb(0.3f, 0.3f, 0.3f));
    }
}
