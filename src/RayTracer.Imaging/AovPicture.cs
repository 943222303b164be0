using System.Globalization;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// An auxiliary image as colours that can be looked at, in a PNG of its own. Where the numbers are spread over the range that there is, <see cref="Range"/>
/// tells it.
/// </summary>
public sealed class AovPicture : IImageRows
{
    private const double BrightShare = 0.99;
    private readonly AovFilm _film;
    private readonly Aov _kind;
    private readonly double[] _values;
    private readonly double _least = double.PositiveInfinity;
    private readonly double _most = double.NegativeInfinity;
    private readonly double _top;

    /// <summary>Looks for the range of the numbers.</summary>
    /// <param name="film">The images.</param>
    /// <param name="kind">Which of them.</param>
    public AovPicture(AovFilm film, Aov kind)
    {
        _film = film;
        _kind = kind;
        _values = new double[film.Width * AovFilm.Channels(kind)];
        float[] all = new float[kind == Aov.BvhCost ? (long)film.Width * film.Height : 0];
        for (int y = 0; y < Height; y++)
        {
            film.ReadRow(kind, y, _values);
            for (int x = 0; x < Width && all.Length > 0; x++)
            {
                all[((long)y * Width) + x] = (float)_values[x];
            }

            foreach (double value in _values.Where(double.IsFinite))
            {
                (_least, _most) = (Math.Min(_least, value), Math.Max(_most, value));
            }
        }

        // A few rays that graze a surface cost many times what others do, and would leave nothing but black to these.
        Array.Sort(all);
        _top = all.Length > 0 ? all[(long)(BrightShare * (all.Length - 1))] : 0;
        _top = _top > 0 ? _top : _most;
    }

    /// <inheritdoc/>
    public int Width => _film.Width;

    /// <inheritdoc/>
    public int Height => _film.Height;

    /// <summary>What the colours mean, for the reader of the picture.</summary>
    public string Range => _kind switch
    {
        Aov.Depth => double.IsFinite(_least) ? $"{Text(_least)} (white) to {Text(_most)} (black) scene units, evenly in 1/distance; black too where nothing is hit" : "nothing is hit: black",
        Aov.Normal => "x, y and z from -1 to 1 are red, green and blue from 0 to 1",
        Aov.Albedo => "red, green and blue from 0 to 1",
        Aov.Uv => "the fractions of u and v from 0 to 1 are red and green from 0 to 1",
        Aov.Primitive => "a colour for each shape or triangle; black where nothing is hit",
        Aov.BvhCost => $"0 to {Text(_top)} and more nodes and triangles per ray: {HeatMap.Legend}; at most {Text(_most)}",
        _ => $"0 (black) to {Text(_most)} (white) samples",
    };

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        int channels = AovFilm.Channels(_kind);
        _film.ReadRow(_kind, y, _values);
        for (int x = 0; x < Width; x++)
        {
            (rgb[3 * x], rgb[(3 * x) + 1], rgb[(3 * x) + 2]) = Color(_values.AsSpan(x * channels, channels));
        }
    }

    private Rgb Color(ReadOnlySpan<double> value) => _kind switch
    {
        Aov.Depth => Grey(Nearness(value[0])),
        Aov.Normal => Linear((0.5 * value[0]) + 0.5, (0.5 * value[1]) + 0.5, (0.5 * value[2]) + 0.5),
        Aov.Albedo => new((float)value[0], (float)value[1], (float)value[2]),
        Aov.Uv => Linear(value[0] - Math.Floor(value[0]), value[1] - Math.Floor(value[1]), 0),
        Aov.Primitive => value[0] > 0 ? OfNumber((uint)value[0]) : Rgb.Black,
        Aov.BvhCost => HeatMap.Color(value[0] / Math.Max(_top, double.Epsilon)) is var c ? Linear(c.R, c.G, c.B) : default,
        _ => Grey(value[0] / Math.Max(_most, double.Epsilon)),
    };

    // Evenly in the inverse, so that a horizon leaves some grey to what stands before it.
    private double Nearness(double distance) =>
        double.IsInfinity(distance) ? 0 : _most > _least ? ((1 / distance) - (1 / _most)) / ((1 / _least) - (1 / _most)) : 1;

    private static Rgb Grey(double display) => Linear(display, display, display);

    // From display values, so that what is written to the file is the number itself.
    private static Rgb Linear(double r, double g, double b) => new(Decode(r), Decode(g), Decode(b));

    private static float Decode(double display) => (float)SrgbCurve.Decode(Math.Clamp(display, 0, 1));

    // Never too dark to be told from nothing.
    private static Rgb OfNumber(uint number)
    {
        uint bits = Hash.Mix(number);
        static double Channel(uint eight) => (30 + (225 * (eight & 0xff) / 255.0)) / 255;
        return Linear(Channel(bits), Channel(bits >> 8), Channel(bits >> 16));
    }

    private static string Text(double value) => value.ToString("G6", CultureInfo.InvariantCulture);
}
