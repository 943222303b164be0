using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What the light of a path is a product of, beside its weight, for those who look at paths (Veach 1997, section 10.2; Georgiev et al. 2012). What is zero is no
/// factor of that way to make paths.
/// </summary>
internal struct WayFactorsW
{
    /// <summary>The throughput of the camera's part.</summary>
    public RgbW CameraPart;

    /// <summary>The BSDF, or phase function, at its end.</summary>
    public RgbW CameraBsdf;

    /// <summary>The power that the light's part carries.</summary>
    public RgbW LightPart;

    /// <summary>The BSDF, or phase function, at its end.</summary>
    public RgbW LightBsdf;

    /// <summary>The radiance of a light that is met or asked; the irradiance of one without extent.</summary>
    public RgbW Radiance;

    /// <summary>What media leave on the edge between both parts, to the light or to the lens; white where it is free.</summary>
    public RgbW Left;

    /// <summary>The cosines at the ends of that edge, over its squared length where that is chosen by neither end.</summary>
    public FloatW Geometry;

    /// <summary>The density of the point of a light that is asked, by which is divided.</summary>
    public FloatW Pdf;

    /// <summary>The camera rays per area at what is seen, one for each pixel.</summary>
    public FloatW Lens;

    /// <summary>The part of a photon's power that counts: one over the light paths that a circle takes in for each unit of their density, N·πr².</summary>
    public FloatW Kernel;

    /// <summary>Camera paths for each light path that is connected, or light paths for the lens.</summary>
    public FloatW Paths;

    /// <summary>Those of a lane.</summary>
    public readonly WayFactors this[int lane] => new(
        Of(CameraPart, lane), Of(CameraBsdf, lane), Of(LightPart, lane), Of(LightBsdf, lane), Of(Radiance, lane), Of(Left, lane), Geometry[lane], Pdf[lane], Lens[lane], Kernel[lane], Paths[lane]);

    private static Rgb Of(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);
}

/// <summary>The same of one path.</summary>
internal readonly record struct WayFactors(
    Rgb CameraPart, Rgb CameraBsdf, Rgb LightPart, Rgb LightBsdf, Rgb Radiance, Rgb Left, float Geometry, float Pdf, float Lens, float Kernel, float Paths)
{
    /// <summary>The weight that the pixel filter gives.</summary>
    public float Filter { get; init; } = 1;

    /// <summary>All that are factors of the path, from the camera to the light.</summary>
    public IReadOnlyList<TracedFactor> All => [.. ((TracedFactor[])
    [
        new(WayFactor.CameraPart, CameraPart), new(WayFactor.CameraBsdf, CameraBsdf), new(WayFactor.Lens, Rgb.White * Lens), new(WayFactor.Geometry, Rgb.White * Geometry), new(WayFactor.Left, Left),
        new(WayFactor.Kernel, Rgb.White * Kernel), new(WayFactor.LightBsdf, LightBsdf), new(WayFactor.LightPart, LightPart), new(WayFactor.Radiance, Radiance), new(WayFactor.Pdf, Rgb.White * Pdf),
        new(WayFactor.Paths, Rgb.White * Paths), new(WayFactor.Filter, Rgb.White * (Filter == 1 ? 0 : Filter)),
    ]).Where(f => f.Value != Rgb.Black)];
}
