using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>
/// Makes curves: tubes, or bands where they have normals ("ribbon"). pbrt's flat curves face each ray, so that they look as wide as tubes do.
/// </summary>
internal static class PbrtCurves
{
    private const int Steps = 8;
    private const int Sides = 8;

    // As wide on average as what is round, seen from all sides: the perimeter counts (Cauchy).
    private const float Wider = 1.0261722f;

    /// <summary>The mesh of a curve; null after an error.</summary>
    public static MeshDescription? Read(PbrtThing shape)
    {
        shape.Ignore("splitdepth");
        int degree = shape.Integer("degree", 3, 2);
        Vector3[] points = shape.Vectors("P", "point3");
        Vector3[] normals = shape.Vectors("N", "normal3");
        bool isSpline = shape.Choice("basis", false, new Dictionary<string, bool> { ["bezier"] = false, ["bspline"] = true });
        string type = shape.Choice("type", "flat", new Dictionary<string, string> { ["flat"] = "flat", ["cylinder"] = "cylinder", ["ribbon"] = "ribbon" });
        float width = shape.Float("width", 1, 0);
        Vector2 widths = new(shape.Float("width0", width, 0), shape.Float("width1", width, 0));
        int segments = isSpline ? points.Length - degree : (points.Length - 1) / int.Max(degree, 1);
        string? complaint = degree > 3 ? $"curves are of degree 2 or 3, not {degree}"
            : segments < 1 || (!isSpline && (points.Length - 1) % degree != 0) ? $"a curve of degree {degree} needs {degree + 1} points and {(isSpline ? 1 : degree)} more for each further piece, but has {points.Length}"
            : type == "ribbon" && normals.Length != segments + 1 ? $"a ribbon of {segments} {(segments == 1 ? "piece" : "pieces")} needs {segments + 1} normals, but has {normals.Length}"
            : widths == Vector2.Zero ? "there is nothing of the curve: its width is 0" : null;
        int rows = segments * Steps;
        int across = type == "ribbon" ? 1 : Sides;
        complaint ??= SceneBudget.Open?.Take("the tube of a curve", 80L * (rows + 1) * (across + 1), (rows + 1L) * (across + 1));
        if (complaint is not null)
        {
            return shape.Log.Fail<MeshDescription>(shape.PlaceOf(points.Length > 0 ? "P" : ""), complaint);
        }

        Vector3[] cubic = isSpline ? [.. Enumerable.Range(0, segments).SelectMany(i => Bezier(points.AsSpan(i, degree + 1)))]
            : [.. Enumerable.Range(0, segments).SelectMany(i => Cubic(points.AsSpan(i * degree, degree + 1)))];
        (Vector3[] at, Vector3[] along) = Follow(cubic, segments);
        return type == "ribbon" ? Band(at, along, normals, widths) : Tube(at, along, widths);
    }

    // Of a uniform B-spline's piece (L. Ramshaw, Blossoming: a connect-the-dots approach to splines, 1987).
    private static Vector3[] Bezier(ReadOnlySpan<Vector3> p) => p.Length == 3
        ? Cubic([(p[0] + p[1]) / 2, p[1], (p[1] + p[2]) / 2])
        : [(p[0] + (4 * p[1]) + p[2]) / 6, ((2 * p[1]) + p[2]) / 3, (p[1] + (2 * p[2])) / 3, (p[1] + (4 * p[2]) + p[3]) / 6];

    private static Vector3[] Cubic(ReadOnlySpan<Vector3> p) => p.Length == 4 ? p.ToArray() : [p[0], (p[0] + (2 * p[1])) / 3, ((2 * p[1]) + p[2]) / 3, p[2]];

    // Points of the curve and unit directions along it.
    private static (Vector3[] At, Vector3[] Along) Follow(Vector3[] cubic, int segments)
    {
        int count = (segments * Steps) + 1;
        (Vector3[] at, Vector3[] along) = (new Vector3[count], new Vector3[count]);
        for (int i = 0; i < count; i++)
        {
            int segment = int.Min(i / Steps, segments - 1);
            float t = (i - (segment * Steps)) / (float)Steps;
            ReadOnlySpan<Vector3> p = cubic.AsSpan(4 * segment, 4);
            float s = 1 - t;
            at[i] = (s * s * s * p[0]) + (3 * s * s * t * p[1]) + (3 * s * t * t * p[2]) + (t * t * t * p[3]);
            Vector3 direction = ((s * s * (p[1] - p[0])) + (2 * s * t * (p[2] - p[1])) + (t * t * (p[3] - p[2]))).Unit();

            // Where control points meet, as before, or from end to end.
            along[i] = direction.IsFinite() ? direction : i > 0 ? along[i - 1] : (p[3] - p[0]).Unit() is var chord && chord.IsFinite() ? chord : Vector3.UnitZ;
        }

        return (at, along);
    }

    private static MeshDescription Tube(Vector3[] at, Vector3[] along, Vector2 widths)
    {
        // A direction across that turns no more than it must.
        Vector3[] side = new Vector3[at.Length];
        for (int i = 0; i < at.Length; i++)
        {
            Vector3 before = i > 0 ? side[i - 1] : along[0].Cross(float.Abs(along[0].X) < 0.5f ? Vector3.UnitX : Vector3.UnitY).Unit();
            side[i] = (before - (along[i] * along[i].Dot(before))).Unit();
            side[i] = side[i].IsFinite() ? side[i] : before;
        }

        return GridMesh.Create(at.Length - 1, Sides, (u, v) =>
        {
            int i = (int)float.Round(u * (at.Length - 1));
            LaneMath.SinCosTurn(v, out float sin, out float cos);
            Vector3 normal = (side[i] * cos) - (along[i].Cross(side[i]) * sin);
            return (at[i] + (normal * (0.5f * Wider * Width(widths, u))), normal);
        });
    }

    private static MeshDescription Band(Vector3[] at, Vector3[] along, Vector3[] normals, Vector2 widths) => GridMesh.Create(at.Length - 1, 1, (u, v) =>
    {
        int i = (int)float.Round(u * (at.Length - 1));
        int segment = int.Min(i / Steps, normals.Length - 2);
        Vector3 normal = Turned(normals[segment].Unit(), normals[segment + 1].Unit(), (i - (segment * Steps)) / (float)Steps);
        normal = (normal - (along[i] * along[i].Dot(normal))).Unit();
        normal = normal.IsFinite() ? normal : along[i].Cross(float.Abs(along[i].X) < 0.5f ? Vector3.UnitX : Vector3.UnitY).Unit();
        return (at[i] + (normal.Cross(along[i]) * ((v - 0.5f) * Width(widths, u))), normal);
    });

    private static float Width(Vector2 widths, float u) => widths.X + (u * (widths.Y - widths.X));

    // On the shorter way, at constant speed.
    private static Vector3 Turned(Vector3 from, Vector3 to, float t)
    {
        float angle = LaneMath.Atan2(from.Cross(to).Norm(), from.Dot(to));
        LaneMath.SinCos(t * angle, out float sin, out float cos);
        Vector3 across = (to - (from * from.Dot(to))).Unit();
        return across.IsFinite() ? (from * cos) + (across * sin) : from;
    }
}
