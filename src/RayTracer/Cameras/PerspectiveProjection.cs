using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>By rays through one point.</summary>
internal sealed class PerspectiveKind() : Projection("perspective")
{
    private const float NarrowestDegrees = 0.1f;
    private const float WidestDegrees = 170;

    /// <inheritdoc/>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => Shown(camera, distance) / ViewPlane.Extent(camera.FieldOfViewAxis, aspect, 1);

    /// <inheritdoc/>
    public override CameraDescription Zoomed(CameraDescription camera, float factor)
    {
        float degrees = LaneMath.Atan2(LaneMath.Tan(camera.FieldOfView * (float.Pi / 360)) * factor, 1) * (360 / float.Pi);
        return camera with { FieldOfView = float.Clamp(degrees, NarrowestDegrees, WidestDegrees) };
    }

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new PerspectiveProjection(view, Shown(view.Camera, view.Focus));

    // Of a plane at a distance, over the extent that the field of view measures.
    private static float Shown(CameraDescription camera, float distance) => 2 * distance * LaneMath.Tan(camera.FieldOfView * (float.Pi / 360));
}

/// <summary>Rays from the eye through a plane.</summary>
internal sealed class PerspectiveProjection : InvertibleProjection
{
    private readonly Vector3 _eye;
    private readonly Vector3 _forward;
    private readonly float _focus;
    private readonly PictureGrid _grid;
    private readonly float _perSteradian;

    /// <summary>Makes one.</summary>
    /// <param name="view">The camera.</param>
    /// <param name="shown">The part of the plane in focus that it shows over the extent that the field of view measures.</param>
    public PerspectiveProjection(in CameraView view, float shown)
    {
        (_eye, _forward, _focus) = (view.Camera.Position, view.Forward, view.Focus);
        _grid = new(view.OnPlane(view.Forward * view.Focus, shown));
        _perSteradian = (float)((double)_focus * _focus / _grid.PixelArea);
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = _eye;
        toFocus = _grid.At(x, y);
    }

    /// <inheritdoc/>
    public override void Find(in Vec3W point, in Vec3W shift, out FloatW x, out FloatW y)
    {
        Vec3W along = point - _eye - shift;
        FloatW steps = (_focus - Vec3W.Dot(shift, _forward)) / Vec3W.Dot(along, _forward);
        _grid.Find(Vec3W.MultiplyAdd(along, steps, shift), out x, out y);
    }

    /// <summary>
    /// A pixel of the plane in focus, seen from the point of the lens, covers its area times the cosine over its squared distance, in
    /// steradians; that distance is the one along the view over the cosine.
    /// </summary>
    public override void Density(in Vec3W origin, in Vec3W direction, in FloatW distance, out FloatW density)
    {
        // The report's jitter moves the eye along the view too.
        FloatW left = 1f - (Vec3W.Dot(origin - _eye, _forward) * (1f / _focus));
        FloatW cosine = FloatW.Abs(Vec3W.Dot(direction, _forward));
        FloatW perSteradian = left * left * _perSteradian / (cosine * cosine * cosine);
        density = perSteradian / (distance * distance);
    }
}
