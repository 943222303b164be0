using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>Describes an <see cref="ImageEnvironment"/>.</summary>
[SceneType("image", "Light from a picture of all directions. By latitude and longitude, its middle column is towards +z and its left half "
    + "towards +x, its top row is straight up and its bottom row straight down. In an octahedral one, the middle is straight up and the corners straight down, its right half is "
    + "towards +x and its upper half towards +z.")]
public sealed record ImageEnvironmentDescription : EnvironmentDescription
{
    /// <summary>The picture's file.</summary>
    [Parameter("The picture's file: Radiance HDR, OpenEXR, PFM, PNG or JPEG.", IsFile = true, Required = true)]
    public string File { get; init; } = "";

    /// <summary>Factor on the picture.</summary>
    [Parameter("Factor on the picture's colours, which are radiances.", Minimum = 0)]
    public float Scale { get; init; } = 1;

    /// <summary>The file's numbers are taken as they are.</summary>
    [Parameter("Whether the file's numbers are linear and used as they are, instead of being decoded from sRGB. Floating-point files are "
        + "always linear.")]
    public bool Raw { get; init; }

    /// <summary>How the picture shows directions.</summary>
    [Parameter("How the picture shows directions: by latitude and longitude, or as an octahedron unfolded into a square, each of whose pixels is an equally large part of the "
        + "sphere (Clarberg 2008; pbrt-v4's pictures).")]
    public DirectionMapping Mapping { get; init; }

    /// <summary>The picture as a program gives it (linear), instead of the file; null where there is none.</summary>
    public Picture? Picture { get; init; }

    /// <inheritdoc/>
    public override EnvironmentLight? Build(SceneBuilder builder)
    {
        Transform turn = Turn(builder);
        Picture picture = Picture ?? builder.Picture(this, nameof(File), File, Raw);
        if (Mapping == DirectionMapping.Octahedral)
        {
            if (picture.Width != picture.Height)
            {
                builder.Error(this, nameof(Mapping), $"an octahedral picture is square, but this one has {picture.Width}×{picture.Height} pixels");
                return null;
            }

            picture = DirectionMap.Unfolded(picture);
        }

        (int negative, int endless) = (0, 0);
        foreach (float value in picture.Pixels)
        {
            negative += value < 0 ? 1 : 0;
            endless += float.Abs(value) * Scale <= ImageEnvironment.Brightest ? 0 : 1;
        }

        if (endless > 0)
        {
            builder.Error(this, nameof(File), $"{endless} of the picture's numbers are not finite, or too large to compute with");
            return null;
        }

        if (negative > 0)
        {
            builder.Warn(this, nameof(File), $"{negative} of the picture's numbers are below zero and are taken as 0: there is no negative light");
        }

        return new ImageEnvironment(picture, Scale, turn);
    }
}

/// <summary>
/// Light from a picture of all directions. In the frame of the picture, u = atan2(x, −z)/2π and v = acos(y)/π; colours are linear between
/// texels, of which column i of W lies at u = (i + ½)/W, across the seam too, and row j of H at v = j/(H − 1): the first and last rows are
/// the poles. (So it is in Mitsuba 3.)
/// <para>
/// Directions are chosen by luminance: first one of the cells between four texels, by the luminance that it sends, and then a direction of it,
/// with a density in proportion to luminance as if that were linear in the cosine with the axis, too.
/// </para>
/// </summary>
internal sealed unsafe class ImageEnvironment : EnvironmentLight
{
    /// <summary>The largest radiance that can be computed with.</summary>
    public const float Brightest = 1e30f;

    private readonly PinnedBuffer<float> _texels;
    private readonly GridDistribution _cells;
    private readonly int _width;
    private readonly int _height;

    // Of each row: sin² and cos² of half the angle to the axis, which are exact at either pole; and the solid angle of a cell below it.
    private readonly PinnedBuffer<float> _sines;
    private readonly PinnedBuffer<float> _cosines;
    private readonly PinnedBuffer<float> _solidAngles;

    // What luminance is multiplied by, so that squares of it stay within range.
    private readonly float _unit;
    private readonly Vector3 _x;
    private readonly Vector3 _y;
    private readonly Vector3 _z;

