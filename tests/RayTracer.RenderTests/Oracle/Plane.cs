namespace RayTracer.RenderTests.Oracle;

/// <summary>A plane, or the rectangle of a size around its point.</summary>
internal sealed class Plane : Shape
{
    private readonly Vec _point;
    private readonly Vec _normal;
    private readonly Vec _toU;
    private readonly Vec _toV;
    private readonly (double U, double V)? _size;

    public Plane(Material material, Vec point, Vec normal, (double U, double V)? size)
        : base(material)
    {
        _point = point;
        _normal = normal.Unit;
        _size = size;

        // u runs to the right for whoever looks at the front with y up; on floors and ceilings, with −z up.
        bool isLevel = Math.Abs(_normal.Y) > 1 - 5e-7;
        _toU = Vec.Cross(isLevel ? new(0, 0, -1) : new(0, 1, 0), _normal).Unit;
        _toV = Vec.Cross(_normal, _toU);
    }

    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        double t = Vec.Dot(_point - origin, _normal) / Vec.Dot(direction, _normal);
        if (!(t > tMin && t < tMax))
        {
            return double.NaN;
        }

        (double u, double v) = Uv(origin + (t * direction));
        return _size is null || (u is >= 0 and <= 1 && v is >= 0 and <= 1) ? t : double.NaN;
    }

    public override Vec Normal(Vec point) => _normal;

    public override (double U, double V) Uv(Vec point)
    {
        double u = Vec.Dot(point - _point, _toU);
        double v = Vec.Dot(point - _point, _toV);
        return _size is { } size ? (0.5 + (u / size.U), 0.5 + (v / size.V)) : (u, v);
    }

    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        (double width, double height) = _size!.Value;
        return (_point + (width * random.Centred() * _toU) + (height * random.Centred() * _toV), width * height);
    }
}
