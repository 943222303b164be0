using System.Diagnostics.CodeAnalysis;
using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The limits of the picture readers, so that a hostile file cannot ask for more memory than its own size justifies.</summary>
public static class PictureLimits
{
    /// <summary>The largest number of pixels that is read: 2²⁸ (16,384 × 16,384, 3 GiB as floats).</summary>
    public const long MaxPixels = 1L << 28;

    /// <summary>The largest width or height that is read: 2²⁰.</summary>
    public const int MaxSide = 1 << 20;

    /// <summary>The largest text (one key's value) that is read, in bytes: 2²⁴.</summary>
    public const int MaxTextBytes = 1 << 24;

    /// <summary>Deflate makes at most 258 bytes of 2 bits (RFC 1951): the reason why so few bytes cannot be so large a picture.</summary>
    internal const long MaxDeflateRatio = 1032;

    /// <summary>Refuses a file in which something does not hold. What is refused for every pixel should not make a text for it: it throws by itself.</summary>
    /// <exception cref="PictureException">The condition is false.</exception>
    internal static void Require([DoesNotReturnIf(false)] bool condition, string otherwise)
    {
        if (!condition)
        {
            throw new PictureException(otherwise);
        }
    }

    /// <summary>Checks a claimed size.</summary>
    /// <exception cref="PictureException">The size is zero, negative or beyond the limits.</exception>
    internal static void CheckSize(long width, long height)
    {
        Require(width >= 1 && height >= 1, $"the file claims a size of {width}×{height} pixels, and both must be at least 1");

        long most = Math.Min(MaxPixels, SceneBudget.Limit / (3 * sizeof(float)));
        if (width > MaxSide || height > MaxSide || width * height > most)
        {
            throw new PictureException($"the file claims a size of {width}×{height} pixels; at most {most} in all and {MaxSide} a side are read");
        }

        // Before the pixels are decoded.
        if (SceneBudget.Open?.TakeWork($"a picture of {width}×{height} pixels", 3 * sizeof(float) * width * height, width * height) is { } complaint)
        {
            throw new PictureException(complaint);
        }
    }

    /// <summary>Makes the picture.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="filled">True where every pixel will be set, so that it need not be black before.</param>
    /// <exception cref="PictureException">There is not enough memory.</exception>
    internal static Picture Allocate(int width, int height, bool filled = false)
    {
        try
        {
            return filled ? new Picture(width, height, GC.AllocateUninitializedArray<float>(3 * width * height)) : new Picture(width, height);
        }
        catch (OutOfMemoryException e)
        {
            throw new PictureException($"there is not enough memory for {width}×{height} pixels", e);
        }
    }
}
