namespace RayTracer.RenderTests.Analytic;

/// <summary>Irradiance of a point from light sources of radiance 1, in closed form or as an integral over smooth pieces.</summary>
internal static class Irradiance
{
    /// <summary>
    /// From a sphere, wholly or partly above the horizon: ∫ cos⁺ over its cone of directions. Around the sphere's axis the
    /// integral of cos⁺ is elementary, and only the angle from the axis is left.
    /// </summary>
    public static double FromSphere(Vec3D point, Vec3D normal, Vec3D center, double radius)
    {
        Vec3D to = center - point;
        double rim = Math.Asin(radius / to.Length);
        double axis = Math.Acos(to.Unit.Dot(normal));

        // Where circles around the axis begin to dip below the horizon, the integrand has a kink.
        double kink = Math.Clamp(Math.Abs((Math.PI / 2) - axis), 0, rim);
        return Quadrature.Integrate(0, kink, 64, a => Math.Sin(a) * AroundAxis(axis, a))
            + Quadrature.Integrate(kink, rim, 64, a => Math.Sin(a) * AroundAxis(axis, a));
    }

    /// <summary>
    /// From a polygon: Lambert's sum over its edges (Lambert 1760; Baum, Rushmeier &amp; Winget 1989, eq. 9), of the part
    /// above the horizon.
    /// </summary>
    public static double FromPolygon(Vec3D point, Vec3D normal, params Vec3D[] corners)
    {
        Vec3D[] above = [.. AboveHorizon([.. corners.Select(c => c - point)], normal)];
        double sum = 0;
        for (int i = 0; i < above.Length; i++)
        {
            (Vec3D a, Vec3D b) = (above[i].Unit, above[(i + 1) % above.Length].Unit);
            Vec3D across = a.Cross(b);
            sum += Math.Atan2(across.Length, a.Dot(b)) * (across.Length > 0 ? across.Unit.Dot(normal) : 0);
        }

        return Math.Abs(sum) / 2;
    }

    /// <summary>From a level disk above that faces down, onto a level place (Howell 2010's catalogue has it as the factor of a disk and a parallel element).</summary>
    public static double FromLevelDisk(Vec3D point, Vec3D center, double radius)
    {
        Vec3D to = center - point;
        double far = to.Dot(to) + (radius * radius);
        double aside = to.Dot(to) - (to.Y * to.Y);
        return Math.PI / 2 * (1 - ((far - (2 * radius * radius)) / Math.Sqrt((far * far) - (4 * radius * radius * aside))));
    }

    /// <summary>From a rectangle that shines by a power of the cosine with its normal; it must be above the horizon.</summary>
    public static double FromSpot(Vec3D point, Vec3D normal, Vec3D center, Vec3D edgeU, Vec3D edgeV, double exponent)
    {
        Vec3D area = edgeU.Cross(edgeV);
        return area.Length * Quadrature.Mean(-0.5, 0.5, -0.5, 0.5, 16, (u, v) =>
        {
            Vec3D to = center + (edgeU * u) + (edgeV * v) - point;
            double emission = Math.Abs(to.Unit.Dot(area.Unit));
            return to.Unit.Dot(normal) * Math.Pow(emission, exponent + 1) / to.Dot(to);
        });
    }

    // ∫ (cos axis · cos a + sin axis · sin a · cos φ)⁺ dφ over a turn.
    private static double AroundAxis(double axis, double a)
    {
        double mean = Math.Cos(axis) * Math.Cos(a);
        double swing = Math.Sin(axis) * Math.Sin(a);
        double end = Math.Acos(Math.Clamp(-mean / swing, -1, 1));
        return 2 * ((mean * end) + (swing * Math.Sin(end)));
    }

    private static IEnumerable<Vec3D> AboveHorizon(Vec3D[] corners, Vec3D normal)
    {
        for (int i = 0; i < corners.Length; i++)
        {
            (Vec3D a, Vec3D b) = (corners[i], corners[(i + 1) % corners.Length]);
            (double heightA, double heightB) = (a.Dot(normal), b.Dot(normal));
            if (heightA >= 0)
            {
                yield return a;
            }

            if (heightA * heightB < 0)
            {
                yield return a + ((b - a) * (heightA / (heightA - heightB)));
            }
        }
    }
}
