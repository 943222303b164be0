using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Tests.Shapes;

/// <summary>A shape of random form and place, and what is true of it in double precision.</summary>
internal sealed class RandomShape
{
    private static readonly Material s_material = new DiffuseMaterial(new SolidTexture(Rgb.White));
    private readonly Random _random;
    private readonly SolidReference? _solid;

    /// <summary>All kinds of shapes.</summary>
    public static string[] Kinds { get; } =
    [
        "sphere", "rectangle", "plane", "triangle", "disk", "parallelogram", "box", "turned box", "cylinder", "cone", "frustum", "pipe", "funnel", "torus",
    ];

    /// <summary>Makes a shape.</summary>
    /// <param name="kind">One of <see cref="Kinds"/>.</param>
    /// <param name="seed">Selects the random numbers.</param>
    /// <param name="scale">Size of the scene.</param>
    /// <param name="away">How many sizes from the world's origin the shape lies.</param>
    public RandomShape(string kind, int seed, float scale, float away)
    {
        _random = new(seed);
        Vector3 place = Vector() * (scale * away);
        Shape = kind switch
        {
            "sphere" => new Sphere(s_material, "", place, scale * (0.1f + _random.NextSingle())),
            "rectangle" => new Plane(s_material, "", place, Direction(), new Vector2(0.3f + _random.NextSingle(), 0.3f + _random.NextSingle()) * scale),
            "plane" => new Plane(s_material, "", place, Direction(), null),
            "disk" => new Disk(s_material, "", place, Direction(), Size(scale)),
            "parallelogram" => Parallelogram(place, scale),
            "box" => new Box(s_material, "", place + (new Vector3(Size(scale), Size(scale), Size(scale)) * 0.7f), place - new Vector3(Size(scale), Size(scale), Size(scale))),
            "turned box" => TurnedBoxes.Make(s_material, place, Direction(), 360 * _random.NextSingle(), new Vector3(Size(scale), Size(scale), Size(scale))),
            "cylinder" => new Cylinder(s_material, "", place, place + (Direction() * Size(scale)), Size(scale), caps: true),
            "pipe" => new Cylinder(s_material, "", place, place + (Direction() * Size(scale)), Size(scale), caps: false),
            "cone" => new Cone(s_material, "", place, place + (Direction() * Size(scale)), Size(scale), 0, caps: true),
            "frustum" => new Cone(s_material, "", place, place + (Direction() * Size(scale)), Size(scale), Size(scale), caps: true),
            "funnel" => new Cone(s_material, "", place, place + (Direction() * Size(scale)), Size(scale), Size(scale), caps: false),
            "torus" => Ring(place, Size(scale)),
            _ => new Triangle(s_material, "", place + (Vector() * scale), place + (Vector() * scale), place + (Vector() * scale), new(0, 0), new(1, 0), new(0, 1)),
        };
        Batch = Shape.CreateBatch([Shape]);
        _solid = Shape is Box or TurnedBox or ConicalShape or Torus ? new(Shape) : null;
        Reach = scale;
        Center = place;
        Largest = scale * (1 + away);
    }

    /// <summary>The shape.</summary>
    public Shape Shape { get; }

    /// <summary>A batch of this shape alone.</summary>
    public ShapeBatch Batch { get; }

    /// <summary>Size of the scene.</summary>
    public float Reach { get; }

    /// <summary>A point near the shape.</summary>
    public Vector3 Center { get; }

    /// <summary>A bound of all coordinates.</summary>
    public float Largest { get; }

    /// <summary>The shape in double precision, if it has an inside that only that knows.</summary>
    public SolidReference? Solid => _solid;

