namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// A thin lens by similar triangles: what the documentation of the camera says, in double precision. All points of the picture
/// are in pixels from its upper left corner.
/// </summary>
internal sealed class LensModel
{
    private readonly Vec3D _eye;
    private readonly Vec3D _forward;
    private readonly Vec3D _right;
    private readonly Vec3D _up;
    private readonly double _focus;
    private readonly double _pixel;
    private readonly int _width;
    private readonly int _height;

    /// <param name="eye">The position of the eye.</param>
    /// <param name="lookAt">The point in the middle of the picture.</param>
    /// <param name="up">What is up in the picture.</param>
    /// <param name="degrees">Full angle of the field of view.</param>
    /// <param name="extent">The number of pixels that the angle spans.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    /// <param name="focus">Distance of the plane in focus.</param>
    public LensModel(Vec3D eye, Vec3D lookAt, Vec3D up, double degrees, int extent, int width, int height, double focus = 1)
    {
        _eye = eye;
        _forward = (lookAt - eye).Unit;
        _right = _forward.Cross(up).Unit;
        _up = _right.Cross(_forward);
        _focus = focus;
        _pixel = 2 * focus * Math.Tan(degrees * Math.PI / 360) / extent;
        _width = width;
        _height = height;
    }

    /// <summary>Unit vector to the right.</summary>
    public Vec3D Right => _right;

    /// <summary>Unit vector upwards.</summary>
    public Vec3D Up => _up;

    /// <summary>The point at a depth that a pinhole shows at a place in the picture.</summary>
    public Vec3D PointAt(double x, double y, double depth) => _eye + (Direction(x, y) * (depth / _focus));

    /// <summary>Where the ray of a pinhole meets the plane y = 0.</summary>
    public Vec3D Floor(double x, double y)
    {
        Vec3D direction = Direction(x, y);
        return _eye - (direction * (_eye.Y / direction.Y));
    }

    /// <summary>Where the picture shows a point as seen from the eye moved by a shift, while the plane in focus stays.</summary>
    public (double X, double Y) Project(Vec3D point, Vec3D shift = default)
    {
        Vec3D to = point - _eye - shift;
        Vec3D inFocus = shift + (to * ((_focus - shift.Dot(_forward)) / to.Dot(_forward)));
        return ((inFocus.Dot(_right) / _pixel) + (0.5 * _width), (0.5 * _height) - (inFocus.Dot(_up) / _pixel));
    }

    private Vec3D Direction(double x, double y) =>
        (_forward * _focus) + (_right * ((x - (0.5 * _width)) * _pixel)) + (_up * (((0.5 * _height) - y) * _pixel));
}
