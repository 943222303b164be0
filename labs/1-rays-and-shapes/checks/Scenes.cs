using RayTracer.Labs;

namespace Lab1;

/// <summary>A closed shell of triangles around the origin, from which no ray may escape.</summary>
public sealed class Shell
{
    private const int Rings = 8;
    private const int Around = 12;
    private readonly Vector[] _corners;
    private readonly List<(int A, int B, int C)> _triangles = [];

    /// <summary>Makes one with uneven radii.</summary>
    public Shell(ISampler random)
    {
        _corners = [.. Enumerable.Range(0, Rings * Around).Select(i => Corner(i / Around, i % Around, random)), new(0, 2, 0), new(0, -2, 0)];
        for (int i = 0; i < Around; i++)
        {
            int next = (i + 1) % Around;
            _triangles.Add((Rings * Around, i, next));
            _triangles.Add(((Rings * Around) + 1, ((Rings - 1) * Around) + next, ((Rings - 1) * Around) + i));
            for (int ring = 0; ring < Rings - 1; ring++)
            {
                int row = ring * Around;
                _triangles.Add((row + i, row + Around + i, row + next));
                _triangles.Add((row + next, row + Around + i, row + Around + next));
            }
        }
    }

    /// <summary>The number of corners.</summary>
    public int Corners => _corners.Length;

    /// <summary>Rays from the origin at the corners.</summary>
    public IEnumerable<Ray> AtCorners() => _corners.Select(c => new Ray(default, c));

    /// <summary>Rays from the origin at points of edges.</summary>
    public IEnumerable<Ray> AtEdges(ISampler random, int count) => Enumerable.Range(0, count).Select(_ =>
    {
        (int a, int b, _) = _triangles[(int)(random.Next() * _triangles.Count)];
        return new Ray(default, (_corners[a] + (random.Next() * (_corners[b] - _corners[a]))).Unit);
    });

    /// <summary>True for rays that meet none of the triangles.</summary>
    public Func<Ray, bool> IsMissedBy(Func<Ray, Vector, Vector, Vector, double?> triangle) =>
        ray => _triangles.TrueForAll(t => triangle(ray, _corners[t.A], _corners[t.B], _corners[t.C]) is null);

    private static Vector Corner(int ring, int around, ISampler random)
    {
        double height = 1 - (2 * (ring + 1.0) / (Rings + 1));
        double width = Math.Sqrt(1 - (height * height));
        (double sin, double cos) = Math.SinCos(2 * Math.PI * around / Around);
        return (1.5 + random.Next()) * new Vector(width * cos, height, width * sin);
    }
}

/// <summary>A few things, coloured by the direction of their normals, seen by the student's functions and by the textbook's.</summary>
public sealed class Room
{
    public const int Width = 240;
    public const int Height = 180;
    private const double FieldOfView = 35;
    private static readonly Vector s_eye = new(0, 1.4, 5);
    private static readonly Vector s_lookAt = new(0, 0.7, 0);
    private readonly (Vector Center, double Radius)[] _balls;
    private readonly (Vector A, Vector B, Vector C) _sail = (new(-1.6, 0, -0.6), new(1.4, 0, -1.2), new(-0.3, 2.2, -0.9));
    private readonly Camera _camera = new(s_eye, s_lookAt, FieldOfView, Width, Height);
    private readonly PerspectiveCamera _reference;

    /// <summary>Makes one.</summary>
    public Room(ISampler random)
    {
        _balls = [.. Enumerable.Range(0, 4).Select(i => (new Vector(-1.5 + i, 0.3 + (0.3 * random.Next()), 0.6 * random.Next()), 0.3 + (0.15 * random.Next())))];
        Vector forward = (s_lookAt - s_eye).Unit;
        Vector right = Vector.Cross(forward, new(0, 1, 0)).Unit;
        _reference = new(
            s_eye, forward, right, Vector.Cross(right, forward), Width, Height, 2 * Math.Tan(FieldOfView / 2 * Math.PI / 180) / Height, new Pinhole(), focus: 1);
    }

    /// <summary>A pixel by the student's functions: balls of even number by algebra, the others by geometry.</summary>
    public Rgb Own(int x, int y)
    {
        Ray ray = _camera.RayThrough(x + 0.5, y + 0.5);
        return Colour(
            ray, (i, r) => i % 2 == 0 ? Shapes.SphereByAlgebra(r, _balls[i].Center, _balls[i].Radius) : Shapes.SphereByGeometry(r, _balls[i].Center, _balls[i].Radius),
            r => Shapes.Plane(r, default, new(0, 1, 0)), r => Shapes.Triangle(r, _sail.A, _sail.B, _sail.C));
    }

    /// <summary>The same pixel by the textbook's.</summary>
    public Rgb Reference(int x, int y)
    {
        Ray ray = _reference.RayThrough(x + 0.5, y + 0.5, new IndependentSampler());
        return Colour(
            ray, (i, r) => Meet(new Sphere(_balls[i].Center, _balls[i].Radius), r),
            r => Meet(new Plane(default, new(0, 0, 1), new(1, 0, 0)), r), r => Meet(new Triangle(_sail.A, _sail.B, _sail.C, default), r));
    }

    private static double? Meet(IShape shape, Ray ray)
    {
        Hit hit = Hit.None();
        return shape.Intersect(ray, ref hit) ? hit.Distance : null;
    }

    private Rgb Colour(Ray ray, Func<int, Ray, double?> ball, Func<Ray, double?> floor, Func<Ray, double?> sail)
    {
        double nearest = double.PositiveInfinity;
        Rgb color = new(0.55, 0.7, 0.9);
        void See(double? t, Func<Vector, Rgb> colour)
        {
            if (t < nearest)
            {
                nearest = t.Value;
                color = colour(ray.At(nearest));
            }
        }

        See(floor(ray), p => (((int)Math.Floor(p.X) + (int)Math.Floor(p.Z)) & 1) == 0 ? new(0.25) : new(0.6));
        See(sail(ray), _ => new(0.8, 0.3, 0.2));
        for (int i = 0; i < _balls.Length; i++)
        {
            Vector center = _balls[i].Center;
            See(ball(i, ray), p => (p - center).Unit is var n ? new(0.5 + (0.5 * n.X), 0.5 + (0.5 * n.Y), 0.5 + (0.5 * n.Z)) : default);
        }

        return color;
    }
}
