using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Tests.Shapes;

/// <summary>
/// Boxes (askew, too), cylinders, cones and tori in double precision, known only by how far a point is from them: rays meet them by walking as far as that is
/// safe (Hart 1996), which shares nothing with the program's roots.
/// </summary>
/// <param name="shape">The shape.</param>
internal sealed class SolidReference(Shape shape)
{
    private readonly (Double3 Center, Double3 Axis, double Half) _axis = AxisOf(shape);

    /// <summary>Whether the surface is closed.</summary>
    public bool IsClosed => shape is not ConicalShape { HasCaps: false };

    /// <summary>Distance from the solid (with its caps, if it has none), negative inside.</summary>
    public double Signed(Double3 p)
    {
        if (shape is Box or TurnedBox)
        {
            (double x, double y, double z) = Beyond(p);
            double outside = new Double3(Math.Max(x, 0), Math.Max(y, 0), Math.Max(z, 0)).Length;
            return outside > 0 ? outside : Math.Max(x, Math.Max(y, z));
        }

        (double distance, double height) = Cylindrical(p);
        if (shape is Torus torus)
        {
            return double.Hypot(distance - torus.Radius, height) - torus.TubeRadius;
        }

        var s = (ConicalShape)shape;
        double nearest = Math.Min(ToSide(p), Math.Min(
            ToSegment(distance, height, 0, -_axis.Half, s.Radius, -_axis.Half),
            ToSegment(distance, height, 0, _axis.Half, s.TopRadius, _axis.Half)));
        return Math.Abs(height) < _axis.Half && ToCone(p) < 0 ? -nearest : nearest;
    }

    /// <summary>Distance from the whole surface of which the shape is a part, and how far beyond its rims (negative within).</summary>
    public (double Off, double Outside) Measure(Double3 p)
    {
        if (IsClosed)
        {
            return (Signed(p), double.NegativeInfinity);
        }

        var s = (ConicalShape)shape;
        double slope = (s.TopRadius - s.Radius) / (2 * _axis.Half);
        double off = ToCone(p);
        double foot = Cylindrical(p).Height + (off * slope / Math.Sqrt(1 + (slope * slope)));
        return (off, (Math.Abs(foot) - _axis.Half) * Math.Sqrt(1 + (slope * slope)));
    }

    /// <summary>Whether a point of the surface lies next to an edge, or where the surface is too narrow to tell its uv.</summary>
    public bool IsNearEdge(Double3 p, double margin)
    {
        if (shape is Box or TurnedBox)
        {
            (double x, double y, double z) = Beyond(p);
            return new[] { x, y, z }.Count(d => Math.Abs(d) < margin) > 1;
        }

        (double distance, double height) = Cylindrical(p);
        return shape is ConicalShape && (distance < 50 * margin || (Math.Abs(ToCone(p)) < margin && Math.Abs(Math.Abs(height) - _axis.Half) < margin));
    }

    /// <summary>
    /// The nearest hit of a ray (infinite for none), the cosine there, and how far beyond the rims it is. Where the ray comes nearer than a margin to the
    /// surface or goes no deeper, the cosine is 0.
    /// </summary>
    public (double Distance, double Cosine, double Outside) Meet(Double3 origin, Double3 direction, double reach, double margin)
    {
        double t = Walk(origin, direction, 0, reach, margin, out double closest);
        if (double.IsInfinity(t))
        {
            return (t, closest < margin ? 0 : 1, Measure(origin).Outside);
        }

        // Behind the surface there must be some depth.
        double behind = Walk(origin, direction, t + margin, reach, margin, out _);
        double last = double.IsInfinity(behind) ? t + (10 * margin) : behind;
        double depth = Enumerable.Range(1, 9).Select(i => origin + (direction * (t + ((last - t) * i / 10)))).Max(p => IsClosed ? -Signed(p) : ToSide(p));
        Double3 p = origin + (direction * t);
        double step = margin / 8;
        double cosine = Math.Abs(Signed(p + (direction * step)) - Signed(p + (direction * -step))) / (2 * step);
        return (t, depth < margin || closest < margin ? 0 : IsClosed ? cosine : OpenCosine(p, direction, step), Measure(p).Outside);
    }

    private double OpenCosine(Double3 p, Double3 direction, double step) =>
        Math.Abs(ToCone(p + (direction * step)) - ToCone(p + (direction * -step))) / (2 * step);

    private double Walk(Double3 origin, Double3 direction, double from, double reach, double margin, out double closest)
    {
        closest = double.PositiveInfinity;
        double t = from;
        double before = double.PositiveInfinity;
        for (int step = 0; t < 20 * reach; step++)
        {
            double distance = Near(origin + (direction * t));
            if (distance < 1e-6 * margin)
            {
                return t;
            }

            // What was the nearest is known when it grows again.
            closest = distance > before ? Math.Min(closest, before) : closest;
            before = distance;
            if (step > 2000)
            {
                closest = 0;
                break;
            }

            t += distance;
        }

        return double.PositiveInfinity;
    }

    private double Near(Double3 p) => IsClosed ? Math.Abs(Signed(p)) : ToSide(p);

    private double ToSide(Double3 p)
    {
        (double distance, double height) = Cylindrical(p);
        var s = (ConicalShape)shape;
        return ToSegment(distance, height, s.Radius, -_axis.Half, s.TopRadius, _axis.Half);
    }

    private double ToCone(Double3 p)
    {
        (double distance, double height) = Cylindrical(p);
        var s = (ConicalShape)shape;
        double slope = (s.TopRadius - (double)s.Radius) / (2 * _axis.Half);
        return (distance - (0.5 * ((double)s.Radius + s.TopRadius)) - (slope * height)) / Math.Sqrt(1 + (slope * slope));
    }

    private (double Distance, double Height) Cylindrical(Double3 p)
    {
        Double3 v = p - _axis.Center;
        double height = Double3.Dot(v, _axis.Axis);
        return ((v - (_axis.Axis * height)).Length, height);
    }

    private (double X, double Y, double Z) Beyond(Double3 p)
    {
        if (shape is TurnedBox box)
        {
            Double3 v = p - new Double3(box.Center);
            return (Along(box.Axes.X) - box.Half.X, Along(box.Axes.Y) - box.Half.Y, Along(box.Axes.Z) - box.Half.Z);

            double Along(Vector3 axis) => Math.Abs(Double3.Dot(v, new Double3(axis).Unit));
        }

        Bounds b = shape.Bounds;
        return (Math.Max(b.Minimum.X - p.X, p.X - b.Maximum.X), Math.Max(b.Minimum.Y - p.Y, p.Y - b.Maximum.Y), Math.Max(b.Minimum.Z - p.Z, p.Z - b.Maximum.Z));
    }

    private static double ToSegment(double x, double y, double ax, double ay, double bx, double by)
    {
        (double dx, double dy) = (bx - ax, by - ay);
        double part = Math.Clamp((((x - ax) * dx) + ((y - ay) * dy)) / ((dx * dx) + (dy * dy) + 1e-300), 0, 1);
        return double.Hypot(x - ax - (part * dx), y - ay - (part * dy));
    }

    private static (Double3 Center, Double3 Axis, double Half) AxisOf(Shape shape)
    {
        switch (shape)
        {
            case ConicalShape s:
                Double3 along = new Double3(s.Top) - s.Bottom;
                return ((new Double3(s.Bottom) * 0.5) + (new Double3(s.Top) * 0.5), along.Unit, along.Length / 2);
            case Torus t:
                return (new(t.Center), new Double3(t.Axis).Unit, 0);
            default:
                return default;
        }
    }
}
