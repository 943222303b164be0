using RayTracer.Rendering;

namespace RayTracer.Imaging;

/// <summary>One half of a picture's samples, and what their camera rays met first.</summary>
/// <param name="Film">The samples' film.</param>
/// <param name="Features">Normals and albedos of the same samples.</param>
public sealed record HalfRender(Film Film, AovFilm Features)
{
    /// <summary>The auxiliary images that a denoiser needs.</summary>
    public static IReadOnlyList<AuxiliaryImage> Kinds { get; } = [new NormalImage(), new AlbedoImage()];

    /// <summary>An empty half.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    public static HalfRender Create(int width, int height)
    {
        Film film = new(width, height);
        return new(film, new AovFilm(film, Kinds));
    }
}
