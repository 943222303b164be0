using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Session;

/// <summary>Draws scenes as lines, for views from elsewhere. There are never more than some thousand lines: of large meshes, and of too many things, boxes.</summary>
public static class Wireframe
{
    private const int MostPoints = 200_000;
    private const int MostEdges = 2000;
    private const int CirclePoints = 32;

    // What has no end is drawn as a square of this many times the size of all else.
    private const float EndlessScale = 1.5f;

    /// <summary>Draws a scene.</summary>
    public static IReadOnlyList<WireShape> Of(ShownScene shown)
    {
        (Vector3 middle, float size) = shown.Extent;
        List<WireShape> shapes = [];
        int points = 0;
        foreach (PlacedSurface surface in shown.Scene.Surfaces())
        {
            List<IReadOnlyList<Vector3>> lines = Lines(surface, middle, size, isSimple: points > MostPoints / 2);
            points += lines.Sum(l => l.Count);
            if (points > MostPoints)
            {
                break;
            }

            shapes.Add(new(shown.PointerOf(surface.Source), lines));
        }

        return shapes;
    }

    private static List<IReadOnlyList<Vector3>> Lines(in PlacedSurface surface, Vector3 middle, float size, bool isSimple)
    {
        Transform place = surface.Place;
        IEnumerable<Vector3[]> lines = surface switch
        {
            { Mesh: { } mesh } => isSimple || mesh.TriangleCount > MostEdges ? BoxEdges(MeshBounds(mesh)) : Triangles(mesh),
            { Shape: { Bounds.IsFinite: true } shape } => isSimple ? BoxEdges(shape.Bounds) : OfShape(shape),
            { Shape: Plane plane } => [Square(middle - (plane.Normal * (middle - plane.Point).Dot(plane.Normal)), plane.Tangent * (size * EndlessScale), plane.Bitangent * (size * EndlessScale))],
            _ => [],
        };
        return [.. lines.Select(l => l.Select(place.Point).ToArray())];
    }

    private static IEnumerable<Vector3[]> OfShape(Shape shape) => shape switch
    {
        Sphere s => [Circle(s.Center, Vector3.UnitX, Vector3.UnitY, s.Radius), Circle(s.Center, Vector3.UnitY, Vector3.UnitZ, s.Radius), Circle(s.Center, Vector3.UnitZ, Vector3.UnitX, s.Radius)],
        Rectangle r => [[r.Corner, r.Corner + r.EdgeU, r.Corner + r.EdgeU + r.EdgeV, r.Corner + r.EdgeV, r.Corner]],
        Triangle t => [[t.A, t.B, t.C, t.A]],
        Disk d => [Circle(d.Center, d.Tangent, d.Bitangent, d.Radius)],
        Plane { Size: { } size } p => [Square(p.Point, p.Tangent * (size.X / 2), p.Bitangent * (size.Y / 2))],
        ConicalShape c => Conical(c),
        Torus t => OfTorus(t),
        _ => BoxEdges(shape.Bounds),
    };

    private static IEnumerable<Vector3[]> Conical(ConicalShape c)
    {
        (Vector3 u, Vector3 v) = Across(c.Top - c.Bottom);
        Vector3[] sides = [u, v, -u, -v];
        return [Circle(c.Bottom, u, v, c.Radius), Circle(c.Top, u, v, c.TopRadius), .. sides.Select(s => new[] { c.Bottom + (s * c.Radius), c.Top + (s * c.TopRadius) })];
    }

    private static IEnumerable<Vector3[]> OfTorus(Torus t)
    {
        Vector3 axis = t.Axis.Unit();
        (Vector3 u, Vector3 v) = Across(axis);
        Vector3[] around = [u, (u + v).Unit(), v, (v - u).Unit(), -u, (-u - v).Unit(), -v, (u - v).Unit()];
        return
        [
            Circle(t.Center, u, v, t.Radius + t.TubeRadius), Circle(t.Center, u, v, t.Radius - t.TubeRadius),
            Circle(t.Center + (axis * t.TubeRadius), u, v, t.Radius), Circle(t.Center - (axis * t.TubeRadius), u, v, t.Radius),
            .. around.Select(a => Circle(t.Center + (a * t.Radius), a, axis, t.TubeRadius)),
        ];
    }

    private static Vector3[] Circle(Vector3 center, Vector3 u, Vector3 v, float radius) => [.. Enumerable.Range(0, CirclePoints + 1).Select(i =>
    {
        LaneMath.SinCosTurn(i % CirclePoints / (float)CirclePoints, out float sin, out float cos);
        return center + (((u * cos) + (v * sin)) * radius);
    })];

    private static Vector3[] Square(Vector3 center, Vector3 u, Vector3 v) => [center - u - v, center + u - v, center + u + v, center - u + v, center - u - v];

    private static IEnumerable<Vector3[]> Triangles(MeshData mesh) => Enumerable.Range(0, mesh.TriangleCount).Select(i =>
    {
        (Vector3 a, Vector3 b, Vector3 c) = (mesh.Positions[mesh.Indices[3 * i]], mesh.Positions[mesh.Indices[(3 * i) + 1]], mesh.Positions[mesh.Indices[(3 * i) + 2]]);
        return new[] { a, b, c, a };
    });

    private static Bounds MeshBounds(MeshData mesh) => mesh.Indices.Aggregate(Bounds.Empty, (all, i) => all.Union(new(mesh.Positions[i], mesh.Positions[i])));

    // A ring below, a ring above, and the four edges between them.
    private static IEnumerable<Vector3[]> BoxEdges(Bounds box)
    {
        if (!box.IsFinite)
        {
            return [];
        }

        Vector3[] c = [.. box.Corners()];
        return [[c[0], c[1], c[3], c[2], c[0]], [c[4], c[5], c[7], c[6], c[4]], [c[0], c[4]], [c[1], c[5]], [c[2], c[6]], [c[3], c[7]]];
    }

    private static (Vector3 U, Vector3 V) Across(Vector3 axis)
    {
        Vector3 a = axis.Unit();
        Vector3 u = a.Cross(MathF.Abs(a.X) < 0.5f ? Vector3.UnitX : Vector3.UnitY).Unit();
        return (u, a.Cross(u));
    }
}
