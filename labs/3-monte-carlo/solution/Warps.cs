namespace Lab3;

/// <summary>Maps from the unit square, whose points (u, v) are uniform, and the densities of what they make. Directions are around (0, 0, 1).</summary>
public static class Warps
{
    /// <summary>Points of the disk of radius 1, uniformly.</summary>
    public static (double X, double Y) Disk((double U, double V) random)
    {
        //? Warps.Disk: the share of the points within a radius r must be the share of the area there.
        double radius = Math.Sqrt(random.U);
        double angle = 2 * Math.PI * random.V;
        return (radius * Math.Cos(angle), radius * Math.Sin(angle));
        //!
    }

    /// <summary>The density of <see cref="Disk"/>, by area.</summary>
    public static double DiskPdf(double x, double y)
    {
        //? Warps.DiskPdf: the same everywhere on the disk, and 0 outside.
        return (x * x) + (y * y) <= 1 ? 1 / Math.PI : 0;
        //!
    }

    /// <summary>Points of the triangle of all (b, c) with b ≥ 0, c ≥ 0 and b + c ≤ 1, uniformly.</summary>
    public static (double B, double C) Triangle((double U, double V) random)
    {
        //? Warps.Triangle: either fold the square along its diagonal, or take a square root as for the disk.
        double root = Math.Sqrt(random.U);
        return (1 - root, random.V * root);
        //!
    }

    /// <summary>The density of <see cref="Triangle"/>, by area.</summary>
    public static double TrianglePdf(double b, double c)
    {
        //? Warps.TrianglePdf: one over the area.
        return b >= 0 && c >= 0 && b + c <= 1 ? 2 : 0;
        //!
    }

    /// <summary>Directions above the surface, uniformly.</summary>
    public static Vector Hemisphere((double U, double V) random)
    {
        //? Warps.Hemisphere: heights on a sphere are uniform (Archimedes).
        double z = random.U;
        double radius = Math.Sqrt(1 - (z * z));
        double angle = 2 * Math.PI * random.V;
        return new(radius * Math.Cos(angle), radius * Math.Sin(angle), z);
        //!
    }

    /// <summary>The density of <see cref="Hemisphere"/>, per steradian.</summary>
    public static double HemispherePdf(Vector direction)
    {
        //? Warps.HemispherePdf: one over the solid angle of all directions above.
        return direction.Z > 0 ? 1 / (2 * Math.PI) : 0;
        //!
    }

    /// <summary>Directions above the surface, in proportion to the cosine of the angle to (0, 0, 1).</summary>
    public static Vector CosineHemisphere((double U, double V) random)
    {
        //? Warps.CosineHemisphere: lift the points of the disk to the sphere above (Malley).
        (double x, double y) = Disk(random);
        return new(x, y, Math.Sqrt(Math.Max(0, 1 - (x * x) - (y * y))));
        //!
    }

    /// <summary>The density of <see cref="CosineHemisphere"/>, per steradian.</summary>
    public static double CosineHemispherePdf(Vector direction)
    {
        //? Warps.CosineHemispherePdf: in proportion to the cosine; over all directions above it must integrate to 1.
        return Math.Max(direction.Z, 0) / Math.PI;
        //!
    }
}
