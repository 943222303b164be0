using System.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Tests.Statistics;

/// <summary>
/// The surface of a light as maps from unit squares, one a smooth part: what its samples are compared with. The parts are those that are
/// sampled for a lit point: all that may face it.
/// </summary>
internal sealed class LightSurface
{
    private readonly Part[] _parts;
    private readonly Vector3D _from;
    private readonly Lazy<(double SolidAngle, Vector3D Irradiance)> _sums;

    public LightSurface(Shape shape, Vector3D from)
    {
        _from = from;
        _parts = [.. Parts(shape, from)];
        Area = _parts.Sum(p => p.Area);
        _sums = new(Sum);
    }

    /// <summary>The area that points are chosen from.</summary>
    public double Area { get; }

    /// <summary>The solid angle of all that faces the lit point, also of what hides behind other parts.</summary>
    public double SolidAngle => _sums.Value.SolidAngle;

    /// <summary>The integral of the direction over that solid angle.</summary>
    public Vector3D VectorIrradiance => _sums.Value.Irradiance;

    /// <summary>Outward unit normal at a point.</summary>
    public Vector3D NormalAt(Vector3D p) => PartOf(p).Normal(p);

    /// <summary>Surface coordinates of a point, as the scene format defines them.</summary>
    public (double U, double V) UvOf(Vector3D p) => PartOf(p).Uv(p);

    /// <summary>Where a point lies in the unit square from which the surface is sampled: its own square's area, next to those of the parts before.</summary>
    public (double S, double T) SquareOf(Vector3D p)
    {
        Part part = PartOf(p);
        double before = _parts.TakeWhile(q => q != part).Sum(q => q.Area);
        (double s, double t) = part.Square(p);
        return (s, (before + (t * part.Area)) / Area);
    }

    private Part PartOf(Vector3D p) => _parts.MinBy(q => Math.Abs(q.Off(p)))!;

    // By the midpoint rule, which for a facet's share of the solid angle is wrong by its size squared.
    private (double SolidAngle, Vector3D Irradiance) Sum()
    {
        const int side = 320;
        double angle = 0;
        Vector3D irradiance = default;
        foreach (Part part in _parts)
        {
            for (int i = 0; i < side * side; i++)
            {
                Vector3D p = part.Point(((i % side) + 0.5) / side, ((i / side) + 0.5) / side);
                Vector3D to = p - _from;
                double share = -part.Normal(p).Dot(to) / (to.Squared * to.Length) * part.Area / (side * side);
                if (share > 0)
                {
                    angle += share;
                    irradiance += to.Unit * share;
                }
            }
        }

        return (angle, irradiance);
    }

    private static IEnumerable<Part> Parts(Shape shape, Vector3D from)
    {
        switch (shape)
        {
            case Disk d:
                return [Cap(d.Center, d.Normal, d.Tangent, d.Bitangent, d.Radius, isConcentric: true)];
            case Rectangle r:
                return [Face(r.Corner, r.EdgeU, r.EdgeV)];
            case Box b:
                Vector3D size = (Vector3D)b.Bounds.Maximum - b.Bounds.Minimum;
                return BoxFaces(b.Bounds.Minimum, new(size.X, 0, 0), new(0, size.Y, 0), new(0, 0, size.Z)).Where(f => f.Off(from) > 0);
            case TurnedBox t:
                (Vector3D x, Vector3D y, Vector3D z) = ((Vector3D)t.Axes.X * (2 * t.Half.X), (Vector3D)t.Axes.Y * (2 * t.Half.Y), (Vector3D)t.Axes.Z * (2 * t.Half.Z));
                return BoxFaces((Vector3D)t.Center - ((x + y + z) * 0.5), x, y, z).Where(f => f.Off(from) > 0);
            case ConicalShape s:
                return Conical(s).Where((part, i) => i == 0 || part.Off(from) > 0);
            default:
                return [Tube((Torus)shape)];
        }
    }

    private static Part Face(Vector3D corner, Vector3D u, Vector3D v)
    {
        Vector3D n = u.Cross(v);
        (double, double) At(Vector3D p) => ((p - corner).Cross(v).Dot(n) / n.Squared, u.Cross(p - corner).Dot(n) / n.Squared);
        return new(n.Length, (s, t) => corner + (u * s) + (v * t), _ => n.Unit, p => (p - corner).Dot(n.Unit), At, At);
    }

    // x, y, z in this order; each face's first edge is the one that u is chosen along.
    private static IEnumerable<Part> BoxFaces(Vector3D low, Vector3D x, Vector3D y, Vector3D z)
    {
        Vector3D high = low + x + y + z;
        (Part Face, Vector3D Across, Vector3D Along)[] faces =
        [
            (Face(high - y, -z, y), y, z), (Face(low, z, y), y, z), (Face(low + y + z, x, -z), x, z),
            (Face(low + x + z, -x, -z), x, z), (Face(low + z, x, y), x, y), (Face(low + x, -x, y), x, y),
        ];

        // The coordinate that chooses the face goes on along the first of its axes.
        return faces.Select(f => f.Face with
        {
            Square = p => ((p - low).Dot(f.Along) / f.Along.Squared, (p - low).Dot(f.Across) / f.Across.Squared),
        });
    }

