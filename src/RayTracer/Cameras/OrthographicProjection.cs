using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>By parallel rays.</summary>
internal sealed class OrthographicKind() : Projection("orthographic")
{
    /// <inheritdoc/>
    public override bool IsParallel => true;

    /// <inheritdoc/>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => camera.ViewSize / ViewPlane.Extent(camera.FieldOfViewAxis, aspect, 1);

    /// <inheritdoc/>
    public override CameraDescription Zoomed(CameraDescription camera, float factor) => camera with { ViewSize = camera.ViewSize * factor };

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new OrthographicProjection(view);
}

/// <summary>Parallel rays, from a plane through the eye across the viewing direction.</summary>
internal sealed class OrthographicProjection : InvertibleProjection
{
    private readonly Vector3 _eye;
    private readonly Vector3 _forward;
    private readonly Vector3 _toFocus;
    private readonly PictureGrid _grid;
    private readonly float _perArea;

    /// <summary>Makes one.</summary>
    public OrthographicProjection(in CameraView view)
    {
        (_eye, _forward) = (view.Camera.Position, view.Forward);
        _toFocus = view.Forward * view.Focus;
        _grid = new(view.OnPlane(_eye, view.Camera.ViewSize));
        _perArea = (float)(1 / _grid.PixelArea);
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = _grid.At(x, y);
        toFocus = _toFocus;
    }

    /// <inheritdoc/>
    public override void Find(in Vec3W point, in Vec3W shift, out FloatW x, out FloatW y)
    {
        // All rays through a point of the lens are parallel: back along them to the plane.
        Vec3W along = _toFocus - shift;
        Vec3W unshifted = point - shift;
        FloatW steps = Vec3W.Dot(unshifted - _eye, _forward) / Vec3W.Dot(along, _forward);
        _grid.Find(Vec3W.NegatedMultiplyAdd(along, steps, unshifted), out x, out y);
    }

    /// <summary>The same everywhere: pixels are seen at a slant from a point of the lens other than its middle.</summary>
    public override void Density(in Vec3W origin, in Vec3W direction, in FloatW distance, out FloatW density) =>
        density = _perArea / FloatW.Abs(Vec3W.Dot(direction, _forward));
}
