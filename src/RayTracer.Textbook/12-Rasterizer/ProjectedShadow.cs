namespace RayTracer.Textbook;

/// <summary>Shadows on a plane without a ray: everything is pressed flat onto it, away from the light, and painted dark (Blinn 1988; report, section 4.3.1).</summary>
public static class ProjectedShadow
{
    /// <summary>
    /// The matrix that presses points p onto the plane n·p = d along the rays of a light L: (P·L)·p − (P·p)·L, with P = (n, −d). For the plane y = 0 it
    /// is x′ = (yₗ·x − xₗ·y)/(yₗ − y), and z′ alike, for a light at a point; x′ = x − y·xₗ/yₗ for a parallel one.
    /// </summary>
    /// <param name="normal">n.</param>
    /// <param name="offset">d.</param>
    /// <param name="light">The light: with w = 1 a point, with w = 0 the direction in which a parallel light stands.</param>
    public static Matrix On(Vector normal, double offset, Homogeneous light)
    {
        Homogeneous plane = new(normal.X, normal.Y, normal.Z, -offset);
        double above = (normal.X * light.X) + (normal.Y * light.Y) + (normal.Z * light.Z) - (offset * light.W);
        Homogeneous Row(double l, int axis) => new(
            (axis == 0 ? above : 0) - (l * plane.X), (axis == 1 ? above : 0) - (l * plane.Y), (axis == 2 ? above : 0) - (l * plane.Z), (axis == 3 ? above : 0) - (l * plane.W));
        return new(Row(light.X, 0), Row(light.Y, 1), Row(light.Z, 2), Row(light.W, 3));
    }

    /// <summary>The shadows of triangles, a little above the plane so that they hide it. What reaches above the light, or below the plane, throws none.</summary>
    /// <param name="triangles">The triangles.</param>
    /// <param name="normal">Normal of the plane, towards the light.</param>
    /// <param name="offset">The normal's product with points of the plane.</param>
    /// <param name="light">As in <see cref="On"/>.</param>
    /// <param name="lift">How far above the plane.</param>
    public static IEnumerable<Face> Of(IEnumerable<Face> triangles, Vector normal, double offset, Homogeneous light, double lift)
    {
        Matrix matrix = On(normal, offset + lift, light);
        bool Throws(Vector p) => matrix.Of(p).W > 0 && Vector.Dot(normal, p) >= offset;
        return triangles.Where(t => Throws(t.A) && Throws(t.B) && Throws(t.C))
            .Select(t => new Face(matrix.Of(t.A).Point, matrix.Of(t.B).Point, matrix.Of(t.C).Point, Rgb.Black));
    }
}