    /// <summary>Copies the picture's texels.</summary>
    /// <param name="picture">The picture. A picture of one row is the same from pole to pole.</param>
    /// <param name="scale">Factor on its colours; none may then be above <see cref="Brightest"/>.</param>
    /// <param name="turn">Its rotation: a map that keeps angles.</param>
    public ImageEnvironment(Picture picture, float scale, in Transform turn)
    {
        (_width, _height) = (picture.Width, Math.Max(picture.Height, 2));
        (_x, _y, _z) = (turn.Vector(Vector3.UnitX).Unit(), turn.Vector(Vector3.UnitY).Unit(), turn.Vector(Vector3.UnitZ).Unit());
        _texels = new(3L * _width * _height);
        float largest = 0;
        for (long i = 0; i < 3L * _width * _height; i++)
        {
            float value = float.Max(picture.Pixels[i % picture.Pixels.LongLength], 0) * scale;
            _texels.Pointer[i] = value;
            largest = float.Max(largest, value);
        }

        _unit = largest > 0 ? 1 / largest : 0;
        _sines = new(_height);
        _cosines = new(_height);
        _solidAngles = new(_height);
        for (int row = 0; row < _height; row++)
        {
            LaneMath.SinCosTurn(row / (4f * (_height - 1)), out float sin, out float cos);
            (_sines.Pointer[row], _cosines.Pointer[row]) = (sin * sin, cos * cos);
        }

        for (int row = 0; row < _height - 1; row++)
        {
            bool isUpper = row < _height / 2;
            float difference = isUpper ? _sines.Pointer[row + 1] - _sines.Pointer[row] : _cosines.Pointer[row] - _cosines.Pointer[row + 1];
            _solidAngles.Pointer[row] = difference * (4 * float.Pi) / _width;
        }

        _cells = new(_width, _height - 1, Weigh);
    }

    /// <summary>The luminance of all directions together: its integral over the sphere, about.</summary>
    public double Power => _unit > 0 ? _cells.Sum / (4 * _unit) : 0;

    /// <inheritdoc/>
    public override void Evaluate(in Vec3W direction, out RgbW radiance)
    {
        Find(direction, out Place place);
        Texels(place.Column, place.Row, out Corners corners);
        radiance = corners.At(place.S, place.F);
    }

    /// <inheritdoc/>
    public override void Pdf(in Vec3W direction, out FloatW pdf)
    {
        Find(direction, out Place place);
        Texels(place.Column, place.Row, out Corners corners);
        corners.Luminances(_unit, out Luminances cell);
        _cells.Probability(place.Column, place.Row, out FloatW probability);

        // Where in the cell, in proportion to the solid angle.
        MaskW isUpper = place.Row < (uint)(_height / 2);
        FloatW.Gather(_sines.Pointer, place.Row, out FloatW sineFrom, out FloatW sineTo);
        FloatW.Gather(_cosines.Pointer, place.Row, out FloatW cosineFrom, out FloatW cosineTo);
        (FloatW from, FloatW to) = (isUpper.Select(sineFrom, cosineFrom), isUpper.Select(sineTo, cosineTo));
        FloatW t = FloatW.Max(FloatW.Min((isUpper.Select(place.Sine, place.Cosine) - from) / (to - from), 1f), 0f);
        FloatW there = cell.At(place.S, t);
        FloatW density = probability * there / (cell.Mean * FloatW.Gather(_solidAngles.Pointer, place.Row));
        pdf = (there > 0f).Select(density, 0f);
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(Bounds.Infinite, (float)(Power / 4));

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        _cells.Choose(u, v, out UIntW column, out UIntW row, out FloatW restU, out FloatW restV, out FloatW probability);
        Texels(column, row, out Corners corners);
        corners.Luminances(_unit, out Luminances cell);
        FloatW t = ByLine(cell.UpperLeft + cell.UpperRight, cell.LowerLeft + cell.LowerRight, restV);
        FloatW s = ByLine(FloatW.Mix(cell.UpperLeft, cell.LowerLeft, t), FloatW.Mix(cell.UpperRight, cell.LowerRight, t), restU);

        FloatW.Gather(_sines.Pointer, row, out FloatW sineFrom, out FloatW sineTo);
        FloatW.Gather(_cosines.Pointer, row, out FloatW cosineFrom, out FloatW cosineTo);
        (FloatW sine, FloatW cosine) = (FloatW.Mix(sineFrom, sineTo, t), FloatW.Mix(cosineFrom, cosineTo, t));
        FloatW y = cosine - sine;
        FloatW r = FloatW.Sqrt(sine * cosine) * 2f;
        LaneMath.SinCosTurn((column.ToFloat() + s + 0.5f) * (1f / _width), out FloatW sin, out FloatW cos);
        Vec3W direction = Vec3W.MultiplyAdd(_x, r * sin, Vec3W.MultiplyAdd(_y, y, (Vec3W)_z * -(r * cos)));

        FloatW there = cell.At(s, t);
        FloatW inversePdf = cell.Mean * FloatW.Gather(_solidAngles.Pointer, row) / (probability * there);
        inversePdf = (there > 0f).Select(inversePdf, 0f);
        Of(direction, inversePdf, out sample);
        FloatW f = LaneMath.Atan2(r, y) * ((_height - 1) / float.Pi) - row.ToFloat();
        radiance = corners.At(s, FloatW.Max(FloatW.Min(f, 1f), 0f)) * inversePdf;
    }

