using RayTracer.Textures;

namespace RayTracer.Textbook;

/// <summary>Light from all around, infinitely far away.</summary>
public interface IEnvironment
{
    /// <summary>The radiance from a direction.</summary>
    Rgb Radiance(Vector direction);

    /// <summary>Chooses a direction, with its density per steradian.</summary>
    (Vector Direction, double Pdf) Choose((double U, double V) random);

    /// <summary>The density with which a direction is chosen.</summary>
    double Pdf(Vector direction);
}

/// <summary>The same light from all directions.</summary>
/// <param name="radiance">The radiance.</param>
public sealed class EvenEnvironment(Rgb radiance) : IEnvironment
{
    /// <inheritdoc/>
    public Rgb Radiance(Vector direction) => radiance;

    /// <inheritdoc/>
    public (Vector Direction, double Pdf) Choose((double U, double V) random) => (Warp.Sphere(random), Pdf(default));

    /// <inheritdoc/>
    public double Pdf(Vector direction) => 1 / (4 * Math.PI);
}

/// <summary>
/// A picture of all directions: u = atan2(x, −z)/2π, v = acos(y)/π. Columns lie at (i + ½)/W, across the seam too, and rows at j/(H − 1), so that the
/// first and last are the poles. Between texels, colours are linear.
/// </summary>
public sealed class ImageEnvironment : IEnvironment
{
    private readonly Picture _picture;
    private readonly double _scale;
    private readonly Transform _turn;
    private readonly Transform _back;
    private readonly int _width;
    private readonly int _height;
    private readonly Distribution _cells;

    /// <summary>Makes one.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="scale">A factor on its colours.</param>
    /// <param name="turn">The rotation from its frame to the world.</param>
    public ImageEnvironment(Picture picture, double scale, Transform turn)
    {
        (_picture, _scale, _turn, _back) = (picture, scale, turn, turn.Inverse());
        (_width, _height) = (picture.Width, Math.Max(picture.Height, 2));
        _cells = new([.. Enumerable.Range(0, _width * (_height - 1)).Select(Weight)]);
    }

    /// <inheritdoc/>
    public Rgb Radiance(Vector direction)
    {
        (double x, double y) = Place(direction);
        (int column, int row) = ((int)Math.Floor(x), (int)Math.Clamp(Math.Floor(y), 0, _height - 2));
        (double s, double t) = (x - column, y - row);
        Rgb upper = (Texel(column, row) * (1 - s)) + (Texel(column + 1, row) * s);
        Rgb lower = (Texel(column, row + 1) * (1 - s)) + (Texel(column + 1, row + 1) * s);
        return (upper * (1 - t)) + (lower * t);
    }

    /// <summary>One of the cells between four texels, by the light that it sends; then uniformly within it, by heights.</summary>
    public (Vector Direction, double Pdf) Choose((double U, double V) random)
    {
        (int cell, double rest) = _cells.Choose(random.U);
        (int column, int row) = (cell % _width, cell / _width);
        double y = Height(row) + (random.V * (Height(row + 1) - Height(row)));
        double r = Math.Sqrt(Math.Max(0, 1 - (y * y)));
        (double sin, double cos) = Math.SinCos(2 * Math.PI * (column + rest + 0.5) / _width);
        return (_turn.Direction(new(r * sin, y, -r * cos)).Unit, _cells.Probability(cell) / SolidAngle(row));
    }

    /// <inheritdoc/>
    public double Pdf(Vector direction)
    {
        (double x, double y) = Place(direction);
        int row = (int)Math.Clamp(Math.Floor(y), 0, _height - 2);
        int column = (int)Math.Floor(x);
        column -= (int)Math.Floor(column / (double)_width) * _width;
        return _cells.Probability((row * _width) + column) / SolidAngle(row);
    }

    // In texels, from the middle of the first.
    private (double X, double Y) Place(Vector direction)
    {
        Vector d = _back.Direction(direction).Unit;
        return ((Math.Atan2(d.X, -d.Z) / (2 * Math.PI) * _width) - 0.5, Math.Acos(Math.Clamp(d.Y, -1, 1)) / Math.PI * (_height - 1));
    }

    private double Height(int row) => Math.Cos(Math.PI * row / (_height - 1));

    private double SolidAngle(int row) => (Height(row) - Height(row + 1)) * 2 * Math.PI / _width;

    private double Weight(int cell)
    {
        (int column, int row) = (cell % _width, cell / _width);
        Rgb sum = Texel(column, row) + Texel(column + 1, row) + Texel(column, row + 1) + Texel(column + 1, row + 1);
        return sum.Luminance * SolidAngle(row);
    }

    private Rgb Texel(int column, int row)
    {
        column -= (int)Math.Floor(column / (double)_width) * _width;
        int i = 3 * ((Math.Min(row, _picture.Height - 1) * _width) + column);
        Rgb texel = new(_picture.Pixels[i], _picture.Pixels[i + 1], _picture.Pixels[i + 2]);
        return new Rgb(Math.Max(texel.R, 0), Math.Max(texel.G, 0), Math.Max(texel.B, 0)) * _scale;
    }
}

/// <summary>What surrounds a scene, as one of its lights.</summary>
/// <param name="around">The light.</param>
/// <param name="bounds">A box around all of the scene that has an end.</param>
public sealed class EnvironmentLight(IEnvironment around, Bounds bounds) : ILight
{
    private readonly double _radius = bounds.Area > 0 || bounds.Size.Largest > 0 ? Math.Max(bounds.Size.Length / 2, 1e-9) : 1;

    /// <inheritdoc/>
    public bool IsPoint => false;

    /// <summary>Of the even light with the mean of some directions, on the ball around the scene.</summary>
    public double Power { get; } = Enumerable.Range(0, 256).Average(i => around.Radiance(Warp.Sphere(((i * 0.618034) % 1, (i + 0.5) / 256))).Luminance)
        * 4 * Math.PI * Math.PI * bounds.Size.Length * bounds.Size.Length / 4;

    /// <summary>The radiance from a direction.</summary>
    public Rgb Radiance(Vector direction) => around.Radiance(direction);

    /// <summary>The density with which <see cref="Sample"/> chooses a direction.</summary>
    public double Pdf(Vector direction) => around.Pdf(direction);

    /// <inheritdoc/>
    public LightSample? Sample(Vector from, (double U, double V) random)
    {
        (Vector direction, double pdf) = around.Choose(random);
        return pdf > 0 ? new LightSample(direction, double.PositiveInfinity, around.Radiance(direction), pdf) : null;
    }

    /// <summary>Through a disk that is as large as the scene, across the direction.</summary>
    public (Ray Ray, Rgb Power)? Emit(ISampler sampler)
    {
        (Vector direction, double pdf) = around.Choose(sampler.Next2());
        (double x, double y) = Warp.Disk(sampler.Next2());
        Vector start = bounds.Middle + (_radius * (direction + new Frame(direction).ToWorld(new(x, y, 0))));
        return pdf > 0 ? (new(start, -direction), around.Radiance(direction) * (Math.PI * _radius * _radius / pdf)) : null;
    }
}
