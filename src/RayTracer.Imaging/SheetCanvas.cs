using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>A dark sheet on which images and lines of text are placed.</summary>
internal sealed class SheetCanvas
{
    /// <summary>Pixels between images.</summary>
    public const int Gap = 8;

    private const float Paper = 0.03f;
    private const float Ink = 0.8f;

    /// <summary>Makes an empty sheet.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="dot">Pixels across a dot of the letters.</param>
    public SheetCanvas(int width, int height, int dot)
    {
        Dot = dot;
        float[] pixels = new float[checked(3 * width * height)];
        Array.Fill(pixels, Paper);
        Picture = new(width, height, pixels);
    }

    /// <summary>The drawing: linear RGB.</summary>
    public Picture Picture { get; }

    /// <summary>Pixels across a dot of the letters.</summary>
    public int Dot { get; }

    /// <summary>Pixels from one line of text to the next.</summary>
    public int Line => LineFor(Dot);

    /// <summary>
    /// Returns the size of letters beside images of a size: lines of them are no higher than an image, but for the flattest.
    /// </summary>
    public static int DotFor(int width, int height = int.MaxValue) =>
        Math.Clamp(Math.Min(width / 200, height / (SmallFont.Height + 3)), 1, 8);

    /// <summary>Pixels from one line of text to the next.</summary>
    public static int LineFor(int dot) => (SmallFont.Height + 3) * dot;

    /// <summary>Pixels that a number of letters take.</summary>
    public static int WidthOf(int letters, int dot) => ((letters * SmallFont.Advance) - 1) * dot;

    /// <summary>Pixels that a text takes.</summary>
    public int WidthOf(string text) => WidthOf(text.Length, Dot);

    /// <summary>Places an image.</summary>
    public void Place(IImageRows image, int left, int top)
    {
        float[] row = new float[3 * image.Width];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            row.CopyTo(Picture.Pixels.AsSpan(3 * (((top + y) * Picture.Width) + left)));
        }
    }

    /// <summary>Writes as many letters of a text as there is room for.</summary>
    public void Write(string text, int left, int top, int room)
    {
        int letters = Math.Min(text.Length, (room + Dot) / (SmallFont.Advance * Dot));
        for (int i = 0; i < letters * SmallFont.Advance; i++)
        {
            for (int row = 0; row < SmallFont.Height && i % SmallFont.Advance < 5; row++)
            {
                if (top + (row * Dot) >= 0 && top + ((row + 1) * Dot) <= Picture.Height && SmallFont.Has(text[i / SmallFont.Advance], i % SmallFont.Advance, row))
                {
                    Mark(left + (i * Dot), top + (row * Dot));
                }
            }
        }
    }

    /// <summary>Sets a pixel.</summary>
    public void Set(int x, int y, Rgb color)
    {
        int at = 3 * ((y * Picture.Width) + x);
        (Picture.Pixels[at], Picture.Pixels[at + 1], Picture.Pixels[at + 2]) = color;
    }

    private void Mark(int left, int top)
    {
        for (int i = 0; i < Dot * Dot; i++)
        {
            Set(left + (i % Dot), top + (i / Dot), new(Ink, Ink, Ink));
        }
    }
}
