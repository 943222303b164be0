namespace RayTracer.RenderTests.Oracle;

/// <summary>
/// SplitMix64 (Steele, Lea &amp; Flood 2014). System.Random with a seed is a subtractive generator whose numbers depend on one
/// another three at a time; paths of light use enough of them for that to matter.
/// </summary>
/// <param name="seed">Selects the numbers.</param>
internal sealed class RandomNumbers(ulong seed)
{
    private ulong _state = seed;

    /// <summary>The next number in [0, 1).</summary>
    public double Next()
    {
        _state += 0x9e3779b97f4a7c15;
        ulong z = (_state ^ (_state >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53));
    }

    /// <summary>A number between −½ and ½.</summary>
    public double Centred() => Next() - 0.5;

    /// <summary>A direction around the z axis whose cosine to it is given.</summary>
    public Vec Around(double cosine)
    {
        double sine = Math.Sqrt(Math.Max(0, 1 - (cosine * cosine)));
        double angle = 2 * Math.PI * Next();
        return new(sine * Math.Cos(angle), sine * Math.Sin(angle), cosine);
    }

    /// <summary>A direction, all alike.</summary>
    public Vec Direction() => Around(1 - (2 * Next()));
}
