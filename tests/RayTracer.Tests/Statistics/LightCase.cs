using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Shapes;
using RayTracer.Tests.Shapes;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Tests.Statistics;

/// <summary>A light and a lit point: what is known of the light from there in closed form.</summary>
/// <param name="Name">A name for messages.</param>
/// <param name="Shape">The light.</param>
/// <param name="From">The lit point.</param>
internal sealed record LightCase(string Name, Shape Shape, Vector3 From)
{
    /// <summary>What the lights emit: a colour that encodes u and v, and falls off with the cosine.</summary>
    public const float Multiplier = 3, Exponent = 2.5f;

    private static readonly Material s_material = new LuminaireMaterial(new UvTexture(), Multiplier, Exponent, null);
    private static readonly Vector3 s_center = new(0.2f, -0.3f, 0.1f);
    private static readonly Vector3 s_bottom = new(-0.2f, -0.6f, 0.1f);
    private static readonly Vector3 s_top = new(0.3f, 0.7f, -0.2f);
    private static readonly Triangle s_triangle =
        new(s_material, "", new(-1, 0, 1), new(1.5f, 0.3f, 1), new(0.1f, 0.2f, -1.5f), new(0, 0), new(0.9f, 0.1f), new(0.3f, 1));

    private static readonly Plane s_rectangle = new(s_material, "", new(0.1f, 0.2f, -0.3f), Vector3.Normalize(new(0.2f, 1, 0.3f)), new Vector2(2, 3));

    /// <summary>All cases.</summary>
    public static IReadOnlyList<LightCase> All { get; } =
    [
        new("sphere by cone", Sphere(SphereLightSampling.Cone), new(0.5f, 3, 1)),
        new("sphere by cone, near", Sphere(SphereLightSampling.Cone), s_center + new Vector3(0, 0, 1.3f)),
        new("sphere by cone, far", Sphere(SphereLightSampling.Cone), new(200, -300, 150)),
        new("sphere by cone, just outside", Sphere(SphereLightSampling.Cone), s_center - new Vector3(0, 0, 1.201f)),
        new("sphere by cone, inside", Sphere(SphereLightSampling.Cone), new(0, 0, 0.5f)),
        new("sphere by surface", Sphere(SphereLightSampling.Surface), new(0.5f, 3, 1)),
        new("sphere by surface, near", Sphere(SphereLightSampling.Surface), s_center + new Vector3(1.4f, 0, 0)),
        new("sphere by surface, far", Sphere(SphereLightSampling.Surface), new(200, -300, 150)),
        new("sphere by surface, inside", Sphere(SphereLightSampling.Surface), new(0, 0, 0.5f)),
        new("rectangle", s_rectangle, new(0.5f, 3, 1)),
        new("rectangle, near", s_rectangle, new(0.3f, 0.8f, -0.3f)),
        new("rectangle, far and aslant", s_rectangle, new(-40, 5, 20)),
        new("rectangle, from behind", s_rectangle, new(0.5f, -3, 1)),
        new("triangle", s_triangle, new(0.5f, 3, 1)),
        new("triangle, near", s_triangle, new(0.4f, 0.6f, 0.2f)),
        new("triangle, far and aslant", s_triangle, new(30, 6, -40)),
        new("triangle, from behind", s_triangle, new(0.5f, -3, 1)),
        .. Around("disk", new Disk(s_material, "", new(0.1f, 0.2f, -0.3f), Vector3.Normalize(new(0.2f, 1, 0.3f)), 1.3f)),
        .. Around("parallelogram", new Rectangle(s_material, "", new(-1, 0.1f, 1), new(2, 0.3f, 0.5f), new(0.4f, 0.2f, -1.7f))),
        .. Around("turned box", TurnedBoxes.Make(s_material, new(0.1f, 0.1f, -0.1f), new(0.3f, 1, 0.2f), 25, new(0.8f, 0.5f, 0.7f))),
        .. Around("box", new Box(s_material, "", new(-0.8f, 0.6f, 0.8f), new(0.9f, -0.5f, -0.7f))),
        .. Around("cylinder", new Cylinder(s_material, "", s_bottom, s_top, 0.8f, caps: true)),
        .. Around("pipe", new Cylinder(s_material, "", s_bottom, s_top, 0.8f, caps: false)),
        .. Around("cone", new Cone(s_material, "", s_bottom, s_top, 0.8f, 0, caps: true)),
        .. Around("frustum", new Cone(s_material, "", s_bottom, s_top, 0.5f, 0.9f, caps: true)),
        .. Around("torus", new Torus(s_material, "", new(0.1f, -0.1f, 0.2f), new(0.8f, 1, 0.4f), 1.1f, 0.35f)),
        .. Around("fat torus", new Torus(s_material, "", new(0.1f, -0.1f, 0.2f), new(0.8f, 1, 0.4f), 0.9f, 0.75f)),
    ];