    /// <summary>What the offset of rays is in proportion to.</summary>
    public float OffsetScale(Vector3 point) => Shape switch
    {
        Sphere s => Vector3.Abs(s.Center).Largest() + s.Radius,
        ConicalShape s => Vector3.Abs((s.Bottom + s.Top) / 2).Largest() + new Vector2(s.Height / 2, Math.Max(s.Radius, s.TopRadius)).Length(),
        Torus t => Vector3.Abs(t.Center).Largest() + t.Radius + t.TubeRadius,
        Box b => Vector3.Max(Vector3.Abs(b.Bounds.Minimum), Vector3.Abs(b.Bounds.Maximum)).Largest(),
        TurnedBox b => Vector3.Max(Vector3.Abs(b.Bounds.Minimum), Vector3.Abs(b.Bounds.Maximum)).Largest(),
        _ => Vector3.Abs(point).Largest(),
    };

    /// <summary>A random vector in the cube from −1 to 1.</summary>
    public Vector3 Vector() => new((2 * _random.NextSingle()) - 1, (2 * _random.NextSingle()) - 1, (2 * _random.NextSingle()) - 1);

    /// <summary>A random unit vector; one in eight is parallel to an axis.</summary>
    public Vector3 Direction() => _random.Next(8) == 0
        ? new Vector3[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ }[_random.Next(3)] * (_random.Next(2) == 0 ? 1 : -1)
        : Vector3.Normalize(Vector() + new Vector3(1e-3f));

    /// <summary>A direction that leaves a surface on the side of a normal, at an angle that is often grazing.</summary>
    public Vector3 Leaving(Vector3 normal)
    {
        float height = MathF.Pow(10, -6 * _random.NextSingle());
        Vector3 along = Vector3.Normalize(Vector3.Cross(normal, Vector()));
        Vector3 direction = Vector3.Normalize((normal * height) + along);
        return Vector3.Dot(direction, normal) > 0 ? direction : normal;
    }

    /// <summary>A random ray towards the shape's neighbourhood.</summary>
    public (Vector3 Origin, Vector3 Direction) Ray()
    {
        Vector3 origin = Center + (Vector() * (2 * Reach));
        return (origin, Vector3.Normalize(Center + (Vector() * (0.7f * Reach)) - origin));
    }

    /// <summary>The nearest hit of a ray; infinite where there is none.</summary>
    public float Hit(Vector3 origin, Vector3 direction)
    {
        FloatW distance = float.PositiveInfinity;
        UIntW primitive = 99u;
        Batch.ClosestHit(origin, direction, ref distance, ref primitive);
        Assert.Equal(float.IsInfinity(distance[0]) ? 99u : 0u, primitive[0]);
        return distance[0];
    }

    /// <summary>Whether a segment is free.</summary>
    public bool IsFree(Vector3 origin, Vector3 direction, float end)
    {
        MaskW free = MaskW.All;
        Batch.Occlude(origin, direction, end, skip: -1, ref free);
        return free.Any;
    }

    /// <summary>Describes the surface at a hit.</summary>
    public (Vector3 Point, Vector3 Normal, float Offset, Vector2 Uv) Describe(Vector3 origin, Vector3 direction, float distance)
    {
        SurfaceW surface = default;
        surface.Point = Vec3W.MultiplyAdd(direction, distance, origin);
        Batch.Describe(new PrimitiveIndex(0, Batch.Stride), needsUv: true, ref surface);
        return (At(surface.Point), At(surface.Normal), surface.Offset[0], new(surface.U[0], surface.V[0]));
    }

