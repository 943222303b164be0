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

/// <summary>The exposure of a picture for a display: so many stops, or as the picture itself asks for.</summary>
/// <param name="Stops">Each doubles the light; 0 where the picture decides.</param>
/// <param name="IsAuto">True where the picture decides: its middle brightness becomes that of a middle grey.</param>
public readonly record struct Exposure(float Stops, bool IsAuto = false)
{
    /// <summary>The most stops, and the fewest below 0.</summary>
    public const float Limit = 100;

    /// <summary>The word for <see cref="Auto"/>.</summary>
    public const string AutoWord = "auto";

    /// <summary>As the picture asks for.</summary>
    public static Exposure Auto { get; } = new(0, IsAuto: true);

    /// <summary>So many stops.</summary>
    public static implicit operator Exposure(float stops) => new(stops);

    /// <inheritdoc/>
    public override string ToString() => IsAuto ? AutoWord : Stops.ToString(CultureInfo.InvariantCulture);
}
