using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Meets tori with rays. In the local frame, with ring radius R and tube radius r, the surface is (|p|² + R² − r²)² − 4R²(x² + y²) = 0, negative
/// inside. Along the ray, counted from its point nearest to the centre, that is a quartic without cubic term. It is solved in double precision, so that
/// only the rounding of the distance itself is left of its error, even where the tube is a thousand times thinner than the ring.
/// </summary>
internal readonly unsafe struct TorusKernel : IShapeKernel
{
    private const int Ring = 12;
    private const int Tube = 13;
    private const int Offset = 14;

    // Just beyond the surface, so that rays begin and end outside of it.
    private const float Reach = 1.01f;

    public static int Constants => 15;

    public static void Pack(Shape shape, float* entry)
    {
        var torus = (Torus)shape;
        torus.Frame.Write(entry);
        entry[Ring] = torus.Radius;
        entry[Tube] = torus.TubeRadius;
        entry[Offset] = (Vector3.Abs(torus.Center).Largest() + torus.Radius + torus.TubeRadius) * RayOffset.Relative;
    }

    public static FloatW Meet(float* q, in Vec3W origin, in Vec3W direction) => Cross(q, origin, direction, onlyOutwards: false);

    public static MaskW HidesItself(float* q, in Vec3W origin, in Vec3W direction, in FloatW distance)
    {
        // Where the segment ends, it enters. If it went through another part before, it left that part.
        FloatW t = Cross(q, origin, direction, onlyOutwards: true);
        return (t > 0f) & (t < distance);
    }

    public static void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface)
    {
        LocalFrameW frame = new(primitives, table);
        Vec3W p = frame.PointToLocal(surface.Point);
        FloatW ring = primitives.Read(table, Ring);
        FloatW tube = primitives.Read(table, Tube);

        // The tube's circle through the point: from its middle outwards and upwards.
        FloatW distance = FloatW.Sqrt(FloatW.MultiplyAdd(p.X, p.X, p.Y * p.Y));
        FloatW inverse = 1f / distance;
        FloatW outward = distance - ring;
        FloatW inverseTube = 1f / FloatW.Sqrt(FloatW.MultiplyAdd(outward, outward, p.Z * p.Z));
        FloatW x = p.X * inverse;
        FloatW y = p.Y * inverse;
        FloatW z = p.Z * inverseTube;
        outward *= inverseTube;
        FloatW radius = FloatW.MultiplyAdd(outward, tube, ring);
        surface.Point = frame.PointToWorld(new(x * radius, y * radius, z * tube));
        surface.Normal = frame.ToWorld(new(x * outward, y * outward, z));
        surface.Offset = primitives.Read(table, Offset);
        if (needsUv)
        {
            surface.U = LocalFrame.Turn(new(x, y, 0f));
            surface.V = LocalFrame.Turn(new(z, outward, 0f));
        }
    }

    /// <inheritdoc/>
    public static void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface)
    {
        LocalFrameW frame = new(primitives, table);
        Vec3W p = frame.PointToLocal(surface.Point);
        Vec3W n = frame.ToLocal(surface.Normal);
        FloatW distance = FloatW.Sqrt(FloatW.MultiplyAdd(p.X, p.X, p.Y * p.Y));
        FloatW outward = FloatW.MultiplyAdd(n.X, p.X, n.Y * p.Y) / distance;
        FloatW inwards = -n.Z / distance;
        surface.AlongU = frame.ToWorld(new Vec3W(p.Y, -p.X, 0f) * (2f * float.Pi));
        surface.AlongV = frame.ToWorld(new Vec3W(p.X * inwards, p.Y * inwards, outward) * (primitives.Read(table, Tube) * (2f * float.Pi)));
    }

    // The first distance above zero at which rays cross the surface.
    private static FloatW Cross(float* q, in Vec3W origin, in Vec3W direction, bool onlyOutwards)
    {
        // Most rays miss the sphere around it.
        Vec3W o = origin - new Vec3W(q[0], q[1], q[2]);
        FloatW along = Vec3W.Dot(o, direction);
        Vec3W perpendicular = Vec3W.NegatedMultiplyAdd(direction, along, o);
        float reach = (q[Ring] + q[Tube]) * Reach;
        if (!((Vec3W.Dot(perpendicular, perpendicular) < reach * reach) & (along < reach)).Any)
        {
            return float.NaN;
        }

        Vector<double> low = Cross(q, DoublesOf(origin, lower: true), DoublesOf(direction, lower: true), onlyOutwards);
        Vector<double> high = Cross(q, DoublesOf(origin, lower: false), DoublesOf(direction, lower: false), onlyOutwards);
        return new(Vector.Narrow(low, high));
    }

    private static Vector<double> Cross(float* q, in DoubleVector origin, in DoubleVector direction, bool onlyOutwards)
    {
        DoubleVector from = new(origin.X - Constant(q[0]), origin.Y - Constant(q[1]), origin.Z - Constant(q[2]));
        DoubleVector o = ToLocal(q, from);
        DoubleVector d = ToLocal(q, direction);
        Vector<double> stretch = Vector<double>.One / Vector.SquareRoot(DoubleVector.Dot(d, d));
        d = d.Times(stretch);
        Vector<double> start = DoubleVector.Dot(o, d);
        DoubleVector nearest = new(o.X - (start * d.X), o.Y - (start * d.Y), o.Z - (start * d.Z));

        double ring = q[Ring];
        double reach = (ring + q[Tube]) * Reach;
        Vector<double> squared = DoubleVector.Dot(nearest, nearest);
        Vector<double> end = Vector.SquareRoot(Vector.Max(new Vector<double>(reach * reach) - squared, Vector<double>.Zero));
        Vector<double> begin = Vector.Max(start, -end);

        Vector<double> four = new(4 * ring * ring);
        Vector<double> g = squared + new Vector<double>((ring - q[Tube]) * (ring + q[Tube]));
        DepressedQuartic quartic = new(
            g + g - (four * ((d.X * d.X) + (d.Y * d.Y))),
            -(four + four) * ((nearest.X * d.X) + (nearest.Y * d.Y)),
            (g * g) - (four * ((nearest.X * nearest.X) + (nearest.Y * nearest.Y))));
        return (quartic.FirstCrossing(begin, Vector.Max(begin, end), onlyOutwards) - start) * stretch;
    }

    private static DoubleVector ToLocal(float* q, in DoubleVector v) => new(
        DoubleVector.Dot(v, new(Constant(q[3]), Constant(q[4]), Constant(q[5]))),
        DoubleVector.Dot(v, new(Constant(q[6]), Constant(q[7]), Constant(q[8]))),
        DoubleVector.Dot(v, new(Constant(q[9]), Constant(q[10]), Constant(q[11]))));

    private static Vector<double> Constant(float f) => new(f);

    private static DoubleVector DoublesOf(in Vec3W v, bool lower) => lower
        ? new(Vector.WidenLower(v.X.V), Vector.WidenLower(v.Y.V), Vector.WidenLower(v.Z.V))
        : new(Vector.WidenUpper(v.X.V), Vector.WidenUpper(v.Y.V), Vector.WidenUpper(v.Z.V));

    private readonly struct DoubleVector(Vector<double> x, Vector<double> y, Vector<double> z)
    {
        public readonly Vector<double> X = x, Y = y, Z = z;

        public static Vector<double> Dot(in DoubleVector a, in DoubleVector b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

        public DoubleVector Times(Vector<double> s) => new(X * s, Y * s, Z * s);
    }
}
