namespace Lab5;

/// <summary>A lamp that is a ball.</summary>
public sealed record Ball(Vector Center, double Radius, double Radiance)
{
    /// <summary>In proportion to this it is chosen.</summary>
    public double Power => Radiance * Radius * Radius;
}

/// <summary>The scenes of the checks.</summary>
public static class Rooms
{
    public const int Width = 96;
    public const int Height = 72;

    /// <summary>The radiance of the lamp above the mirror.</summary>
    public const double LampRadiance = 2;

    /// <summary>What the mirror shows of it.</summary>
    public const double Mirrored = 0.9 * LampRadiance;

    /// <summary>The x of that lamp, whose height is 1.</summary>
    public const double LampX = 1.5;
    private static readonly Conductor s_mirror = new(new Reflectance(default, default, new Solid(new Rgb(0.9))));

    /// <summary>A closed box of six walls that shine and reflect alike.</summary>
    public static Scene Box(double emission, double albedo) => new(Camera(), Walls(2, i => Wall(albedo), i => emission), [], null, Rgb.Black);

    /// <summary>A ball under an even sky.</summary>
    public static Scene Sky(double radiance, double albedo) => new(Camera(), [new(new Sphere(default, 1), Wall(albedo))], [], new EvenEnvironment(new Rgb(radiance)), Rgb.Black);

    /// <summary>An endless floor below balls that shine, and what leaves its middle of the light of each (Lambert 1760).</summary>
    public static (Scene Scene, double[] Lights) Floor(Ball[] lamps, double albedo)
    {
        IEnumerable<Thing> balls = lamps.Select(l => Shining(new Sphere(l.Center, l.Radius), Wall(0), l.Radiance));
        Scene scene = new(Camera(), balls.Append(new Thing(new Plane(default, new(0, 0, 1), new(1, 0, 0)), Wall(albedo))), [], null, Rgb.Black);
        return (scene, [.. lamps.Select(l => albedo * l.Power / Vector.Dot(l.Center, l.Center) * l.Center.Y / l.Center.Length)]);
    }

    /// <summary>A mirror, in the plane through the origin, below a ball that shines.</summary>
    public static Scene Mirror() =>
        new(Camera(), [Shining(new Sphere(new(LampX, 1, 0), 0.2), Wall(0), LampRadiance), new(new Plane(default, new(0, 0, 1), new(1, 0, 0)), s_mirror)], [], null, Rgb.Black);

    /// <summary>A room with two balls, one of them a mirror, and a lamp at the ceiling.</summary>
    public static Scene Room()
    {
        Rgb[] colours = [new(0.7, 0.2, 0.15), new(0.2, 0.5, 0.25), new(0.7), new(0.7), new(0.7), new(0.7)];
        IEnumerable<Thing> walls = Walls(2, i => new Diffuse(new Solid(colours[i])), _ => 0);
        Rectangle lamp = new(new(-0.7, 0.99, -0.7), new(1.4, 0, 0), new(0, 0, 1.4));
        Thing[] things =
        [
            .. walls, Shining(lamp, Wall(0), 1.6),
            new(new Sphere(new(-0.45, -0.6, -0.3), 0.4), Wall(0.75)),
            new(new Sphere(new(0.45, -0.65, 0.2), 0.35), s_mirror),
        ];
        return new(Camera(), things, [], null, Rgb.Black);
    }

    private static PerspectiveCamera Camera() =>
        new(new(0, 0, 0.98), new(0, 0, -1), new(1, 0, 0), new(0, 1, 0), Width, Height, 1.9 / Width, new Pinhole(), focus: 1);

    private static Diffuse Wall(double albedo) => new(new Solid(new Rgb(albedo)));

    private static Thing Shining(IShape shape, IMaterial material, double radiance) =>
        new(shape, material, radiance > 0 ? new AreaLight(shape, new Luminaire(new Solid(new Rgb(radiance)), 1, exponent: 0)) : null);

    // Left, right, bottom, top, back and front, with normals that look inwards.
    private static IEnumerable<Thing> Walls(double size, Func<int, IMaterial> material, Func<int, double> emission)
    {
        double h = size / 2;
        (Vector Corner, Vector U, Vector V)[] walls =
        [
            (new(-h, -h, -h), new(0, size, 0), new(0, 0, size)), (new(h, -h, -h), new(0, 0, size), new(0, size, 0)),
            (new(-h, -h, -h), new(0, 0, size), new(size, 0, 0)), (new(-h, h, -h), new(size, 0, 0), new(0, 0, size)),
            (new(-h, -h, -h), new(size, 0, 0), new(0, size, 0)), (new(-h, -h, h), new(0, size, 0), new(size, 0, 0)),
        ];
        return walls.Select((w, i) => Shining(new Rectangle(w.Corner, w.U, w.V), material(i), emission(i)));
    }
}
