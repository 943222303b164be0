using System.Globalization;
using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Tests.Statistics;

/// <summary>A ray that meets a surface at a known angle, with the same numbers in all lanes.</summary>
/// <param name="Cosine">Cosine of incidence.</param>
/// <param name="Inside">Whether the ray comes from inside.</param>
internal sealed record SurfaceCase(double Cosine, bool Inside = false)
{
    /// <summary>Where textures are evaluated.</summary>
    public const float U = 0.25f, V = 0.75f;

    /// <summary>Length of the ray.</summary>
    public const float Distance = 0.7f;

    /// <summary>Of light that is dispersed, in µm.</summary>
    public const float Wavelength = 0.45f;

    /// <summary>Refractive index of what is around dielectrics that have priorities.</summary>
    public const float Around = 1.2f;

    // Poles of the basis, next to them, and anywhere.
    private static readonly Vector3D[] s_normals =
        [new(0.3, 0.8, -0.4), new(0, 0, 1), new(0, 0, -1), new(-1e-4, 2e-4, -1), new(0, -1, 0), new(0.6, -0.1, 0.7)];

    /// <summary>The shape's unit normal: another one for each angle.</summary>
    public Vector3D Normal => s_normals[(int)(Cosine * 997) % s_normals.Length].Unit;

    /// <summary>The unit normal on the ray's side.</summary>
    public Vector3D Facing => Inside ? -Normal : Normal;

    /// <summary>Direction of the ray.</summary>
    public Vector3D Incoming => (Facing * -Cosine) + (Facing.Perpendicular() * Math.Sqrt(1 - (Cosine * Cosine)));

    /// <summary>The mirror image of the ray.</summary>
    public Vector3D Mirror => Incoming + (Facing * (2 * Cosine));

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"cosine {Cosine} from {(Inside ? "inside" : "outside")}");

    /// <summary>The surface, prepared for a material.</summary>
    public SurfaceW Prepare(Material material)
    {
        SurfaceW surface = default;
        surface.Normal = (Vector3)Normal;
        surface.Facing = (Vector3)Facing;
        surface.Incoming = (Vector3)Incoming;
        surface.Cosine = (float)Cosine;
        surface.Inside = Inside ? MaskW.All : MaskW.None;
        surface.Distance = Distance;
        surface.Wavelength = Wavelength;
        surface.ExteriorIndex = Around;
        surface.U = U;
        surface.V = V;
        surface.Tint = Rgb.White;
        Turn(ref surface);
        material.Prepare(ref surface);
        return surface;
    }

    /// <summary>A surface as seen along another ray.</summary>
    public static void Turn(ref SurfaceW surface, Vector3D incoming)
    {
        surface.Incoming = (Vector3)incoming;
        surface.Cosine = FloatW.Abs(Vec3W.Dot(surface.Incoming, surface.Normal));
        surface.Inside = Vec3W.Dot(surface.Incoming, surface.Normal) > 0f;
        surface.Facing = surface.Inside.Select(-surface.Normal, surface.Normal);
        Turn(ref surface);
    }

    // Along u is a direction of the surface's own, whichever side it is seen from.
    private static void Turn(ref SurfaceW surface)
    {
        Onb.FromNormal(surface.Normal, out Onb frame);
        surface.Tangent = Vec3W.MultiplyAdd(frame.U, 0.8f, frame.V * 0.6f);
        surface.AlongU = surface.Tangent * 2f;
        surface.AlongV = Vec3W.MultiplyAdd(frame.U, -0.5f, frame.V * 1.5f);
    }
}
