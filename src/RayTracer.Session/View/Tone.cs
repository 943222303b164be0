using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>How light is brought onto the screen.</summary>
/// <param name="Exposure">In stops, −100 to 100: each doubles the light.</param>
/// <param name="ToneMap">The curve.</param>
public sealed record Tone(float Exposure, ToneMap ToneMap)
{
    /// <summary>Light as it is.</summary>
    public static Tone Plain { get; } = new(0, ToneMap.Clamp);
}