    // From the side, from above and below, from afar and from inside.
    private static IEnumerable<LightCase> Around(string name, Shape shape) =>
    [
        new(name, shape, new(0.5f, 3, 1)), new(name + ", from the side", shape, new(2.6f, 0.3f, -0.7f)),
        new(name + ", from below", shape, new(-0.4f, -2.5f, 0.3f)), new(name + ", far", shape, new(40, 25, -20)),
        .. shape is Box or TurnedBox ? Array.Empty<LightCase>() : [new(name + ", from inside", shape, new(0.1f, 0.1f, 0))],
    ];

    /// <summary>Unit direction to a sphere's centre.</summary>
    public Vector3D Axis => ((Vector3D)((Sphere)Shape).Center - From).Unit;

    /// <summary>1 − cosine of the rim of the cone in which a sphere is seen; 0 from inside.</summary>
    public double ConeHeight
    {
        get
        {
            double sin = ((Sphere)Shape).Radius / ((Vector3D)((Sphere)Shape).Center - From).Length;
            return sin >= 1 ? 0 : sin * sin / (1 + Math.Sqrt(1 - (sin * sin)));
        }
    }

    /// <summary>The solid angle under which the light's front is seen: of a triangle by van Oosterom &amp; Strackee 1983, eq. 8.</summary>
    public double SolidAngle
    {
        get
        {
            if (Shape is Sphere)
            {
                return 2 * Math.PI * ConeHeight;
            }

            if (Surface is not null)
            {
                return Surface.SolidAngle;
            }

            Vector3D[] corners = Corners();
            return Enumerable.Range(2, corners.Length - 2).Sum(i => Math.Max(0, TriangleAngle(corners[0], corners[i - 1], corners[i])));
        }
    }

    /// <summary>
    /// The integral of the direction over the solid angle, whose component along any normal that sees the whole light is the
    /// irradiance: π sin² of a sphere's cone; of a polygon, half the sum over its edges of angle times
    /// normal (Lambert's formula).
    /// </summary>
    public Vector3D VectorIrradiance
    {
        get
        {
            if (Shape is Sphere)
            {
                return Axis * (Math.PI * ConeHeight * (2 - ConeHeight));
            }

            if (Surface is not null)
            {
                return Surface.VectorIrradiance;
            }

            Vector3D[] corners = Corners();
            Vector3D sum = default;
            for (int i = 0; i < corners.Length; i++)
            {
                (Vector3D a, Vector3D b) = (corners[i].Unit, corners[(i + 1) % corners.Length].Unit);
                sum -= a.Cross(b).Unit * (Math.Atan2(a.Cross(b).Length, a.Dot(b)) / 2);
            }

            return SolidAngle > 0 ? sum : default;
        }
    }

    /// <summary>The part of the surface that is sampled, in formulas; null for the shapes that have closed forms.</summary>
    public LightSurface? Surface { get; } = Shape is Sphere { } or Plane or Triangle ? null : new(Shape, From);

    /// <summary>The area that points are chosen from.</summary>
    public double SampledArea => Surface?.Area ?? Shape.Area;

    /// <summary>The case of a name.</summary>
    public static LightCase Of(string name) => All.Single(c => c.Name == name);

