using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Lights;

/// <summary>The light that leaves a surface of a luminaire.</summary>
internal static class LuminaireEmission
{
    /// <summary>Rays that leave chosen points; directions are chosen in proportion to radiance times cosine.</summary>
    /// <param name="luminaire">The material.</param>
    /// <param name="surface">The points, with uv where the colour varies.</param>
    /// <param name="pdf">The density per area with which they were chosen.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="ray">The rays, of which primitive and instance are still to be set.</param>
    public static void Emit(LuminaireMaterial luminaire, in SurfaceW surface, in FloatW pdf, in FloatW u, in FloatW v, out EmittedW ray)
    {
        Onb.FromNormal(surface.Normal, out Onb frame);
        Vec3W local = luminaire.EmittedDirection(u, v);
        luminaire.Exitance(surface.U, surface.V, out RgbW exitance);
        ray = default;
        ray.Direction = frame.ToWorld(local);
        ray.Normal = surface.Normal;
        ray.Cosine = local.Z;
        ray.Origin = SurfaceShader.Leave(surface, ray.Direction);
        ray.InnerOrigin = SurfaceShader.LeaveInside(surface, ray.Direction);
        ray.PointPdf = pdf;
        ray.Brings(exitance * (1f / pdf), luminaire.EmissionPdf(ray.Cosine));
    }
}
