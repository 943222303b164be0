namespace Lab4;

/// <summary>A place on a surface.</summary>
/// <param name="Point">Where it is.</param>
/// <param name="Normal">The unit normal.</param>
/// <param name="Albedo">The share of light that it reflects, in all directions alike.</param>
public sealed record Place(Vector Point, Vector Normal, double Albedo);

/// <summary>A lamp that is a rectangle, and shines on the side of its normal.</summary>
/// <param name="Corner">A corner.</param>
/// <param name="EdgeU">An edge from there.</param>
/// <param name="EdgeV">The other edge from there, perpendicular to it.</param>
/// <param name="Radiance">The radiance, the same in all directions.</param>
public sealed record Panel(Vector Corner, Vector EdgeU, Vector EdgeV, double Radiance)
{
    /// <summary>The unit normal.</summary>
    public Vector Normal => Vector.Cross(EdgeU, EdgeV).Unit;

    /// <summary>The area.</summary>
    public double Area => Vector.Cross(EdgeU, EdgeV).Length;
}

/// <summary>A lamp that is a ball.</summary>
/// <param name="Center">The centre.</param>
/// <param name="Radius">The radius.</param>
/// <param name="Radiance">The radiance, the same in all directions.</param>
public sealed record Ball(Vector Center, double Radius, double Radiance)
{
    /// <summary>True where a ray meets it.</summary>
    /// <param name="origin">Where the ray starts, outside of it.</param>
    /// <param name="direction">Where it goes.</param>
    public bool IsMetBy(Vector origin, Vector direction)
    {
        Vector to = Center - origin;
        double along = Vector.Dot(to, direction.Unit);
        return along > 0 && Vector.Dot(to, to) - (along * along) < Radius * Radius;
    }
}

/// <summary>A shiny surface, brightest around a direction: cosⁿ of the angle to it.</summary>
/// <param name="axis">The direction: a unit vector.</param>
/// <param name="normal">The normal of the surface.</param>
/// <param name="exponent">n: the larger, the shinier.</param>
public sealed class Lobe(Vector axis, Vector normal, double exponent)
{
    /// <summary>BSDF · cosine of light from a direction.</summary>
    public double Value(Vector direction) => Vector.Dot(direction, normal) > 0 ? Warp.CosinePowerPdf(Vector.Dot(direction, axis), exponent) : 0;

    /// <summary>The density with which <see cref="Choose"/> chooses a direction, per steradian.</summary>
    public double Pdf(Vector direction) => Warp.CosinePowerPdf(Vector.Dot(direction, axis), exponent);

    /// <summary>A random direction.</summary>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    public Vector Choose((double U, double V) random) => new Frame(axis).ToWorld(Warp.CosinePower(random, exponent));
}
