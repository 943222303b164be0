using RayTracer.Labs;

namespace Lab4;

/// <summary>A floor below a shining rectangle.</summary>
public sealed record Hall
{
    private const int Width = 120;
    private const int Height = 90;

    /// <summary>Makes one.</summary>
    public Hall(ISampler random)
    {
        Place = new(new(random.Next(), 0, random.Next()), new(0, 1, 0), 0.8);
        Panel = new(new(-0.7, 1 + (0.5 * random.Next()), -0.5), new(1.6, 0, 0), new(0, 0, 1.2), 5);
    }

    /// <summary>A place on the floor.</summary>
    public Place Place { get; }

    /// <summary>The rectangle.</summary>
    public Panel Panel { get; init; }

    /// <summary>What it is, in words.</summary>
    public string Text => $"a place at {Answer.Text((Answer)Place.Point)} with normal (0, 1, 0) and albedo 0.8; a rectangle of radiance 5 with the corner {Answer.Text((Answer)Panel.Corner)} and the edges (1.6, 0, 0) and (0, 0, 1.2)";

    /// <summary>What leaves the place: the irradiance of a polygon is a sum over its edges (Lambert 1760).</summary>
    public double Radiance
    {
        get
        {
            Vector[] corners = [.. new[] { default, Panel.EdgeU, Panel.EdgeU + Panel.EdgeV, Panel.EdgeV }.Select(e => (Panel.Corner + e - Place.Point).Unit)];
            double sum = Enumerable.Range(0, 4).Sum(i => (A: corners[i], B: corners[(i + 1) % 4]) is var e
                ? Math.Acos(Vector.Dot(e.A, e.B)) * Vector.Dot(Vector.Cross(e.A, e.B).Unit, Place.Normal) : 0);
            return Place.Albedo / Math.PI * Panel.Radiance * Math.Abs(sum) / 2;
        }
    }

    /// <summary>The floor from above: with one random point for each pixel, and with 16 in strata.</summary>
    public static Exhibit Picture(Panel panel, ISampler random)
    {
        Place At(int i) => new(new(((i % Width) - 60) / 30.0, 0, ((i / Width) - 45) / 30.0), new(0, 1, 0), 0.8);
        Rgb[] Floor(Func<Place, double> light) => [.. Enumerable.Range(0, Width * Height).Select(i => new Rgb(0.8 * light(At(i))))];
        return Pictures.Of(
            "the floor below a rectangle: one random point, and 16 in strata", Width, Height,
            Floor(p => Lights.FromRectangle(p, panel, random.Next2())), Floor(p => Lights.FromStrata(p, panel, 4, random)));
    }
}

/// <summary>The light of a ball in a shiny surface, otherwise.</summary>
public static class Reference
{
    /// <summary>By summing over the cone in which the ball is seen.</summary>
    /// <param name="place">The place.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="lobe">The shiny surface.</param>
    /// <param name="factor">A factor on the light of each direction; null for none.</param>
    public static double Light(Place place, Ball ball, Lobe lobe, Func<Vector, double>? factor = null)
    {
        const int Steps = 400;
        (double height, Frame frame) = Cone(place, ball);
        double sum = 0;
        for (int i = 0; i < Steps; i++)
        {
            for (int j = 0; j < Steps; j++)
            {
                Vector direction = InCone(frame, height, ((i + 0.5) / Steps, (j + 0.5) / Steps));
                sum += lobe.Value(direction) * (factor?.Invoke(direction) ?? 1);
            }
        }

        return ball.Radiance * sum / (Steps * Steps) * 2 * Math.PI * height;
    }

    /// <summary>An estimate by both ways.</summary>
    public static double Both(Place place, Ball ball, Lobe lobe, ISampler random)
    {
        (double height, Frame frame) = Cone(place, ball);
        double pdf = 1 / (2 * Math.PI * height);
        Vector one = InCone(frame, height, random.Next2());
        Vector other = lobe.Choose(random.Next2());
        double found = lobe.Value(one) / pdf * LightSampling.Share(pdf, lobe.Pdf(one));
        return ball.Radiance * (found + (ball.IsMetBy(place.Point, other) ? lobe.Value(other) / lobe.Pdf(other) * LightSampling.Share(lobe.Pdf(other), pdf) : 0));
    }

    private static (double Height, Frame Frame) Cone(Place place, Ball ball)
    {
        Vector to = ball.Center - place.Point;
        return (1 - Math.Sqrt(1 - (ball.Radius * ball.Radius / Vector.Dot(to, to))), new(to.Unit));
    }

    private static Vector InCone(Frame frame, double height, (double U, double V) random) => frame.ToWorld(Warp.Cone(random, height));
}
