using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textbook;
using Bounds = RayTracer.Numerics.Bounds;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.Adapters;

/// <summary>
/// Describes a shape whose class is the textbook edition's <see cref="IShape"/>. It renders in both editions: in the fast one lane by lane, at the speed
/// of its class.
/// </summary>
public abstract record TextbookShapeDescription : ShapeDescription, IOwnShape
{
    /// <inheritdoc/>
    public abstract IShape Make();

    /// <inheritdoc/>
    public sealed override Shape? Build(SceneBuilder builder)
    {
        IShape shape = Make();
        bool isEven = new[] { 0.1, 0.4, 0.7 }.SelectMany(_ => new[] { 0.2, 0.8 }, (u, v) => (u, v)).All(r => double.IsInfinity(shape.Area) || Math.Abs((shape.PointAt(r).Pdf * shape.Area) - 1) < 1e-3);
        if (!isEven && Material is LuminaireMaterialDescription)
        {
            builder.Error(this, nameof(Material), "the fast edition's lamps have uniform points, and those of this shape are not: the pdf of PointAt must be one over the area");
        }

        return new TextbookShape(builder.Material(Material), Name, shape);
    }
}

/// <summary>A shape of the textbook edition in the fast one.</summary>
/// <param name="material">The surface's material.</param>
/// <param name="name">A name for messages; may be empty.</param>
/// <param name="shape">The shape.</param>
internal sealed class TextbookShape(Material material, string name, IShape shape) : Shape(material, name)
{
    /// <summary>The textbook edition's shape.</summary>
    public IShape Inner => shape;

    /// <inheritdoc/>
    public override Bounds Bounds { get; } = new(Single(shape.Bounds.Low, -1), Single(shape.Bounds.High, 1));

    /// <inheritdoc/>
    public override float Area => (float)shape.Area;

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new TextbookShapeBatch(shapes);

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Points(u, v, out Vec3W point, out Vec3W normal, out FloatW pointU, out FloatW pointV);
        AreaSample.Sample(point - from, normal, Area, out sample);
        (sample.U, sample.V) = (pointU, pointV);
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        point = default;
        if (double.IsFinite(shape.Area))
        {
            Points(u, v, out point, out _, out _, out _);
        }

        return double.IsFinite(shape.Area);
    }

    private void Points(in FloatW u, in FloatW v, out Vec3W point, out Vec3W normal, out FloatW pointU, out FloatW pointV)
    {
        Lanes points = new(stackalloc float[Lanes.Floats]);
        Lanes normals = new(stackalloc float[Lanes.Floats]);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            SurfacePoint chosen = shape.PointAt((u[lane], v[lane]));
            points.Set(lane, chosen.Point, new(chosen.U, chosen.V, 0));
            normals.Set(lane, chosen.Normal, default);
        }

        (point, normal, pointU, pointV) = (points.Direction, normals.Direction, points.Color.R, points.Color.G);
    }

    // Rounded away from the middle.
    private static Vector3 Single(Vector v, int side)
    {
        float Away(double x) => double.IsInfinity(x) ? (float)x : side < 0 ? MathF.BitDecrement((float)x) : MathF.BitIncrement((float)x);
        return new(Away(v.X), Away(v.Y), Away(v.Z));
    }
}

/// <summary>The textbook edition's shapes of a scene, asked lane by lane.</summary>
internal sealed unsafe class TextbookShapeBatch : ShapeBatch
{
    // A segment that ends on a shape has rounding at its end, by this part of its length.
    private const double EndRounding = 1e-4;
    private readonly IShape[] _shapes;

    // The number of each shape, as the one float that a table of shapes holds for each.
    private readonly float[] _numbers;

    /// <summary>Takes shapes.</summary>
    public TextbookShapeBatch(IReadOnlyList<Shape> shapes) : base(shapes.Count, 1)
    {
        _shapes = [.. shapes.Select(s => ((TextbookShape)s).Inner)];
        _numbers = GC.AllocateArray<float>(shapes.Count, pinned: true);
        for (int i = 0; i < _numbers.Length; i++)
        {
            _numbers[i] = i;
        }
    }

