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
    private readonly InvertibleProjection? _invertible;
    private readonly float _margin;

    private Camera(CameraProjection projection, Lens? lens, Motion motion, in CameraView view, float margin)
    {
        (_view, _margin) = (view, margin);
        _projection = projection;
        _invertible = projection as InvertibleProjection;
        _lens = lens;
        _motion = motion;
    }

    /// <summary>True where rays use the lens dimensions.</summary>
    public bool HasLens => _lens is not null;

    /// <summary>True where the camera moves in time.</summary>
    public bool Moves => !_motion.IsStill;

    /// <summary>True where the camera moves, or is elsewhere than its position and target say.</summary>
    internal bool IsPlaced => !ReferenceEquals(_motion, Motion.None);

    /// <summary>True where points of the scene can be connected with the camera: where its projection is invertible.</summary>
    internal bool CanLink => _invertible is not null;

    /// <summary>Makes the camera that a description describes; reports what is wrong with it and returns null.</summary>
    /// <param name="camera">The description.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    /// <param name="margin">The distance by which its pixels reach beyond the edges of the picture, by their filter; in pixels.</param>
    public static Camera? Create(CameraDescription camera, int width, int height, SceneBuilder builder, float margin = 0)
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
        return new Camera(kind.Create(view), hasLens ? new Lens(camera.Lens, view.Right, view.Up) : null, motion, view, margin);
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
    /// <param name="origin">Their origins: in the camera's own space, then in the world.</param>
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
    /// <param name="origin">The ray's origin.</param>
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
    /// <param name="sampler">The source of the lens's random numbers.</param>
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
    /// <summary>
    /// Connects points of the scene with the camera; only where <see cref="CanLink"/>. A point of the lens is chosen with the same random
    /// numbers as for the rays of the key and the sample: the ray through what is returned as X and Y passes the point.
    /// </summary>
    /// <param name="point">The points.</param>
    /// <param name="time">Their times in seconds.</param>
    /// <param name="sampler">The source of the lens's random numbers.</param>
    /// <param name="pixelKey">Keys of pixels, not necessarily those that see the points.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="link">The connections.</param>
    internal unsafe void Link(in Vec3W point, in FloatW time, Sampler sampler, in UIntW pixelKey, in UIntW sample, out CameraLinkW link)
    {
        Vec3W shift = Vector3.Zero;
        _lens?.Point(sampler, pixelKey, sample, out shift);
        if (!IsPlaced)
        {
            Link(point, shift, out link);
            return;
        }

        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.FillBothWays(_motion, time);
        Link(maps.PointBack(point), shift, out link);
        Vec3W towards = maps.Vector(link.Direction);
        FloatW stretch = FloatW.Sqrt(Vec3W.Dot(towards, towards));
        link.Direction = towards * (1f / stretch);
        link.Distance *= stretch;
        link.Density *= Thinning(maps, stretch);
    }

    /// <summary>
    /// The density of the camera's rays along one of them, as of <see cref="CameraLinkW.Density"/>; only where <see cref="CanLink"/>.
    /// </summary>
    /// <param name="origin">The ray's origin in the world.</param>
    /// <param name="direction">Its unit direction in the world.</param>
    /// <param name="distance">The distance along the ray at which the density is asked for.</param>
    /// <param name="time">The ray's time in seconds.</param>
    /// <param name="density">Rays per unit of area perpendicular to the ray, one for each pixel.</param>
    internal unsafe void Density(in Vec3W origin, in Vec3W direction, in FloatW distance, in FloatW time, out FloatW density)
    {
        if (!IsPlaced)
        {
            _invertible!.Density(origin, direction, distance, out density);
            return;
        }

        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.FillBothWays(_motion, time);
        Vec3W inside = maps.VectorBack(direction);
        FloatW stretch = 1f / FloatW.Sqrt(Vec3W.Dot(inside, inside));
        _invertible!.Density(maps.PointBack(origin), inside * stretch, distance / stretch, out density);
        density *= Thinning(maps, stretch);
    }

    /// <summary>
    /// Chooses the pixels that points of the picture count for, by the pixel filter, with the factor that makes the mean into each pixel the
    /// filter's value there.
    /// </summary>
    /// <param name="filter">The filter; null for the pixel's own square.</param>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="u">A random number.</param>
    /// <param name="v">Another one.</param>
    /// <param name="pixelX">Columns of the pixels, from 0.</param>
    /// <param name="pixelY">Rows of the pixels, from 0.</param>
    /// <param name="weight">The factors.</param>
    /// <returns>True where the pixel exists: filters also reach for pixels beyond the picture's edges.</returns>
    internal MaskW Splat(PixelFilter? filter, in FloatW x, in FloatW y, in FloatW u, in FloatW v, out FloatW pixelX, out FloatW pixelY, out FloatW weight)
    {
        const float half = 0.5f;
        FloatW across = x;
        PixelFilter.Splat(filter, y, v, out FloatW row, out FloatW weightY);

        // Beyond a pole of a spherical picture the columns are those of the other side, which may lie halfway between these.
        FloatW middleY = row + half;
        _invertible!.Fold(ref across, ref middleY);
        PixelFilter.Splat(filter, across, u, out FloatW column, out FloatW weightX);
        FloatW middleX = column + half;
        _invertible.Fold(ref middleX, ref middleY);
        pixelX = middleX - half;
        pixelY = middleY - half;
        weight = weightX * weightY;
        return (pixelX >= 0f) & (pixelX < _view.Width) & (pixelY >= 0f) & (pixelY < _view.Height);
    }

    // What becomes of a density of rays per perpendicular area where a map stretches lengths along the rays by a factor: volumes become
    // larger by the determinant, and so areas by the determinant over the factor.
    private static FloatW Thinning(in InstanceMaps maps, in FloatW stretch) => stretch / FloatW.Abs(maps.Determinant());

    // In the camera's own space.
    private void Link(in Vec3W point, in Vec3W shift, out CameraLinkW link)
    {
        _invertible!.Find(point, shift, out link.X, out link.Y);
        _projection.Rays(link.X, link.Y, out Vec3W origin, out Vec3W toFocus);
        origin += shift;
        Vec3W towards = origin - point;
        link.Distance = FloatW.Sqrt(Vec3W.Dot(towards, towards));
        link.Direction = towards * (1f / link.Distance);
        _invertible.Density(origin, -link.Direction, link.Distance, out link.Density);
        MaskW across = (link.X >= -_margin) & (link.X < _view.Width + _margin);
        MaskW along = (link.Y >= -_margin) & (link.Y < _view.Height + _margin);
        link.Sees = across & along & (Vec3W.Dot(towards, toFocus - shift) < 0f);
    }
}