    private static Part Cap(Vector3D center, Vector3D normal, Vector3D u, Vector3D v, double radius, bool isConcentric)
    {
        (double, double) At(Vector3D p) => (0.5 + ((p - center).Dot(u) / radius / 2), 0.5 + ((p - center).Dot(v) / radius / 2));
        Vector3D Polar(double s, double t) => center + (u * (radius * Math.Sqrt(t) * Math.Cos(2 * Math.PI * s))) + (v * (radius * Math.Sqrt(t) * Math.Sin(2 * Math.PI * s)));
        double Turn(Vector3D p) => Math.Atan2((p - center).Dot(v), (p - center).Dot(u)) / (2 * Math.PI);
        return new(Math.PI * radius * radius, Polar, _ => normal.Unit, p => (p - center).Dot(normal.Unit), p =>
            isConcentric ? (Turn(p) + (Turn(p) < 0 ? 1 : 0), (p - center).Squared / (radius * radius)) : default, At);
    }

    private static (Vector3D Right, Vector3D Front) Frame(Vector3D axis)
    {
        Vector3D right = axis.Cross(new(0, 0, 1)).Unit;
        return (right, right.Cross(axis));
    }

    private static IEnumerable<Part> Conical(ConicalShape s)
    {
        (Vector3D bottom, Vector3D top) = (s.Bottom, s.Top);
        Vector3D axis = (top - bottom).Unit;
        (Vector3D right, Vector3D front) = Frame(axis);
        double height = (top - bottom).Length;
        (double r0, double r1) = (s.Radius, s.TopRadius);
        double slant = double.Hypot(height, r1 - r0);
        double Along(Vector3D p) => (p - bottom).Dot(axis) / height;
        double Turn(Vector3D p) => 0.5 + (Math.Atan2((p - bottom).Dot(right), (p - bottom).Dot(front)) / (2 * Math.PI));
        double Radius(double part) => r0 + (part * (r1 - r0));
        Vector3D Ring(double turn) => (right * -Math.Sin(2 * Math.PI * turn)) - (front * Math.Cos(2 * Math.PI * turn));
        Vector3D Point(double u, double t)
        {
            double part = t * (r0 + r1) / (r0 + Math.Sqrt((r0 * r0) + (t * ((r1 * r1) - (r0 * r0)))));
            return bottom + (axis * (part * height)) + (Ring(u) * Radius(part));
        }

        double Off(Vector3D p) => ((p - bottom - (axis * (Along(p) * height))).Length - Radius(Along(p))) * height / slant;
        double Below(double part) => part * (r0 + Radius(part)) / (r0 + r1);
        yield return new(Math.PI * (r0 + r1) * slant, Point, p => (Ring(Turn(p)) * (height / slant)) + (axis * ((r0 - r1) / slant)), Off,
            p => (Turn(p), Below(Along(p))), p => (Turn(p), Along(p)));
        if (s.HasCaps)
        {
            (double, double) Square(Vector3D p, Vector3D center, double radius) => (Turn(p), (p - center).Squared / (radius * radius));
            yield return Cap(top, axis, right, -front, r1, false) with { Square = p => Square(p, top, r1) };
            yield return Cap(bottom, -axis, -right, -front, r0, false) with { Square = p => Square(p, bottom, r0) };
        }
    }

    private static Part Tube(Torus torus)
    {
        Vector3D axis = ((Vector3D)torus.Axis).Unit;
        (Vector3D right, Vector3D front) = Frame(axis);
        Vector3D center = torus.Center;
        (double ring, double tube) = (torus.Radius, torus.TubeRadius);
        double Turn(Vector3D p) => 0.5 + (Math.Atan2((p - center).Dot(right), (p - center).Dot(front)) / (2 * Math.PI));
        Vector3D Ring(double turn) => (right * -Math.Sin(2 * Math.PI * turn)) - (front * Math.Cos(2 * Math.PI * turn));
        Vector3D Middle(Vector3D p) => center + (Ring(Turn(p)) * ring);
        double TubeTurn(Vector3D p) => 0.5 + (Math.Atan2((p - center).Dot(axis), (p - center).Dot(Ring(Turn(p))) - ring) / (2 * Math.PI));
        double Below(double turn) => turn - (tube / ring * Math.Sin(2 * Math.PI * turn) / (2 * Math.PI));

        // The turn below which a part of the area lies, by bisection.
        double Above(double part)
        {
            (double low, double high) = (0, 1);
            for (int i = 0; i < 40; i++)
            {
                double middle = (low + high) / 2;
                (low, high) = Below(middle) < part ? (middle, high) : (low, middle);
            }

            return low;
        }

        Vector3D Point(double u, double t)
        {
            double turn = 2 * Math.PI * Above(t);
            return center + (Ring(u) * (ring - (tube * Math.Cos(turn)))) - (axis * (tube * Math.Sin(turn)));
        }

        return new(4 * Math.PI * Math.PI * ring * tube, Point, p => (p - Middle(p)).Unit, p => (p - Middle(p)).Length - tube,
            p => (Turn(p), Below(TubeTurn(p))), p => (Turn(p), TubeTurn(p)));
    }

    /// <summary>One smooth part.</summary>
    /// <param name="Area">Its area.</param>
    /// <param name="Point">The point of a place in the unit square; equal areas of the square have equal areas here.</param>
    /// <param name="Normal">Outward unit normal at a point.</param>
    /// <param name="Off">How far outside of the part's whole surface a point lies.</param>
    /// <param name="Square">Where a point lies in the square that samples come from.</param>
    /// <param name="Uv">Surface coordinates of a point.</param>
    private sealed record Part(
        double Area, Func<double, double, Vector3D> Point, Func<Vector3D, Vector3D> Normal, Func<Vector3D, double> Off,
        Func<Vector3D, (double S, double T)> Square, Func<Vector3D, (double U, double V)> Uv);
}
