using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Shows something of the surfaces that camera rays meet, as colours: for looking for mistakes in a scene.</summary>
internal sealed unsafe class ViewShader(Scene scene, FinishedPaths finished, PathRecorder? recorder) : SurfaceShader(scene, finished, recorder)
{
    protected override void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving) => arriving = default;

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, MaskW active)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        bool showsUv = Scene.Render.Integrator == Integrator.Uv;
        Describe(Scene, group, stream, index, group.Traits.UsesUv || showsUv, out SurfaceW surface);
        RgbW color;
        if (showsUv)
        {
            color = new(Wrapped(surface.U), Wrapped(surface.V), 0f);
        }
        else if (Scene.Render.Integrator == Integrator.Albedo)
        {
            group.Material.Albedo(surface, out color);
        }
        else
        {
            color = new(Half(surface.Facing.X), Half(surface.Facing.Y), Half(surface.Facing.Z));
        }

        Recorder?.Emitted(path, active, color);
        Recorder?.Brightened(path, active, color);
        ScatterW scatter = default;
        Recorder?.Scattered(stream, index, active, MaskW.None, group.Material, surface, scatter);
        Finished.Append(active.Bits, color, path);
    }

    private static FloatW Half(FloatW x) => FloatW.MultiplyAdd(x, 0.5f, 0.5f);

    private static FloatW Wrapped(FloatW x) => x - FloatW.Floor(x);
}
