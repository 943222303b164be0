using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Cameras;

/// <summary>A camera with a thin lens; without an aperture, a pinhole.</summary>
public sealed class Camera
{
    private readonly CameraProjection _projection;
    private readonly Lens? _lens;
    private readonly Motion _motion;
    private readonly CameraView _view;

    private Camera(CameraProjection projection, Lens? lens, Motion motion, in CameraView view)
    {
        _view = view;
        _projection = projection;
        _lens = lens;
        _motion = motion;
    }

    /// <summary>True where rays use the lens dimensions.</summary>
    public bool HasLens => _lens is not null;

    /// <summary>True where the camera moves in time.</summary>
    public bool Moves => !_motion.IsStill;

    /// <summary>True where the camera moves, or is elsewhere than its position and target say.</summary>
    internal bool IsPlaced => !ReferenceEquals(_motion, Motion.None);

    /// <summary>Makes the camera that a description describes; reports what is wrong with it and returns null.</summary>
    /// <param name="camera">The description.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    public static Camera? Create(CameraDescription camera, int width, int height, SceneBuilder builder)
    {
        Vector3 forward = (camera.LookAt - camera.Position).Unit();
        if (float.IsInfinity((camera.LookAt - camera.Position).Norm()))
        {
            builder.Error(camera, nameof(CameraDescription.LookAt), "the point looked at is too far from the camera to compute with");
            return null;
        }

        if (!forward.IsFinite())
        {
            builder.Error(camera, nameof(CameraDescription.LookAt), "the camera must look at a point other than its own position");
            return null;
        }

        Vector3 right = forward.Cross(camera.Up).Unit();
        if (!right.IsFinite())
        {
            builder.Error(camera, nameof(CameraDescription.Up), "\"up\" must not be zero or parallel to the viewing direction");
            return null;
        }

        bool hasLens = camera.Lens.Shape == LensShape.EyeJitter ? camera.Lens.Jitter != Vector3.Zero : camera.Lens.ApertureRadius > 0;
        Projection kind = camera.Projection;
        if (hasLens && kind.LensComplaint is { } complaint)
        {
            builder.Error(camera, nameof(CameraDescription.Lens), complaint);
        }

        if (!IsWindow(camera, kind, builder))
        {
            return null;
        }

        CameraView view = new(camera, forward, right, right.Cross(forward), width, height);
        Motion motion = TransformSteps.Motion(camera, camera.Transform, camera.Motion, builder);
        return new Camera(kind.Create(view), hasLens ? new Lens(camera.Lens, view.Right, view.Up) : null, motion, view);
    }

    /// <summary>The distance along the viewing direction of the point that the ray through a point of the picture meets.</summary>
    /// <param name="x">Column, in pixels from the left edge.</param>
    /// <param name="y">Row, in pixels from the top edge.</param>
    /// <param name="distance">Its distance along the ray.</param>
    public float Depth(float x, float y, float distance)
    {
        _projection.Rays(x, y, out _, out Vec3W toFocus);
        return distance * Vec3W.Dot(Vec3W.Normalize(toFocus), _view.Forward)[0];
    }

    /// <summary>
    /// The place of the camera at a time in seconds: the middle of its lens, or of its picture where its rays are parallel.
    /// </summary>
    internal Vec3W Origin(float time)
    {
        Vec3W origin = _view.Camera.Position;
        Vec3W direction = new(0f, 0f, 1f);
        if (IsPlaced)
        {
            Place(time, ref origin, ref direction);
        }

        return origin;
    }

    private static bool IsWindow(CameraDescription camera, Projection kind, SceneBuilder builder)
    {
        IReadOnlyList<float> window = camera.Window;
        string? complaint = window switch
        {
            { Count: 0 } => null,
            { Count: not 4 } => $"a window has four numbers (x, y, width and height), but this one has {window.Count}",
            _ when kind.WindowComplaint is { } refused => refused,
            _ => window[2] > 0 && window[3] > 0 && window[0] + window[2] < 1.0001f && window[1] + window[3] < 1.0001f ? null
                : "a window needs a width and a height above 0, and must not reach beyond the picture",
        };
        if (complaint is not null)
        {
            builder.Error(camera, nameof(CameraDescription.Window), complaint);
        }

        return complaint is null;
    }

    /// <summary>Takes rays to where the camera is.</summary>
    /// <param name="time">Their times in seconds.</param>
    /// <param name="origin">Where they start: in the camera's own space, then in the world.</param>
    /// <param name="direction">Their unit directions: in the camera's own space, then in the world.</param>
    internal unsafe void Place(in FloatW time, ref Vec3W origin, ref Vec3W direction)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(_motion, time);
        origin = maps.Point(origin);
        direction = Vec3W.Normalize(maps.Vector(direction));
    }

    /// <summary>The ray through a point of the picture and the middle of the lens, when the shutter opens.</summary>
    /// <param name="x">Column, in pixels from the left edge.</param>
    /// <param name="y">Row, in pixels from the top edge.</param>
    /// <param name="time">The time in seconds.</param>
    /// <param name="origin">Where the ray starts.</param>
    /// <param name="direction">Its unit direction.</param>
    internal void CentralRay(float x, float y, float time, out Vec3W origin, out Vec3W direction)
    {
        _projection.Rays(x, y, out origin, out Vec3W toFocus);
        direction = Vec3W.Normalize(toFocus);
        if (IsPlaced)
        {
            Place(time, ref origin, ref direction);
        }
    }

    /// <summary>Rays through points of the picture.</summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="sampler">Where the lens's random numbers come from.</param>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Their unit directions.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void GenerateRays(FloatW x, FloatW y, Sampler sampler, in UIntW pixelKey, in UIntW sample, out Vec3W origin, out Vec3W direction)
    {
        _projection.Rays(x, y, out origin, out Vec3W toFocus);
        if (_lens is not null)
        {
            _lens.Point(sampler, pixelKey, sample, out Vec3W shift);
            origin += shift;
            toFocus -= shift;
        }

        direction = Vec3W.Normalize(toFocus);
    }
}
