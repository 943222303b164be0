using System.Globalization;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Two images and the map of what differs between them, side by side, each with a label, and a scale below the map.</summary>
public static class ComparisonSheet
{
    private const int Gap = SheetCanvas.Gap;
    private static readonly double[] s_marks = [0, 0.25, 0.5, 0.75, 1];

    /// <summary>Draws the sheet.</summary>
    /// <param name="image">Linear RGB.</param>
    /// <param name="imageLabel">The label of the image.</param>
    /// <param name="reference">The same of the reference.</param>
    /// <param name="referenceLabel">The label of the reference.</param>
    /// <param name="error">The error of each pixel.</param>
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
        private readonly SheetCanvas _sheet;
        private readonly int _width;
        private readonly int _height;

        public Canvas(IImageRows panel, int panels)
        {
            (_width, _height) = (panel.Width, panel.Height);
            int dot = SheetCanvas.DotFor(_width);
            _sheet = new((panels * (_width + Gap)) + Gap, _height + (3 * SheetCanvas.LineFor(dot)) + (2 * Gap), dot);
        }

        public Picture Picture => _sheet.Picture;

        public void Place(IImageRows image, int panel, string label)
        {
            _sheet.Write(label, Left(panel), Gap, _width);
            _sheet.Place(image, Left(panel), Gap + _sheet.Line);
        }

        public void PlaceMap(FlipError error, int panel)
        {
            Place(error, panel, string.Create(CultureInfo.InvariantCulture, $"FLIP: mean {error.Mean:F4}"));
            int top = Gap + _sheet.Line + _height + (2 * _sheet.Dot);
            for (int y = top; y < top + _sheet.Line - (3 * _sheet.Dot); y++)
            {
                for (int x = 0; x < _width; x++)
                {
                    Rgb shown = HeatMap.Color((x + 0.5) / _width);
                    _sheet.Set(Left(panel) + x, y, new((float)SrgbCurve.Decode(shown.R), (float)SrgbCurve.Decode(shown.G), (float)SrgbCurve.Decode(shown.B)));
                }
            }

            foreach (double mark in s_marks.Where(m => _width >= 150 || m is 0 or 1))
            {
                string text = mark.ToString(CultureInfo.InvariantCulture);
                int wide = _sheet.WidthOf(text);
                _sheet.Write(text, Left(panel) + (int)(mark * (_width - wide)), top + _sheet.Line, wide);
            }
        }

        private int Left(int panel) => Gap + (panel * (_width + Gap));
    }
}
