using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>A request of how a picture is written.</summary>
/// <param name="BitDepth">PNG: bits a channel, 8 or 16.</param>
/// <param name="Layers">Auxiliary images to write too: as layers of an OpenEXR file, else in files beside it.</param>
public sealed record PictureRequest(int BitDepth, IReadOnlyList<AuxiliaryImage> Layers)
{
    /// <summary>A request in words.</summary>
    /// <param name="bitDepth">Bits a channel; null for 8.</param>
    /// <param name="layers">Names of auxiliary images.</param>
    /// <exception cref="SessionException">There are no such images or depths.</exception>
    public static PictureRequest Of(int? bitDepth, IEnumerable<string> layers)
    {
        if (bitDepth is not (null or 8 or 16))
        {
            throw new SessionException("A PNG is written with 8 or 16 bits per channel.");
        }

        return new(bitDepth ?? 8, [.. layers.Select(name => AuxiliaryImage.Known.Find(name)
            ?? throw new SessionException($"There is no layer {name}."))]);
    }
}