    /// <inheritdoc/>
    public override bool HasShadingNormals => true;

    /// <inheritdoc/>
    public override void ClosestHit(int from, int to, in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive)
    {
        for (int i = from; i < to; i++)
        {
            FloatW t = Meet(_shapes[i], origin, direction, distance);
            MaskW hit = (t > 0f) & (t < distance);
            distance = hit.Select(t, distance);
            primitive = hit.Select((uint)(FirstPrimitive + i), primitive);
        }
    }

    /// <inheritdoc/>
    public override void Occlude(int from, int to, in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        for (int i = from; i < to && free.Any; i++)
        {
            FloatW end = FirstPrimitive + i == skip ? distance * (float)(1 - EndRounding) : distance;
            FloatW t = Meet(_shapes[i], origin, direction, end);
            free = free.Except((t > 0f) & (t < end));
        }
    }

    /// <inheritdoc/>
    public override void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface)
    {
        FloatW numbers = primitives.Read((float*)Marshal.UnsafeAddrOfPinnedArrayElement(_numbers, 0), 0);
        Lanes points = new(stackalloc float[Lanes.Floats]);
        Lanes normals = new(stackalloc float[Lanes.Floats]);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Vector at = Lanes.Vector(surface.Point, lane);
            IShape shape = _shapes[(int)numbers[lane]];
            double scale = Math.Max(at.Largest, shape.Bounds.IsFinite ? shape.Bounds.Size.Largest : 1e-3);
            Hit hit = Found(shape, at, 2e-5 * scale);
            points.Set(lane, hit.Point, new(hit.U, hit.V, scale * RayOffset.Relative));
            normals.Set(lane, hit.Normal, new(hit.Shading.X, hit.Shading.Y, hit.Shading.Z));
        }

        (surface.Point, surface.Normal) = (points.Direction, normals.Direction);
        (surface.U, surface.V, surface.Offset) = (points.Color.R, points.Color.G, points.Color.B);
        surface.Shading = new(normals.Color.R, normals.Color.G, normals.Color.B);
    }

    /// <inheritdoc/>
    public override void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface) => surface.AlongU = surface.AlongV = default;

    // Infinity where nothing nearer than the end is met.
    private static FloatW Meet(IShape shape, in Vec3W origin, in Vec3W direction, in FloatW end)
    {
        Span<float> found = stackalloc float[FloatW.Count];
        for (int lane = 0; lane < found.Length; lane++)
        {
            Hit hit = Hit.None(end[lane]);
            found[lane] = end[lane] > 0 && shape.Intersect(new(Lanes.Vector(origin, lane), Lanes.Vector(direction, lane)), ref hit)
                ? (float)hit.Distance : float.PositiveInfinity;
        }

        return new(new Vector<float>(found));
    }

    // The hit at a point that was found in single precision: of short rays to it from six sides, that which meets the surface nearest to it. The ray
    // that found it is not known where the shape is shown by an instance.
    private static Hit Found(IShape shape, Vector at, double reach)
    {
        Hit best = new() { Point = at, Normal = new(0, 0, 1), Shading = new(0, 0, 1) };
        double nearest = double.PositiveInfinity;
        for (int side = 0; side < 6; side++)
        {
            double sign = side < 3 ? 1 : -1;
            Vector direction = new(side % 3 == 0 ? sign : 0, side % 3 == 1 ? sign : 0, side % 3 == 2 ? sign : 0);
            Textbook.Ray ray = new(at - (reach * direction), direction);
            Hit hit = Hit.None(2 * reach);
            if (shape.Intersect(ray, ref hit) && Math.Abs(hit.Distance - reach) < nearest)
            {
                nearest = Math.Abs(hit.Distance - reach);
                shape.Describe(ray, ref hit);
                best = hit;
            }
        }

        return best;
    }
}
