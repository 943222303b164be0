using System.Globalization;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Two images and the map of what differs between them, side by side, each with a label, and a scale below the map.</summary>
public static class ComparisonSheet
{
    private const int Gap = 8;
    private const float Paper = 0.03f;
    private const float Ink = 0.8f;
    private static readonly double[] s_marks = [0, 0.25, 0.5, 0.75, 1];

    /// <summary>Draws the sheet.</summary>
    /// <param name="image">Linear RGB.</param>
    /// <param name="imageLabel">What it is called.</param>
    /// <param name="reference">The same of the reference.</param>
    /// <param name="referenceLabel">What it is called.</param>
    /// <param name="error">What differs.</param>
    public static Picture Draw(IImageRows image, string imageLabel, IImageRows reference, string referenceLabel, FlipError error)
    {
        Canvas canvas = new(image, 3);
        canvas.Place(image, 0, imageLabel);
        canvas.Place(reference, 1, referenceLabel);
        canvas.PlaceMap(error, 2);
        return canvas.Picture;
    }

    /// <summary>Draws the map of what differs alone, with its scale.</summary>
    public static Picture Draw(FlipError error)
    {
        Canvas canvas = new(error, 1);
        canvas.PlaceMap(error, 0);
        return canvas.Picture;
    }

    // Panels of one size in a row: a line of text above each, and room for a scale below.
    private sealed class Canvas
    {
        private readonly int _dot;
        private readonly int _width;
        private readonly int _height;

        public Canvas(IImageRows panel, int panels)
        {
            (_width, _height) = (panel.Width, panel.Height);
            _dot = Math.Clamp(_width / 200, 1, 8);
            int across = (panels * (_width + Gap)) + Gap;
            int down = _height + (3 * Line) + (2 * Gap);
            Picture = new(across, down, [.. Enumerable.Repeat(Paper, checked(3 * across * down))]);
        }

        public Picture Picture { get; }

        private int Line => (SmallFont.Height + 3) * _dot;

        public void Place(IImageRows image, int panel, string label)
        {
            Write(label, Left(panel), Gap, _width);
            float[] row = new float[3 * _width];
            for (int y = 0; y < _height; y++)
            {
                image.ReadRow(y, row);
                row.CopyTo(Picture.Pixels.AsSpan(3 * (((Gap + Line + y) * Picture.Width) + Left(panel))));
            }
        }

        public void PlaceMap(FlipError error, int panel)
        {
            Place(error, panel, string.Create(CultureInfo.InvariantCulture, $"FLIP: mean {error.Mean:F4}"));
            int top = Gap + Line + _height + (2 * _dot);
            for (int y = top; y < top + Line - (3 * _dot); y++)
            {
                for (int x = 0; x < _width; x++)
                {
                    Rgb shown = HeatMap.Color((x + 0.5) / _width);
                    Set(Left(panel) + x, y, new((float)SrgbCurve.Decode(shown.R), (float)SrgbCurve.Decode(shown.G), (float)SrgbCurve.Decode(shown.B)));
                }
            }

            foreach (double mark in s_marks.Where(m => _width >= 150 || m is 0 or 1))
            {
                string text = mark.ToString(CultureInfo.InvariantCulture);
                int wide = ((text.Length * SmallFont.Advance) - 1) * _dot;
                Write(text, Left(panel) + (int)(mark * (_width - wide)), top + Line, wide);
            }
        }

        private int Left(int panel) => Gap + (panel * (_width + Gap));

        private void Write(string text, int left, int top, int room)
        {
            int letters = Math.Min(text.Length, (room + _dot) / (SmallFont.Advance * _dot));
            for (int i = 0; i < letters * SmallFont.Advance; i++)
            {
                for (int row = 0; row < SmallFont.Height && i % SmallFont.Advance < 5; row++)
                {
                    if (SmallFont.Has(text[i / SmallFont.Advance], i % SmallFont.Advance, row))
                    {
                        Dot(left + (i * _dot), top + (row * _dot));
                    }
                }
            }
        }

        private void Dot(int left, int top)
        {
            for (int i = 0; i < _dot * _dot; i++)
            {
                Set(left + (i % _dot), top + (i / _dot), new(Ink, Ink, Ink));
            }
        }

        private void Set(int x, int y, Rgb color)
        {
            int at = 3 * ((y * Picture.Width) + x);
            (Picture.Pixels[at], Picture.Pixels[at + 1], Picture.Pixels[at + 2]) = color;
        }
    }
}
