namespace RayTracer.RenderTests.Oracle;

/// <summary>Coordinates around an axis.</summary>
internal static class Round
{
    /// <summary>Distance from the axis, height along it, and the turn that is a half in front.</summary>
    public static (double Radius, double Height, double Turn) Around(Vec p, Vec axis)
    {
        // The front is what of +z is perpendicular to the axis; of an axis along z, what is down from there.
        Vec front = Math.Abs(axis.Z) > 1 - 1e-12 ? new(0, -axis.Z, 0) : (new Vec(0, 0, 1) - (axis.Z * axis)).Unit;
        Vec right = Vec.Cross(axis, front);
        double height = Vec.Dot(p, axis);
        return ((p - (height * axis)).Length, height, 0.5 + (Math.Atan2(Vec.Dot(p, right), Vec.Dot(p, front)) / (2 * Math.PI)));
    }
}
