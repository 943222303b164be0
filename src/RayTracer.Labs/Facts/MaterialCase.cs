using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>A place on a surface, and where it is seen from.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Cosine">Cosine of the angle between the normal and the viewer.</param>
/// <param name="Hit">The place.</param>
/// <param name="From">Where the viewer is, in the surface's frame.</param>
internal sealed record MaterialCase(int Number, double Cosine, Hit Hit, Vector From)
{
    // Not along an axis, so that x and y cannot be taken for each other.
    private const double Azimuth = 0.7;

    /// <summary>Those that are checked, the simplest first.</summary>
    public static IReadOnlyList<MaterialCase> All { get; } =
        [.. new[] { (1.0, false), (0.8, false), (0.5, false), (0.15, false), (0.9, true) }.Select((c, i) => Of(i, c.Item1, c.Item2))];

    /// <summary>The same place, seen from outside or from inside.</summary>
    public static Hit HitAt(bool isInside, Hit like)
    {
        Hit hit = like;
        hit.Face(new Vector(0, 0, isInside ? 1 : -1));
        return hit;
    }

    /// <summary>In words.</summary>
    public override string ToString() => $"{Fact.Text(Math.Acos(Cosine) * 180 / Math.PI)}° from the normal{(Hit.Inside ? ", from inside" : "")}";

    private static MaterialCase Of(int number, double cosine, bool isInside)
    {
        Vector up = new(0, 0, 1);
        Hit place = new() { Distance = 1, Normal = up, Shading = up, U = 0.3, V = 0.7 };
        double sine = Math.Sqrt(1 - (cosine * cosine));
        return new(number, cosine, HitAt(isInside, place), new(sine * Math.Cos(Azimuth), sine * Math.Sin(Azimuth), cosine));
    }
}
