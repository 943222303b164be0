using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// The features of an image that FLIP compares: colours as blurred as the eye sees them, and how strong edges and points are.
/// </summary>
internal sealed class FlipImage
{
    private readonly int _width;
    private readonly int _height;
    private readonly float[] _luminance;
    private readonly float[] _redGreen;
    private readonly float[] _blueYellow;

    public FlipImage(IImageRows image, FlipFilters filters)
    {
        (_width, _height) = (image.Width, image.Height);
        float[][] opponent = [new float[_width * _height], new float[_width * _height], new float[_width * _height]];
        float[] row = new float[3 * _width];
        for (int y = 0; y < _height; y++)
        {
            image.ReadRow(y, row);
            for (int x = 0; x < _width; x++)
            {
                FlipColor c = FlipColor.Opponent(new(Shown(row[3 * x]), Shown(row[(3 * x) + 1]), Shown(row[(3 * x) + 2])));
                int i = (y * _width) + x;
                (opponent[0][i], opponent[1][i], opponent[2][i]) = ((float)c.X, (float)c.Y, (float)c.Z);
            }
        }

        _luminance = Filter(opponent[0], filters.Luminance, filters.Luminance);
        _redGreen = Filter(opponent[1], filters.RedGreen, filters.RedGreen);
        float[] wide = Filter(opponent[2], filters.BlueYellow[0], filters.BlueYellow[0]);
        float[] narrow = Filter(opponent[2], filters.BlueYellow[1], filters.BlueYellow[1]);
        _blueYellow = [.. wide.Select((w, i) => (float)((filters.BlueYellowShare * w) + ((1 - filters.BlueYellowShare) * narrow[i])))];

        float[] grey = [.. opponent[0].Select(y => (y + 16) / 116)];
        Edges = Length(Filter(grey, filters.Edge, filters.Blur), Filter(grey, filters.Blur, filters.Edge));
        Points = Length(Filter(grey, filters.Point, filters.Blur), Filter(grey, filters.Blur, filters.Point));
    }

    /// <summary>The strength of the edge through each pixel.</summary>
    public float[] Edges { get; }

    /// <summary>The degree to which each pixel is a point.</summary>
    public float[] Points { get; }

    /// <summary>The blurred colour of a pixel, as <see cref="FlipColor.Uniform"/> has it.</summary>
    public FlipColor Color(int i) => FlipColor.Uniform(FlipColor.Linear(new(_luminance[i], _redGreen[i], _blueYellow[i])));

    private static float Shown(float value) => value > 0 ? Math.Min(value, 1) : 0;

    private static float[] Length(float[] x, float[] y) => [.. x.Select((v, i) => float.Sqrt((v * v) + (y[i] * y[i])))];

    // Along rows and then along columns; beyond the edges, the outermost pixels go on.
    private float[] Filter(float[] plane, float[] along, float[] down)
    {
        float[] rows = new float[plane.Length];
        Parallel.For(0, _height, y =>
        {
            int radius = along.Length / 2;
            for (int x = 0; x < _width; x++)
            {
                float sum = 0;
                for (int k = 0; k < along.Length; k++)
                {
                    sum += along[k] * plane[(y * _width) + Math.Clamp(x + k - radius, 0, _width - 1)];
                }

                rows[(y * _width) + x] = sum;
            }
        });
        float[] filtered = new float[plane.Length];
        Parallel.For(0, _height, y =>
        {
            int radius = down.Length / 2;
            Span<float> to = filtered.AsSpan(y * _width, _width);
            for (int k = 0; k < down.Length; k++)
            {
                ReadOnlySpan<float> from = rows.AsSpan(Math.Clamp(y + k - radius, 0, _height - 1) * _width, _width);
                for (int x = 0; x < to.Length; x++)
                {
                    to[x] += down[k] * from[x];
                }
            }
        });
        return filtered;
    }
}
