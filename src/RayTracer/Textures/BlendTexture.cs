using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Two textures, and how much of the second there is at each point.</summary>
/// <param name="inputs">The inputs on which the amount depends.</param>
/// <param name="first">The texture where the amount is 0.</param>
/// <param name="second">The texture where it is 1.</param>
internal abstract class BlendTexture(TextureInputs inputs, Texture first, Texture second) : Texture(inputs | first.Inputs | second.Inputs)
{
    /// <summary>The texture where the amount is 0.</summary>
    protected Texture First => first;

    /// <summary>The texture where the amount is 1.</summary>
    protected Texture Second => second;

    /// <inheritdoc/>
    public override long MemoryBytes => first.MemoryBytes + second.MemoryBytes;

    /// <inheritdoc/>
    public sealed override void Evaluate(in TexturePointW at, out RgbW color)
    {
        Amount(at, out FloatW amount);
        first.Evaluate(at, out RgbW a);
        second.Evaluate(at, out RgbW b);
        color = RgbW.MultiplyAdd(b, amount, a * (1f - amount));
    }

    /// <summary>The weight of the second texture, from 0 to 1.</summary>
    protected abstract void Amount(in TexturePointW at, out FloatW amount);
}
