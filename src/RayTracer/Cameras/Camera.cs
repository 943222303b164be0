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
    private readonly Vector3 _eye;
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;
    private readonly Vector3 _right;
    private readonly Vector3 _up;
    private readonly LensDescription _lens;

    private readonly Motion _motion;

    private Camera(CameraDescription camera, Vector3 forward, Vector3 right, int width, int height, Motion motion)
    {
        _motion = motion;
        _eye = camera.Position;
        _right = right;
        _up = right.Cross(forward);
        _lens = camera.Lens;
        float focus = _lens.FocusDistance > 0 ? _lens.FocusDistance : (camera.LookAt - camera.Position).Dot(forward);

        // The part of the plane in focus that the picture shows.
        bool vertical = camera.FieldOfViewAxis switch
        {
            FieldOfViewAxis.Vertical => true,
            FieldOfViewAxis.Horizontal => false,
            FieldOfViewAxis.Smaller => height <= width,
            _ => height >= width,
        };
        float extent = 2 * focus * LaneMath.Tan(camera.FieldOfView * (float.Pi / 360));
        float pixel = extent / (vertical ? height : width);
        _stepX = right * pixel;
        _stepY = _up * -pixel;
        _corner = forward * focus - _stepX * (0.5f * width) - _stepY * (0.5f * height);
    }

    /// <summary>Whether rays use the lens dimensions.</summary>
    public bool HasLens => _lens.Shape == LensShape.EyeJitter ? _lens.Jitter != Vector3.Zero : _lens.ApertureRadius > 0;

    /// <summary>Whether the camera moves in time.</summary>
    public bool Moves => !_motion.IsStill;

    /// <summary>Whether the camera moves, or stands elsewhere than its position and target say.</summary>
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

        Motion motion = TransformSteps.Motion(camera, camera.Transform, camera.Motion, builder);
        return new Camera(camera, forward, right, width, height, motion);
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
        origin = _eye;
        direction = Vec3W.Normalize(Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner)));
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
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Their unit directions.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void GenerateRays(FloatW x, FloatW y, Sampler sampler, in UIntW pixelKey, in UIntW sample, out Vec3W origin, out Vec3W direction)
    {
        Vec3W toFocus = Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));
        if (HasLens)
        {
            LensPoint(sampler, pixelKey, sample, out Vec3W shift);
            origin = (Vec3W)_eye + shift;
            direction = Vec3W.Normalize(toFocus - shift);
        }
        else
        {
            origin = _eye;
            direction = Vec3W.Normalize(toFocus);
        }
    }

    private void LensPoint(Sampler sampler, in UIntW pixelKey, in UIntW sample, out Vec3W shift)
    {
        sampler.Begin(pixelKey, sample, Dimensions.Lens, out SamplePoints lens);
        sampler.Pair(lens, 0, out FloatW u, out FloatW v);
        switch (_lens.Shape)
        {
            case LensShape.Disk:
                Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
                shift = Vec3W.MultiplyAdd(_right * _lens.ApertureRadius, x, (Vec3W)(_up * _lens.ApertureRadius) * y);
                break;
            case LensShape.Square:
                float side = 2 * _lens.ApertureRadius;
                shift = Vec3W.MultiplyAdd(_right * side, u - 0.5f, (Vec3W)(_up * side) * (v - 0.5f));
                break;
            default:
                sampler.Begin(pixelKey, sample, Dimensions.Camera, out SamplePoints camera);
                sampler.Pair(camera, 0, out FloatW w, out _);
                shift = new((u - 0.5f) * _lens.Jitter.X, (v - 0.5f) * _lens.Jitter.Y, (w - 0.5f) * _lens.Jitter.Z);
                break;
        }
    }
}