    /// <summary>
    /// In double precision: the distance of a point from the shape's whole surface (sphere or plane), and how far it lies outside the
    /// outline (negative within).
    /// </summary>
    public (double Off, double Outside) Measure(Double3 p)
    {
        switch (Shape)
        {
            case Sphere s:
                return ((p - s.Center).Length - s.Radius, double.NegativeInfinity);
            case Triangle t:
                Double3 normal = Double3.Cross(new Double3(t.B) - t.A, new Double3(t.C) - t.A).Unit;
                double Beyond(Vector3 a, Vector3 b) => Double3.Dot(Double3.Cross(new Double3(b) - a, normal).Unit, p - a);
                return (Double3.Dot(normal, p - t.A), Math.Max(Beyond(t.A, t.B), Math.Max(Beyond(t.B, t.C), Beyond(t.C, t.A))));
            case Plane q:
                Double3 offset = p - q.Point;
                double outside = q.Size is not { } size ? double.NegativeInfinity : Math.Max(
                    Math.Abs(Double3.Dot(new Double3(q.Tangent).Unit, offset)) - (0.5 * size.X),
                    Math.Abs(Double3.Dot(new Double3(q.Bitangent).Unit, offset)) - (0.5 * size.Y));
                return (Double3.Dot(new Double3(q.Normal).Unit, offset), outside);
            case Disk d:
                Double3 fromCenter = p - d.Center;
                double height = Double3.Dot(new Double3(d.Normal).Unit, fromCenter);
                return (height, (fromCenter - (new Double3(d.Normal).Unit * height)).Length - d.Radius);
            case Rectangle r:
                Double3 up = Double3.Cross(new(r.EdgeU), new(r.EdgeV)).Unit;
                double Past(Vector3 corner, Vector3 edge, int turn) => turn * Double3.Dot(Double3.Cross(new Double3(edge), up).Unit, p - corner);
                return (Double3.Dot(up, p - r.Corner), Math.Max(
                    Math.Max(Past(r.Corner, r.EdgeU, 1), Past(r.Corner + r.EdgeV, r.EdgeU, -1)),
                    Math.Max(Past(r.Corner, r.EdgeV, -1), Past(r.Corner + r.EdgeU, r.EdgeV, 1))));
            default:
                return _solid!.Measure(p);
        }
    }

    /// <summary>In double precision: distance of the nearest hit of a ray (infinite for none), and the cosine there.</summary>
    public (double Distance, double Cosine, double Outside) Expected(Vector3 origin, Vector3 direction)
    {
        Double3 d = new Double3(direction).Unit;
        if (Shape is Sphere s)
        {
            Double3 from = new Double3(origin) - s.Center;
            double b = Double3.Dot(from, d);
            Double3 nearest = from - (d * b);
            double root2 = ((double)s.Radius * s.Radius) - Double3.Dot(nearest, nearest);
            double root = Math.Sqrt(Math.Max(0, root2));
            double t = -b - root > 0 ? -b - root : root - b;

            // The cosine's sign shows by how much a ray misses.
            return (root2 > 0 && t > 0 ? t : double.PositiveInfinity, Math.Sqrt(Math.Abs(root2)) / s.Radius, double.NegativeInfinity);
        }

        if (_solid is not null)
        {
            return _solid.Meet(new(origin), d, Reach, 64 * Largest / (1 << 24) * 10);
        }

        double height = Measure(new(origin)).Off;
        double climb = Measure(new Double3(origin) + d).Off - height;
        double distance = -height / climb;
        double outside = Measure(new Double3(origin) + (d * distance)).Outside;
        return (distance > 0 && outside <= 0 ? distance : double.PositiveInfinity, Math.Abs(climb), outside);
    }

    private float Size(float scale) => scale * (0.3f + (0.7f * _random.NextSingle()));

    private Rectangle Parallelogram(Vector3 place, float scale)
    {
        Vector3 u = Direction();
        Vector3 across = Vector3.Normalize(Vector3.Cross(u, Vector()));
        return new(s_material, "", place, u * Size(scale), (across + (u * (_random.NextSingle() - 0.5f))) * Size(scale));
    }

    private Torus Ring(Vector3 place, float radius) => new(s_material, "", place, Direction(), radius, radius * (0.1f + (0.85f * _random.NextSingle())));

    private static Vector3 At(in Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);
}

/// <summary>A vector of doubles.</summary>
internal readonly record struct Double3(double X, double Y, double Z)
{
    public Double3(Vector3 v)
        : this(v.X, v.Y, v.Z)
    {
    }

    public double Length => Math.Sqrt(Dot(this, this));

    public Double3 Unit => this * (1 / Length);

    public static Double3 operator +(Double3 a, Double3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Double3 operator -(Double3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Double3 operator -(Double3 a, Double3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Double3 operator *(Double3 a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    public static double Dot(Double3 a, Double3 b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    public static Double3 Cross(Double3 a, Double3 b) => new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));
}
