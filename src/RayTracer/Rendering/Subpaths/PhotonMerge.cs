using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Merges vertices of camera paths with all vertices of light paths that are near, as if they were the same (Georgiev et al. 2012; photon mapping,
/// Jensen 1996): a bias that goes with the radius.
/// </summary>
/// <param name="pass">Has the light paths.</param>
/// <param name="isIndirect">True if light that comes straight from the lights is left out, and all else counts in full.</param>
/// <param name="recorder">Records what they bring; may be null.</param>
internal sealed unsafe class PhotonMerge(LightPass pass, bool isIndirect, StrategyRecorder? recorder)
{
    private readonly List<uint>[] _found = [.. Enumerable.Range(0, FloatW.Count).Select(_ => new List<uint>())];
    private readonly PinnedBuffer<PhotonW> _photon = new(1);

    /// <summary>Adds up what the photons near bring to the camera.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="surface">The vertices of camera paths.</param>
    /// <param name="end">More of them.</param>
    /// <param name="maxDepth">The number of edges that a whole path may have.</param>
    /// <param name="active">The lanes in use.</param>
    /// <param name="light">The light.</param>
    public void Add(ShadingGroup group, ref SurfaceW surface, in CameraEndW end, uint maxDepth, MaskW active, out RgbW light)
    {
        light = default;
        int most = pass.Photons!.Find(surface.Point, active, _found);
        uint* chosen = stackalloc uint[16];

        // What is one over, of first vertices, no other way has made before.
        bool hasBefore = (active & end.Sums.Vm > 0f).Any;
        for (int i = 0; i < most; i++)
        {
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                chosen[lane] = i < _found[lane].Count ? _found[lane][i] : uint.MaxValue;
            }

            UIntW vertex = UIntW.Load(chosen);
            MaskW has = ~UIntW.Equal(vertex, uint.MaxValue);
            ref PhotonW photon = ref *_photon.Pointer;
            photon.Load(pass.Photons!.Photons, has.Select(vertex, 0u));
            if (recorder is not null)
            {
                photon.LoadPoint(pass.Photons!.Photons, has.Select(vertex, 0u));
            }

            UIntW number = photon.State & PathState.VertexMask;
            has &= end.Number + number + 1u < maxDepth;
            if (isIndirect)
            {
                has &= number > 0u;
            }

            AddOne(group, ref surface, end, photon, hasBefore, has, ref light);
        }

        light *= end.Throughput * (1f / pass.MergedPaths);
    }

    private void AddOne(ShadingGroup group, ref SurfaceW surface, in CameraEndW end, in PhotonW photon, bool hasBefore, MaskW has, ref RgbW light)
    {
        Vec3W direction = -photon.Direction;
        group.Material.Evaluate(surface, direction, out RgbW bsdf, out FloatW pdf);
        FloatW along = FloatW.Abs(Vec3W.Dot(direction, surface.Normal));
        FloatW share = FloatW.Abs(Vec3W.Dot(direction, surface.Facing)) / along;
        FloatW others = 0f;
        if (!isIndirect)
        {
            FloatW reversePdf = 0f;
            if (hasBefore)
            {
                Adjoint.ReversePdf(group.Material, ref surface, direction, out reversePdf);
            }

            others = photon.Sums.Merged(pdf, pass.Weights) + end.Sums.Merged(reversePdf, pass.Weights);
            share /= others + 1f;
        }

        has = has.Except(SurfaceShader.Dropped(surface, direction)) & along > 0f;
        RgbW color = UIntW.Equal(photon.State & PathState.HasWavelength, 0u).Select(Rgb.White, end.Color);
        RgbW found = bsdf * photon.Power * color * share;
        light += has.Select(found, default);
        if (recorder is not null)
        {
            found *= end.Throughput * (1f / pass.MergedPaths);
            WaysW ways = new() { From = (photon.State & PathState.VertexMask) + 2u, To = end.Number + 2u, IsMerge = true, Point = photon.Point };
            ways.Factors = new()
            {
                CameraPart = end.Throughput,
                CameraBsdf = bsdf,
                LightPart = photon.Power * color,
                Geometry = FloatW.Abs(Vec3W.Dot(direction, surface.Facing)) / along,
                Kernel = 1f / pass.MergedPaths,
            };
            recorder.Add(has.Bits, end.Path, ways, found, found * (others + 1f));
        }
    }

    private struct PhotonW
    {
        public Vec3W Point;
        public Vec3W Direction;
        public RgbW Power;
        public SubpathSumsW Sums;
        public UIntW State;

        public void LoadPoint(Photon* photons, UIntW photon)
        {
            Point = Vec3W.Gather((float*)photons, photon * Photon.Numbers);
        }

        public void Load(Photon* photons, UIntW photon)
        {
            UIntW at = photon * Photon.Numbers;
            float* numbers = (float*)photons;
            State = UIntW.Gather((uint*)numbers + 3, at);
            Direction = Vec3W.Gather(numbers + 4, at);
            Power = RgbW.Gather(numbers + 7, at);
            FloatW.Gather(numbers + 10, at, out Sums.Vcm, out Sums.Vm);
        }
    }
}
