using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.SamplePlugin;

/// <summary>Describes a <see cref="Ball"/>.</summary>
[SceneType("ball", "A ball around a point.")]
public sealed record BallDescription : ShapeDescription
{
    /// <summary>Its middle.</summary>
    [Parameter("Its middle.", Unit = "scene units")]
    public Vector3 Center { get; init; }

    /// <summary>From the middle to the surface.</summary>
    [Parameter("From the middle to the surface.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Size { get; init; } = 1;

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder) => new Ball(builder.Material(Material), Name, Center, Size);
}

/// <summary>A ball, which cannot be a lamp: it has no way to choose points.</summary>
public sealed class Ball(Material material, string name, Vector3 middle, float size) : Shape(material, name)
{
    internal Vector3 Middle => middle;

    internal float Size => size;

    /// <inheritdoc/>
    public override Bounds Bounds => new(middle - new Vector3(size), middle + new Vector3(size));

    /// <inheritdoc/>
    public override float Area => 4 * float.Pi * size * size;

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new KernelBatch<BallKernel>(shapes);

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample) => sample = default;
}

/// <summary>Meets balls with rays: an entry is the middle and the radius.</summary>
internal readonly unsafe struct BallKernel : IShapeKernel
{
    /// <inheritdoc/>
    public static int Constants => 4;

    /// <inheritdoc/>
    public static void Pack(Shape shape, float* entry)
    {
        Ball ball = (Ball)shape;
        (entry[0], entry[1], entry[2], entry[3]) = (ball.Middle.X, ball.Middle.Y, ball.Middle.Z, ball.Size);
    }

    /// <inheritdoc/>
    public static FloatW Meet(float* q, in Vec3W origin, in Vec3W direction)
    {
        Vec3W from = new Vec3W(q[0], q[1], q[2]) - origin;
        FloatW along = Vec3W.Dot(from, direction);
        Vec3W across = from - (direction * along);
        FloatW half = FloatW.Sqrt((q[3] * q[3]) - Vec3W.Dot(across, across));
        return (along - half > 0f).Select(along - half, along + half);
    }

    /// <inheritdoc/>
    public static void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface)
    {
        Vec3W middle = primitives.ReadVector(table, 0);
        FloatW size = primitives.Read(table, 3);
        surface.Normal = Vec3W.Normalize(surface.Point - middle);
        surface.Point = middle + (surface.Normal * size);
        surface.Offset = (FloatW.Abs(middle.X) + FloatW.Abs(middle.Y) + FloatW.Abs(middle.Z) + size) * RayOffset.Relative;
        surface.U = surface.V = 0f;
    }

    /// <inheritdoc/>
    public static void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface) => surface.AlongU = surface.AlongV = default;
}
