namespace Lab7;

/// <summary>The scenes of the checks.</summary>
public static class Scenes
{
    public const int Width = 160;
    public const int Height = 120;

    /// <summary>The share of light that the mirror reflects.</summary>
    public const double Mirrored = 0.8;

    /// <summary>The refractive index of the water.</summary>
    public const double Water = 1.33;
    private static readonly Diffuse s_black = new(new Solid(Rgb.Black));

    /// <summary>Some equal balls that shine.</summary>
    public static Scene Lamps(int count, double radius, double radiance) =>
        new(Camera(), Enumerable.Range(0, count).Select(i => Shining(new Sphere(new(5 * i, 0, 0), radius), radiance)), [], null, Rgb.Black);

    /// <summary>A floor.</summary>
    public static Scene Floor(double albedo = 0.5) => new(Camera(), [Ground(albedo)], [], null, Rgb.Black);

    /// <summary>A floor below a mirror that looks down, at the height of 2.</summary>
    public static Scene Mirror()
    {
        Conductor mirror = new(new Reflectance(default, default, new Solid(new Rgb(Mirrored))));
        return new(Camera(), [Ground(0.5), new(new Plane(new(0, 2, 0), new(1, 0, 0), new(0, 0, 1)), mirror)], [], null, Rgb.Black);
    }

    /// <summary>Water of the depth 1 above a floor.</summary>
    public static Scene Pool() =>
        new(Camera(), [Ground(0.5), new(new Plane(new(0, 1, 0), new(0, 0, 1), new(1, 0, 0)), Clear(Water))], [], null, Rgb.Black);

    /// <summary>A ball of glass between a small lamp and a floor, as in the report's second scene.</summary>
    public static Scene GlassBall() => new(
        Camera(), [Ground(0.6), new(new Sphere(new(0, 0.75, 0), 0.6), Clear(1.5)), Shining(new Sphere(new(-1.6, 3.2, 0.6), 0.15), 250)], [], null, Rgb.Black);

    private static Dielectric Clear(double index) => new(index, Rgb.Black, isSchlick: false, new Solid(Rgb.White), new Solid(Rgb.White));

    private static Thing Ground(double albedo) => new(new Plane(default, new(0, 0, 1), new(1, 0, 0)), new Diffuse(new Solid(new Rgb(albedo))));

    private static Thing Shining(Sphere shape, double radiance) => new(shape, s_black, new AreaLight(shape, new Luminaire(new Solid(new Rgb(radiance)), 1, exponent: 0)));

    private static PerspectiveCamera Camera()
    {
        Vector forward = new Vector(0, -0.5, -1).Unit;
        Vector right = new(1, 0, 0);
        return new(new(0.3, 2.1, 3.6), forward, right, Vector.Cross(right, forward), Width, Height, 0.9 / Width, new Pinhole(), focus: 1);
    }
}
