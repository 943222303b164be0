using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Cameras;

/// <summary>The points where rays pass a camera's lens.</summary>
/// <param name="lens">The description of one that is no pinhole.</param>
/// <param name="right">Unit direction to the right in the picture.</param>
/// <param name="up">Unit direction upwards in the picture.</param>
internal sealed class Lens(LensDescription lens, Vector3 right, Vector3 up)
{
    private readonly float _turn = (lens.Rotation / 360) - float.Floor(lens.Rotation / 360);

    /// <summary>Points of the lens, relative to its middle.</summary>
    /// <param name="sampler">The source of the random numbers.</param>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="shift">The points.</param>
    public void Point(Sampler sampler, in UIntW pixelKey, in UIntW sample, out Vec3W shift)
    {
        sampler.Begin(pixelKey, sample, Dimensions.Lens, out SamplePoints points);
        sampler.Pair(points, 0, out FloatW u, out FloatW v);
        switch (lens.Shape)
        {
            case LensShape.Disk:
                Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
                shift = Vec3W.MultiplyAdd(right * lens.ApertureRadius, x, (Vec3W)(up * lens.ApertureRadius) * y);
                break;
            case LensShape.Square:
                float side = 2 * lens.ApertureRadius;
                shift = Vec3W.MultiplyAdd(right * side, u - 0.5f, (Vec3W)(up * side) * (v - 0.5f));
                break;
            case LensShape.Bladed:
                Warp.RegularPolygon(u, v, lens.Blades, _turn, out x, out y);
                shift = Vec3W.MultiplyAdd(right * lens.ApertureRadius, x, (Vec3W)(up * lens.ApertureRadius) * y);
                break;
            default:
                sampler.Begin(pixelKey, sample, Dimensions.Camera, out SamplePoints camera);
                sampler.Pair(camera, 0, out FloatW w, out _);
                shift = new((u - 0.5f) * lens.Jitter.X, (v - 0.5f) * lens.Jitter.Y, (w - 0.5f) * lens.Jitter.Z);
                break;
        }
    }
}