    /// <summary>Outward unit normal at a point of the light.</summary>
    public Vector3D NormalAt(Vector3D p) => Shape switch
    {
        Sphere s => (p - s.Center).Unit,
        Plane r => (Vector3D)r.Normal,
        not Triangle => Surface!.NormalAt(p),
        _ => ((Vector3D)s_triangle.B - s_triangle.A).Cross((Vector3D)s_triangle.C - s_triangle.A).Unit,
    };

    /// <summary>Where a point of the light lies in the unit square from which the surface is sampled.</summary>
    public (double S, double T) SquareOf(Vector3D p)
    {
        switch (Shape)
        {
            case Sphere s:
                Vector3D n = (p - s.Center) * (1 / s.Radius);
                return ((1 - n.Z) / 2, Turn(n.Y, n.X));
            case Plane r:
                return (0.5 + ((p - r.Point).Dot(r.Tangent) / r.Size!.Value.X), 0.5 + ((p - r.Point).Dot(r.Bitangent) / r.Size!.Value.Y));
            case not Triangle:
                return Surface!.SquareOf(p);
            default:
                (double b, double c) = Barycentric(p);
                return ((1 - b) * (1 - b), c / (1 - b));
        }
    }

    /// <summary>Surface coordinates of a point of the light, as the scene format defines them.</summary>
    public (double U, double V) UvOf(Vector3D p)
    {
        switch (Shape)
        {
            case Sphere s:
                Vector3D n = (p - s.Center).Unit;
                return (0.5 + (Math.Atan2(n.X, n.Z) / (2 * Math.PI)), Math.Acos(-n.Y) / Math.PI);
            case Plane:
                return SquareOf(p);
            case not Triangle:
                return Surface!.UvOf(p);
            default:
                (double b, double c) = Barycentric(p);
                return ((0.9 * b) + (0.3 * c), (0.1 * b) + c);
        }
    }

    /// <summary>A direction's turn around the axis to a sphere's centre, and its share of the cone's height.</summary>
    public (double S, double T) ConeSquareOf(Vector3D direction)
    {
        Vector3D first = Axis.Perpendicular();
        return ((direction - Axis).Squared / 2 / ConeHeight, Turn(direction.Dot(first), direction.Dot(Axis.Cross(first))));
    }

    private static Sphere Sphere(SphereLightSampling sampling) => new(s_material, "", s_center, 1.2f) { LightSampling = sampling };

    private static double Turn(double y, double x) => (Math.Atan2(y, x) / (2 * Math.PI)) + (y < 0 ? 1 : 0);

    private static (double B, double C) Barycentric(Vector3D p)
    {
        Vector3D b = (Vector3D)s_triangle.B - s_triangle.A;
        Vector3D c = (Vector3D)s_triangle.C - s_triangle.A;
        Vector3D n = b.Cross(c);
        Vector3D q = p - s_triangle.A;
        return (q.Cross(c).Dot(n) / n.Squared, b.Cross(q).Dot(n) / n.Squared);
    }

    private static double TriangleAngle(Vector3D a, Vector3D b, Vector3D c)
    {
        (double la, double lb, double lc) = (a.Length, b.Length, c.Length);
        double denominator = (la * lb * lc) + (a.Dot(b) * lc) + (a.Dot(c) * lb) + (b.Dot(c) * la);
        return -2 * Math.Atan2(a.Dot(b.Cross(c)), denominator);
    }

    // Counter-clockwise as seen from the front, relative to the lit point.
    private Vector3D[] Corners()
    {
        if (Shape is Triangle t)
        {
            return [(Vector3D)t.A - From, (Vector3D)t.B - From, (Vector3D)t.C - From];
        }

        var r = (Plane)Shape;
        Vector3D u = (Vector3D)r.Tangent * (r.Size!.Value.X / 2);
        Vector3D v = (Vector3D)r.Bitangent * (r.Size!.Value.Y / 2);
        Vector3D middle = (Vector3D)r.Point - From;
        return [middle - u - v, middle + u - v, middle + u + v, middle - u + v];
    }
}
