using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>A frustum of a cone, with cylinder and cone as its limits.</summary>
internal abstract class ConicalShape : Shape
{
    private readonly float _slant;

    /// <summary>From both ends.</summary>
    private protected ConicalShape(Material material, string name, Vector3 bottom, Vector3 top, float radius, float topRadius, bool caps)
        : base(material, name)
    {
        (Bottom, Top, Radius, TopRadius, HasCaps) = (bottom, top, radius, topRadius, caps);
        Vector3 axis = top - bottom;
        Frame = LocalFrame.FromAxis((0.5f * bottom) + (0.5f * top), axis);
        Height = axis.Norm();
        _slant = new Vector3(Height, radius - topRadius, 0).Norm();
    }

    /// <summary>The middle of the bottom.</summary>
    public Vector3 Bottom { get; }

    /// <summary>The middle of the top.</summary>
    public Vector3 Top { get; }

    /// <summary>The radius of the bottom.</summary>
    public float Radius { get; }

    /// <summary>The radius of the top.</summary>
    public float TopRadius { get; }

    /// <summary>True where the ends are closed.</summary>
    public bool HasCaps { get; }

    /// <inheritdoc/>
    public override float Area => SideArea + (HasCaps ? float.Pi * ((Radius * Radius) + (TopRadius * TopRadius)) : 0);

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            (Vector3 low, Vector3 high) = (Frame.DiskReach(Radius), Frame.DiskReach(TopRadius));
            return new Bounds(Bottom - low, Bottom + low).Union(new(Top - high, Top + high));
        }
    }

    /// <summary>From bottom to top.</summary>
    internal float Height { get; }

    /// <summary>The space of <see cref="ConicalKernel"/>, with its origin in the middle of the axis.</summary>
    internal LocalFrame Frame { get; }

    private float SideArea => float.Pi * (Radius + TopRadius) * _slant;

    /// <summary>True where two points define an axis; where they do not, that is reported as an error.</summary>
    internal static bool HasAxis(SceneBuilder builder, ShapeDescription subject, Vector3 bottom, Vector3 top)
    {
        Vector3 axis = top - bottom;
        bool has = axis.Norm() > 0 && axis.Unit().IsFinite();
        if (!has)
        {
            builder.Error(subject, nameof(Top), "bottom and top must be different points, or there is no axis");
        }

        return has;
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach)
    {
        (Vector3 u, Vector3 v) = WireLines.Across(Top - Bottom);
        Vector3[] sides = [u, v, -u, -v];
        return
        [
            WireLines.Circle(Bottom, u, v, Radius), WireLines.Circle(Top, u, v, TopRadius),
            .. sides.Select(s => new[] { Bottom + (s * Radius), Top + (s * TopRadius) }),
        ];
    }

    /// <inheritdoc/>
    public override void SamplePdf(in Vec3W from, in FloatW distance, in FloatW cosine, out FloatW pdf)
    {
        SeenCap((Vec3W)Frame.Origin - from, out _, out _, out FloatW capArea);
        pdf = AreaSample.Pdf(distance, cosine, capArea + SideArea);
    }

    /// <summary>Uniformly by area over the side and the cap, one at the most, that is seen from the point.</summary>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Vec3W to = (Vec3W)Frame.Origin - from;
        float half = 0.5f * Height;
        SeenCap(to, out MaskW above, out FloatW radius, out FloatW capArea);
        FloatW area = capArea + SideArea;

        // v chooses side or cap, and what is left of it a height or a distance from the axis: both are denser where the circle is longer.
        FloatW rest = v * area;
        MaskW isSide = rest < SideArea;
        FloatW part = FloatW.Min(rest / SideArea, 1f);
        float difference = (TopRadius * TopRadius) - (Radius * Radius);
        FloatW ring = FloatW.Sqrt(FloatW.Max(FloatW.MultiplyAdd(part, difference, Radius * Radius), 0f));
        FloatW along = part * (Radius + TopRadius) / (ring + Radius);
        FloatW capPart = FloatW.Sqrt(FloatW.Max(FloatW.Min((rest - SideArea) / capArea, 1f), 0f));

        LocalFrame.AtTurn(u, out FloatW x, out FloatW y);
        FloatW sign = above.Select(1f, -1f);
        FloatW distance = isSide.Select(ring, capPart * radius);
        Vec3W point = new(x * distance, y * distance, isSide.Select(FloatW.MultiplyAdd(along, Height, -half), sign * half));
        FloatW across = Height / _slant;
        Vec3W normal = new(isSide.Select(x * across, 0f), isSide.Select(y * across, 0f), isSide.Select((Radius - TopRadius) / _slant, sign));
        AreaSample.Sample(to + Frame.ToWorld(point), Frame.ToWorld(normal), area, out sample);
        ConicalKernel.CapUv(x * capPart, y * capPart, sign, out FloatW capU, out FloatW capV);
        sample.U = isSide.Select(u, capU);
        sample.V = isSide.Select(along, capV);
    }

    /// <summary>From below for points of the bottom, and from above for all others.</summary>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        float bottom = HasCaps ? float.Pi * Radius * Radius : 0;
        float top = HasCaps ? float.Pi * TopRadius * TopRadius : 0;
        FloatW rest = v * Area;
        MaskW isBottom = rest >= Area - bottom;
        FloatW part = isBottom.Select((rest - top) * (1 / (Area - top)), rest * (1 / (Area - bottom)));
        Vec3W from = Vec3W.MultiplyAdd(Frame.Axis, isBottom.Select(-Height, Height), Frame.Origin);
        return SampleSeen(from, u, FloatW.Min(part, FloatBits.OneMinusEpsilon), out point);
    }

    // The cap that is seen from a point, if there is one: whether it is the upper one, its radius, and its area.
    private void SeenCap(in Vec3W toOrigin, out MaskW above, out FloatW radius, out FloatW area)
    {
        FloatW height = -Vec3W.Dot(toOrigin, Frame.Axis);
        float half = 0.5f * Height;
        above = HasCaps ? height > half : MaskW.None;
        MaskW below = HasCaps ? height < -half : MaskW.None;
        radius = above.Select(TopRadius, Radius);
        area = (above | below).Select(radius * radius * float.Pi, 0f);
    }
}
