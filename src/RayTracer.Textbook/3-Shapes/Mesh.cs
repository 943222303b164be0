namespace RayTracer.Textbook;

/// <summary>Triangles that share corners, with a tree of their own.</summary>
public sealed class Mesh : IShape
{
    private readonly Vector[] _points;
    private readonly Vector[]? _normals;
    private readonly (double U, double V)[]? _uv;
    private readonly MeshTriangle[] _triangles;
    private readonly IAccelerator _tree;
    private readonly Distribution _areas;

    /// <summary>Makes one.</summary>
    /// <param name="points">The corners.</param>
    /// <param name="triangles">Three corners a triangle, counter-clockwise as seen from the front.</param>
    /// <param name="normals">The normals with which corners are shaded; null for flat triangles.</param>
    /// <param name="uv">The places of corners on textures; null for none.</param>
    public Mesh(Vector[] points, IReadOnlyList<(int A, int B, int C)> triangles, Vector[]? normals = null, (double U, double V)[]? uv = null)
    {
        (_points, _normals, _uv) = (points, normals, uv);
        _triangles = [.. triangles.Select(t => new MeshTriangle(points, t.A, t.B, t.C)).Where(t => t.Area > 0)];
        _tree = new BoundingVolumes(_triangles);
        _areas = new([.. _triangles.Select(t => t.Area)]);
        Bounds = Array.ConvertAll(_triangles, t => t.Bounds).Aggregate(Bounds.Empty, (all, own) => all.With(own));
    }

    /// <inheritdoc/>
    public Bounds Bounds { get; }

    /// <inheritdoc/>
    public IEnumerable<IShape> Parts => _triangles;

    /// <inheritdoc/>
    public double Area => _areas.Sum;

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        if (!_tree.Intersect(ray, ref hit))
        {
            return false;
        }

        hit.Part = hit.Index;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        MeshTriangle triangle = _triangles[hit.Part];
        hit.Point = ray.At(hit.Distance);
        (double b, double c) = triangle.Barycentric(hit.Point);
        hit.Point = triangle.At(b, c);
        hit.Normal = hit.Shading = triangle.Normal;
        (hit.U, hit.V) = Uv(triangle, b, c);
        if (_normals is not null)
        {
            Vector shading = ((1 - b - c) * _normals[triangle.A]) + (b * _normals[triangle.B]) + (c * _normals[triangle.C]);
            hit.Shading = shading.Length > 0 ? shading.Unit : hit.Normal;
        }
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        (int chosen, double rest) = _areas.Choose(random.U);
        MeshTriangle triangle = _triangles[chosen];
        (double b, double c) = Warp.Triangle((rest, random.V));
        (double u, double v) = Uv(triangle, b, c);
        return new(triangle.At(b, c), triangle.Normal, u, v, 1 / Area);
    }

    private (double U, double V) Uv(MeshTriangle t, double b, double c) => _uv is null ? default
        : (((1 - b - c) * _uv[t.A].U) + (b * _uv[t.B].U) + (c * _uv[t.C].U), ((1 - b - c) * _uv[t.A].V) + (b * _uv[t.B].V) + (c * _uv[t.C].V));
}

/// <summary>A triangle of a mesh.</summary>
/// <param name="points">The corners of the mesh.</param>
/// <param name="a">Number of the first corner.</param>
/// <param name="b">Number of the second corner.</param>
/// <param name="c">Number of the third corner.</param>
public sealed class MeshTriangle(Vector[] points, int a, int b, int c) : IShape
{
    /// <summary>Number of the first corner.</summary>
    public int A => a;

    /// <summary>Number of the second corner.</summary>
    public int B => b;

    /// <summary>Number of the third corner.</summary>
    public int C => c;

    /// <inheritdoc/>
    public Bounds Bounds => Bounds.Around(points[a], points[b], points[c]);

    /// <summary>Between its corners.</summary>
    public (double Low, double High) Along(Vector direction)
    {
        (double x, double y, double z) = (Vector.Dot(points[a], direction), Vector.Dot(points[b], direction), Vector.Dot(points[c], direction));
        return (Math.Min(x, Math.Min(y, z)), Math.Max(x, Math.Max(y, z)));
    }

    /// <inheritdoc/>
    public double Area => 0.5 * Across.Length;

    /// <summary>Unit normal.</summary>
    public Vector Normal => Across.Unit;

    private Vector Across => Vector.Cross(points[b] - points[a], points[c] - points[a]);

    /// <summary>
    /// Solves O + t·D = A + u·(B − A) + v·(C − A) by Cramer's rule (report, section 3.3.5), whose determinants are triple products (Möller &amp;
    /// Trumbore 1997).
    /// </summary>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        Vector edgeB = points[b] - points[a];
        Vector edgeC = points[c] - points[a];
        Vector p = Vector.Cross(ray.Direction, edgeC);
        double inverse = 1 / Vector.Dot(edgeB, p);
        Vector from = ray.Origin - points[a];
        double u = Vector.Dot(from, p) * inverse;
        if (!(u >= 0 && u <= 1))
        {
            return false;
        }

        Vector q = Vector.Cross(from, edgeB);
        double v = Vector.Dot(ray.Direction, q) * inverse;
        double t = Vector.Dot(edgeC, q) * inverse;
        if (!(v >= 0 && u + v <= 1 && t > 0 && t < hit.Distance))
        {
            return false;
        }

        hit.Distance = t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        hit.Point = ray.At(hit.Distance);
        hit.Normal = hit.Shading = Normal;
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        (double u, double v) = Warp.Triangle(random);
        return new(At(u, v), Normal, u, v, 1 / Area);
    }

    /// <summary>The point with barycentric coordinates, which it is the first corner where both are 0.</summary>
    public Vector At(double ofB, double ofC) => points[a] + (ofB * (points[b] - points[a])) + (ofC * (points[c] - points[a]));

    /// <summary>The barycentric coordinates of a point: the areas opposite of the corners, as shares of the whole (report, section 3.3.3).</summary>
    public (double OfB, double OfC) Barycentric(Vector point)
    {
        Vector across = Across;
        double square = Vector.Dot(across, across);
        Vector from = point - points[a];
        return (Vector.Dot(Vector.Cross(from, points[c] - points[a]), across) / square, Vector.Dot(Vector.Cross(points[b] - points[a], from), across) / square);
    }
}
