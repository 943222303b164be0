using System.Globalization;

namespace RayTracer.Description;

/// <summary>The curves that bring linear light of any strength into the [0, 1] that a display can show.</summary>
public enum ToneMap
{
    /// <summary>As it is; what lies outside [0, 1] is cut off. The only choice under which a PNG is exactly the film.</summary>
    Clamp,

    /// <summary>
    /// As it is up to 0.7; brighter light keeps its hue and fades to white slowly (the curve of the Khronos Group 2024, without its offset).
    /// </summary>
    Soft,

    /// <summary>L/(1 + L) of the luminance, hue kept (Reinhard, Stark, Shirley, Ferwerda 2002, Equation 3).</summary>
    Reinhard,

    /// <summary>
    /// Film-like: Stephen Hill's fit of the ACES reference rendering and sRGB output transforms (Hill 2016, in Pettineo's BakingLab).
    /// </summary>
    Aces,

    /// <summary>Film-like, bright colours fade to white: Troy Sobotka's AgX in the polynomial approximation of Wrensch 2023.</summary>
    Agx,
}

/// <summary>Who decides on the exposure of a picture.</summary>
public enum ExposureRule
{
    /// <summary>The user, who names the stops.</summary>
    Stops,

    /// <summary>The picture, if it would be a white sheet: it is darkened until three quarters of what is lit are no brighter than a display.</summary>
    Limited,

    /// <summary>The picture: its middle brightness becomes that of a middle grey.</summary>
    Auto,
}

/// <summary>The exposure of a picture for a display: so many stops, or as the picture itself asks for.</summary>
/// <param name="Stops">Each doubles the light; 0 where the picture decides.</param>
/// <param name="Rule">The one who decides.</param>
public readonly record struct Exposure(float Stops, ExposureRule Rule = ExposureRule.Stops)
{
    /// <summary>The most stops, and the fewest below 0.</summary>
    public const float Limit = 100;

    /// <summary>As the picture asks for.</summary>
    public static Exposure Auto { get; } = new(0, ExposureRule.Auto);

    /// <summary>As it is, but no white sheet.</summary>
    public static Exposure Limited { get; } = new(0, ExposureRule.Limited);

    /// <summary>The words for those that are no stops.</summary>
    public static IReadOnlyList<string> Words { get; } = [Auto.ToString(), Limited.ToString()];

    /// <summary>So many stops.</summary>
    public static implicit operator Exposure(float stops) => new(stops);

    /// <summary>The exposure that a word stands for; null where it is none of <see cref="Words"/>.</summary>
    /// <param name="word">The word, in lower case.</param>
    public static Exposure? Named(string? word) => word == Words[0] ? Auto : word == Words[1] ? Limited : null;

    /// <inheritdoc/>
    public override string ToString() =>
        Rule == ExposureRule.Stops ? Stops.ToString(CultureInfo.InvariantCulture) : Rule.ToString().ToLowerInvariant();
}