    // The point at which a line from p to q, as a density over [0, 1], has so much below it.
    private static FloatW ByLine(FloatW p, FloatW q, FloatW share)
    {
        FloatW root = FloatW.Sqrt(FloatW.MultiplyAdd(q * q - p * p, share, p * p));
        FloatW below = p + root;
        return (below > 0f).Select(FloatW.Min(share * (p + q) / below, 1f), share);
    }

    private void Weigh(int row, double[] weights)
    {
        float* upper = _texels.Pointer + (3L * _width * row);
        float* lower = upper + (3L * _width);
        for (int i = 0; i < _width; i++)
        {
            int next = i + 1 < _width ? i + 1 : 0;
            double sum = Luminance(upper + (3 * i)) + Luminance(upper + (3 * next)) + Luminance(lower + (3 * i)) + Luminance(lower + (3 * next));
            weights[i] = sum * _solidAngles.Pointer[row];
        }
    }

    private double Luminance(float* texel) => new Rgb(texel[0] * _unit, texel[1] * _unit, texel[2] * _unit).Luminance;

    private void Find(in Vec3W direction, out Place place)
    {
        FloatW x = Vec3W.Dot(direction, _x);
        FloatW y = Vec3W.Dot(direction, _y);
        FloatW z = Vec3W.Dot(direction, _z);
        FloatW column = FloatW.MultiplyAdd(LaneMath.Atan2(x, -z), _width / (2 * float.Pi), -0.5f);
        column = (column < 0f).Select(column + _width, column);
        FloatW left = FloatW.Max(0f, FloatW.Min(FloatW.Floor(column), _width - 1f));
        place.Column = left.ToIntInRange();
        place.S = FloatW.Max(0f, FloatW.Min(column - left, 1f));

        FloatW square = FloatW.MultiplyAdd(x, x, z * z);
        FloatW row = LaneMath.Atan2(FloatW.Sqrt(square), y) * ((_height - 1) / float.Pi);
        FloatW above = FloatW.Max(0f, FloatW.Min(FloatW.Floor(row), _height - 2f));
        place.Row = above.ToIntInRange();
        place.F = FloatW.Max(0f, FloatW.Min(row - above, 1f));

        // (1 − y)/2 and (1 + y)/2 without cancellation.
        FloatW larger = FloatW.MultiplyAdd(FloatW.Abs(y), 0.5f, 0.5f);
        FloatW smaller = square * 0.25f / larger;
        place.Sine = (y > 0f).Select(smaller, larger);
        place.Cosine = (y > 0f).Select(larger, smaller);
    }

    private void Texels(UIntW column, UIntW row, out Corners corners)
    {
        UIntW next = column + 1u;
        next = (next < (uint)_width).Select(next, 0u);
        UIntW upper = row * (uint)_width;
        UIntW lower = upper + (uint)_width;
        corners.UpperLeft = Texel(upper + column);
        corners.UpperRight = Texel(upper + next);
        corners.LowerLeft = Texel(lower + column);
        corners.LowerRight = Texel(lower + next);
    }

    private RgbW Texel(UIntW index) => RgbW.Gather(_texels.Pointer, index * 3u);

    // Where a direction lies in the picture: its cell, where in it by angles, and sin² and cos² of half the angle to the axis.
    private struct Place
    {
        public UIntW Column, Row;
        public FloatW S, F, Sine, Cosine;
    }

    private struct Corners
    {
        public RgbW UpperLeft, UpperRight, LowerLeft, LowerRight;

        public readonly RgbW At(FloatW s, FloatW t)
        {
            RgbW upper = RgbW.MultiplyAdd(UpperRight, s, UpperLeft * (1f - s));
            RgbW lower = RgbW.MultiplyAdd(LowerRight, s, LowerLeft * (1f - s));
            return RgbW.MultiplyAdd(lower, t, upper * (1f - t));
        }

        public readonly void Luminances(float unit, out Luminances luminances)
        {
            luminances.UpperLeft = UpperLeft.Luminance * unit;
            luminances.UpperRight = UpperRight.Luminance * unit;
            luminances.LowerLeft = LowerLeft.Luminance * unit;
            luminances.LowerRight = LowerRight.Luminance * unit;
        }
    }

    private struct Luminances
    {
        public FloatW UpperLeft, UpperRight, LowerLeft, LowerRight;

        public readonly FloatW Mean => (UpperLeft + UpperRight + LowerLeft + LowerRight) * 0.25f;

        public readonly FloatW At(FloatW s, FloatW t) => FloatW.Mix(FloatW.Mix(UpperLeft, LowerLeft, t), FloatW.Mix(UpperRight, LowerRight, t), s);
    }
}
