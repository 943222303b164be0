using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>
/// Draws scenes as lines, for views from elsewhere. There are never more than some thousand lines: of large meshes, and of too many things,
/// boxes.
/// </summary>
public static class Wireframe
{
    private const int MostPoints = 200_000;
    private const int MostEdges = 2000;

    // What has no end is drawn as a square of this many times the size of all else.
    private const float EndlessScale = 1.5f;

    /// <summary>Draws a scene.</summary>
    public static IReadOnlyList<WireShape> Of(ViewportScene shown)
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
            { Mesh: { } mesh } => isSimple || mesh.TriangleCount > MostEdges ? WireLines.Box(MeshBounds(mesh)) : Triangles(mesh),
            { Shape: { } shape } => isSimple && shape.Bounds.IsFinite ? WireLines.Box(shape.Bounds) : shape.Wires(middle, size * EndlessScale),
            _ => [],
        };
        return [.. lines.Select(l => l.Select(place.Point).ToArray())];
    }

    private static IEnumerable<Vector3[]> Triangles(MeshData mesh) => Enumerable.Range(0, mesh.TriangleCount).Select(i =>
    {
        (Vector3 a, Vector3 b, Vector3 c) = (mesh.Positions[mesh.Indices[3 * i]], mesh.Positions[mesh.Indices[(3 * i) + 1]], mesh.Positions[mesh.Indices[(3 * i) + 2]]);
        return new[] { a, b, c, a };
    });

    private static Bounds MeshBounds(MeshData mesh) =>
        mesh.Indices.Aggregate(Bounds.Empty, (all, i) => all.Union(new(mesh.Positions[i], mesh.Positions[i])));
}

/// <summary>A thing as lines.</summary>
/// <param name="Pointer">The thing in the text; null where it is not from the text.</param>
/// <param name="Lines">Lines of points, in the world.</param>
public sealed record WireShape(string? Pointer, IReadOnlyList<IReadOnlyList<Vector3>> Lines);
