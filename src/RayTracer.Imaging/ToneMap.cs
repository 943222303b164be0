namespace RayTracer.Imaging;

/// <summary>How linear light of any strength is brought into the [0, 1] that a display can show.</summary>
public enum ToneMap
{
    /// <summary>As it is; what lies outside [0, 1] is cut off. The only choice under which a PNG is exactly the film.</summary>
    Clamp,

    /// <summary>L/(1 + L) of the luminance, hue kept (Reinhard, Stark, Shirley, Ferwerda 2002, Equation 3).</summary>
    Reinhard,

    /// <summary>
    /// Film-like: Stephen Hill's fit of the ACES reference rendering and sRGB output transforms (Hill 2016, in Pettineo's BakingLab).
    /// </summary>
    Aces,

    /// <summary>Film-like, bright colours fade to white: Troy Sobotka's AgX in the polynomial approximation of Wrensch 2023.</summary>
    Agx,
}
