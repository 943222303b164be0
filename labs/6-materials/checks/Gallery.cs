using RayTracer.Labs;

namespace Lab6;

/// <summary>Three balls of the student's materials under an even sky and a lamp, by the textbook's path tracer.</summary>
public static class Gallery
{
    private const int Width = 180;
    private const int Height = 80;
    private const int Side = 4;

    /// <summary>Renders the picture.</summary>
    public static Exhibit Picture()
    {
        Vector forward = new Vector(0, -0.16, -1).Unit;
        Vector right = new(1, 0, 0);
        PerspectiveCamera camera = new(new(0, 1.5, 5.4), forward, right, Vector.Cross(right, forward), Width, Height, 1.2 / Width, new Pinhole(), focus: 1);
        Checker floor = new(new Solid(new Rgb(0.75)), new Solid(new Rgb(0.25)), (1, 1), (0, 0));
        Sphere lamp = new(new(-2.5, 4, 3), 0.7);
        Luminaire shine = new(new Solid(new Rgb(1, 0.9, 0.75)), 14, exponent: 0);
        Thing[] things =
        [
            new(new Plane(default, new(0, 0, 1), new(1, 0, 0)), new Diffuse(floor)),
            new(new Sphere(new(-2.1, 0.9, 0), 0.9), new OrenNayar(new Rgb(0.8, 0.35, 0.25), 0.6)),
            new(new Sphere(new(0, 0.9, 0), 0.9), new Glass(1.5)),
            new(new Sphere(new(2.1, 0.9, 0), 0.9), new RoughMetal(0.25)),
            new(lamp, new Diffuse(new Solid(Rgb.Black)), new AreaLight(lamp, shine)),
        ];
        Scene scene = new(camera, things, [], new EvenEnvironment(new Rgb(0.35, 0.45, 0.6)), Rgb.Black);
        Renderer renderer = new(scene, new PathIntegrator(maxDepth: 8, rouletteDepth: 4), Width, Height, stream => new StratifiedSampler(Side, stream));
        Rgb[] sum = new Rgb[Width * Height];
        for (int sample = 0; sample < Side * Side; sample++)
        {
            Rgb[] pass = renderer.Pass(sample);
            for (int i = 0; i < sum.Length; i++)
            {
                sum[i] += pass[i] * (1.0 / (Side * Side));
            }
        }

        return Pictures.Of("your materials: Oren and Nayar, glass, rough metal", Width, Height, sum);
    }
}
