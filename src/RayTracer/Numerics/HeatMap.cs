namespace RayTracer.Numerics;

/// <summary>
/// Colours for numbers from 0 to 1: black, violet, red, orange, yellowish white. They grow lighter all the way, so that a grey print shows the
/// same order.
/// </summary>
internal static class HeatMap
{
    /// <summary>The colours in words, from the smallest number to the largest.</summary>
    public const string Legend = "black, violet, red, orange, white";

    /// <summary>The colours, display values (sRGB-encoded) at equal distances.</summary>
    public static IReadOnlyList<Rgb> Colors { get; } =
        [new(0, 0, 0), new(0.33f, 0.08f, 0.5f), new(0.85f, 0.2f, 0.25f), new(1, 0.65f, 0.1f), new(1, 1, 0.85f)];

    /// <summary>The colour, in display values (sRGB-encoded), of a number; those outside of 0 to 1 have the colours of the ends.</summary>
    public static Rgb Color(double fraction)
    {
        double place = Math.Clamp(double.IsNaN(fraction) ? 0 : fraction, 0, 1) * (Colors.Count - 1);
        int below = Math.Min((int)place, Colors.Count - 2);
        float weight = (float)(place - below);
        return (Colors[below] * (1 - weight)) + (Colors[below + 1] * weight);
    }
}
