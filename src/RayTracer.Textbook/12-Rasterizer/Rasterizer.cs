namespace RayTracer.Textbook;

/// <summary>A triangle to draw. Seen from the front, its corners go counter-clockwise.</summary>
/// <param name="A">First corner.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner.</param>
/// <param name="Color">The share of light that is reflected; black for shadows.</param>
public readonly record struct Face(Vector A, Vector B, Vector C, Rgb Color)
{
    /// <summary>The unit normal.</summary>
    public Vector Normal => Vector.Cross(B - A, C - A).Unit;

    /// <summary>The normals at the corners, of what the triangle stands for (Gouraud 1971); null for its own at all of them: then it looks flat.</summary>
    public (Vector A, Vector B, Vector C)? Normals { get; init; }
}

/// <summary>A light that a rasterizer knows.</summary>
/// <param name="Place">With w = 1 its point, with w = 0 the unit direction in which it stands.</param>
/// <param name="Power">Power per steradian of a point; irradiance across the direction of a parallel light.</param>
public sealed record RasterLight(Homogeneous Place, Rgb Power);

/// <summary>
/// The other way to find what is visible (report, sections 1.2 and 3.1): not for each pixel the triangles, but for each triangle the pixels. Matrices take
/// its corners to the picture, and it is filled. Of two at one pixel the nearer is kept (Catmull 1974), or the one that is painted last.
/// </summary>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
public sealed class Rasterizer(int width, int height)
{
    private readonly double[] _depths = [.. Enumerable.Repeat(1.0, width * height)];
    private readonly Matrix _viewport = Matrix.Viewport(width, height);

    /// <summary>The picture, row by row from the top left.</summary>
    public Rgb[] Pixels { get; } = new Rgb[width * height];

    /// <summary>The number of the triangle that each pixel shows; −1 for none.</summary>
    public int[] Visible { get; } = [.. Enumerable.Repeat(-1, width * height)];

    /// <summary>True to leave out triangles that are seen from behind.</summary>
    public bool CullsBackFaces { get; init; }

    /// <summary>True for the painter's algorithm: no depths are kept, and each triangle hides all that were painted before.</summary>
    public bool IsPainter { get; init; }

    /// <summary>The lights.</summary>
    public IReadOnlyList<RasterLight> Lights { get; init; } = [];

    /// <summary>Ambient light.</summary>
    public Rgb Ambient { get; init; }

    /// <summary>Draws triangles; a painter begins with those whose middle is farthest, which is wrong where they cross or hide each other in a circle.</summary>
    /// <param name="faces">The triangles, in the world.</param>
    /// <param name="camera">The matrix of view and projection.</param>
    public void Draw(IReadOnlyList<Face> faces, Matrix camera)
    {
        Span<Vertex> clipped = stackalloc Vertex[4];
        IEnumerable<int> order = Enumerable.Range(0, faces.Count);
        foreach (int i in IsPainter ? order.OrderByDescending(i => camera.Of((faces[i].A + faces[i].B + faces[i].C) * (1.0 / 3)).W) : order)
        {
            Face f = faces[i];
            (Vector a, Vector b, Vector c) = f.Normals ?? (f.Normal, f.Normal, f.Normal);
            Span<Vertex> corners = [new(camera.Of(f.A), Light(f.A, a, f.Color)), new(camera.Of(f.B), Light(f.B, b, f.Color)), new(camera.Of(f.C), Light(f.C, c, f.Color))];
            int count = Clip(corners, clipped);
            for (int k = 2; k < count; k++)
            {
                Fill(i, clipped[0], clipped[k - 1], clipped[k]);
            }
        }
    }

    // Lambert's law at a corner; what is between is interpolated.
    private Rgb Light(Vector point, Vector normal, Rgb color)
    {
        Rgb light = Ambient;
        foreach (RasterLight source in Lights)
        {
            Vector to = new Vector(source.Place.X, source.Place.Y, source.Place.Z) - (source.Place.W * point);
            double distance2 = source.Place.W == 0 ? 1 : Vector.Dot(to, to);
            light += source.Power * (Math.Max(0, Vector.Dot(normal, to.Unit)) / (distance2 * Math.PI));
        }

        return color * light;
    }

    // The part in front of the near plane, where z is above 0 (Sutherland & Hodgman 1974): a triangle, or what is left of it with four corners.
    private static int Clip(ReadOnlySpan<Vertex> corners, Span<Vertex> clipped)
    {
        int count = 0;
        for (int i = 0; i < 3; i++)
        {
            (Vertex from, Vertex to) = (corners[i], corners[(i + 1) % 3]);
            if (from.Place.Z >= 0)
            {
                clipped[count++] = from;
            }

            if (from.Place.Z >= 0 != to.Place.Z >= 0)
            {
                double share = from.Place.Z / (from.Place.Z - to.Place.Z);
                clipped[count++] = new(from.Place.Towards(to.Place, share), from.Light + ((to.Light - from.Light) * share));
            }
        }

        return count;
    }

    // All pixels whose middle is on the inner side of all three edges (Pineda 1988). The products of the edges are barycentric coordinates in the picture:
    // z/w is linear there, and so are 1/w and light/w, of which light itself follows at each pixel.
    private void Fill(int number, in Vertex a, in Vertex b, in Vertex c)
    {
        (Vector p, Vector q, Vector r) = (_viewport.Of(a.Place.Point).Point, _viewport.Of(b.Place.Point).Point, _viewport.Of(c.Place.Point).Point);

        // Rows go downwards, so that what is counter-clockwise has a product below 0.
        double area = -Edge(p, q, r.X, r.Y);
        if (area == 0 || (CullsBackFaces && area < 0))
        {
            return;
        }

        Vector low = Vector.Max(Vector.Min(p, Vector.Min(q, r)), default);
        Vector high = Vector.Max(p, Vector.Max(q, r));
        (double wa, double wb, double wc) = (1 / a.Place.W, 1 / b.Place.W, 1 / c.Place.W);
        for (int y = (int)low.Y; y < height && y <= high.Y; y++)
        {
            for (int x = (int)low.X; x < width && x <= high.X; x++)
            {
                double u = -Edge(q, r, x + 0.5, y + 0.5) / area;
                double v = -Edge(r, p, x + 0.5, y + 0.5) / area;
                double w = 1 - u - v;
                double depth = (u * p.Z) + (v * q.Z) + (w * r.Z);
                int pixel = (y * width) + x;
                if (u < 0 || v < 0 || w < 0 || depth > 1 || (!IsPainter && depth >= _depths[pixel]))
                {
                    continue;
                }

                _depths[pixel] = depth;
                Visible[pixel] = number;
                Pixels[pixel] = ((a.Light * (u * wa)) + (b.Light * (v * wb)) + (c.Light * (w * wc))) * (1 / ((u * wa) + (v * wb) + (w * wc)));
            }
        }
    }

    // Twice the area of the triangle of two points and a place: of either sign, by the side of the edge.
    private static double Edge(Vector from, Vector to, double x, double y) => ((to.X - from.X) * (y - from.Y)) - ((to.Y - from.Y) * (x - from.X));

    private readonly record struct Vertex(Homogeneous Place, Rgb Light);
}
