using System.Numerics;
using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Finds what is seen in a picture.</summary>
public static class Picking
{
    private const int LargestMask = 1 << 20;

    /// <summary>The surface in the middle of a pixel.</summary>
    /// <param name="shown">The scene.</param>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    public static PickResult At(ViewportScene shown, float x, float y) =>
        Hit(shown, x, y) is { } hit
            ? new(shown.PointerOf(hit.Name), hit.Distance, hit.Position, hit.Normal, shown.MaterialOf(hit.Name))
            : new(null, null, null, null, null);

    /// <summary>The same for choosing things: one that is locked is none.</summary>
    /// <param name="document">The document that is shown.</param>
    /// <param name="shown">The scene.</param>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    public static PickResult Selectable(SceneDocument document, ViewportScene shown, float x, float y) =>
        At(shown, x, y) is var seen && document.IsLocked(seen.Pointer) ? seen with { Pointer = null } : seen;

    /// <summary>The pixels in which a thing, or one within it, is what is seen first.</summary>
    /// <param name="shown">The scene.</param>
    /// <param name="pointer">The thing.</param>
    /// <param name="step">Only every so many pixels across and down, for one that is soon out of date.</param>
    /// <exception cref="SessionException">The step is not from 1 to 16.</exception>
    public static PixelMask Mask(ViewportScene shown, string pointer, int step = 1)
    {
        const int coarsest = 16;
        if (step is < 1 or > coarsest)
        {
            throw new SessionException("The step must be from 1 to 16.");
        }

        RenderDescription render = shown.Scene.Render;
        while ((long)(render.Width / step) * (render.Height / step) > LargestMask)
        {
            step++;
        }

        (int width, int height) = (Math.Max(1, render.Width / step), Math.Max(1, render.Height / step));
        SurfaceName[] names = new SurfaceName[width * height];
        Parallel.For(0, height, () => new SurfaceProbe(shown.Scene), (y, _, probe) =>
        {
            probe.Name((y + 0.5f) * step, 0.5f * step, step, names.AsSpan(y * width, width));
            return probe;
        }, _ => { });
        return new(width, height, Runs(shown, names, pointer));
    }

    /// <summary>Returns whether a pointer is that of a thing, or of one within it.</summary>
    public static bool IsWithin(string? inner, string outer) =>
        inner is not null && inner.StartsWith(outer, StringComparison.Ordinal) && (inner.Length == outer.Length || inner[outer.Length] == '/');

    private static SurfaceHit? Hit(ViewportScene shown, float x, float y)
    {
        RenderDescription render = shown.Scene.Render;
        if (!(x >= 0 && x < render.Width && y >= 0 && y < render.Height))
        {
            throw new SessionException($"The picture has {render.Width}×{render.Height} pixels.", SessionFault.Missing);
        }

        return new SurfaceProbe(shown.Scene).Describe(MathF.Floor(x) + 0.5f, MathF.Floor(y) + 0.5f);
    }

    private static List<int> Runs(ViewportScene shown, SurfaceName[] names, string pointer)
    {
        List<int> runs = [];
        SurfaceName last = SurfaceName.None;
        bool isLast = false;
        for (int i = 0; i < names.Length; i++)
        {
            if (names[i] != last)
            {
                (last, isLast) = (names[i], IsWithin(shown.PointerOf(names[i]), pointer));
            }

            if (!isLast)
            {
                continue;
            }

            if (runs.Count > 0 && runs[^2] + runs[^1] == i)
            {
                runs[^1]++;
            }
            else
            {
                runs.Add(i);
                runs.Add(1);
            }
        }

        return runs;
    }
}

/// <summary>The surface seen at a pixel.</summary>
/// <param name="Pointer">The thing in the text; null where nothing is seen.</param>
/// <param name="Distance">The distance; null where nothing is seen.</param>
/// <param name="Position">The position in the world.</param>
/// <param name="Normal">The normal there, towards the camera.</param>
/// <param name="Material">The thing's material in the text; null where it is not from the text.</param>
public sealed record PickResult(string? Pointer, float? Distance, Vector3? Position, Vector3? Normal, string? Material);

/// <summary>Some pixels of a picture.</summary>
/// <param name="Width">Width of the picture, which may be smaller than the rendered one.</param>
/// <param name="Height">Its height.</param>
/// <param name="Runs">Start and length of each run of pixels, counted row by row.</param>
public sealed record PixelMask(int Width, int Height, IReadOnlyList<int> Runs);
