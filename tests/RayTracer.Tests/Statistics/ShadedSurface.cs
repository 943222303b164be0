using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Statistics;

/// <summary>A surface that rays meet from anywhere, and that is shaded with another normal than its own.</summary>
/// <param name="Normal">Its own unit normal.</param>
/// <param name="Shading">The unit normal with which it is shaded.</param>
/// <param name="IsLiteral">Whether the shading normal alone says from which side it is seen; otherwise it is mirrored into view.</param>
internal sealed record ShadedSurface(Vector3D Normal, Vector3D Shading, bool IsLiteral)
{
    /// <summary>Surfaces that are shaded with their own normals, and, in both ways, with normals 33° off.</summary>
    public static IReadOnlyList<ShadedSurface> All { get; } =
        [Of(new(0.3, 0.8, -0.4), default, isLiteral: false), Of(new(-0.2, -0.6, 0.7), new(0.5, 0.1, 0.4), isLiteral: false), Of(new(0.1, 0.5, -0.8), new(0.2, -0.6, -0.1), isLiteral: true)];

    /// <inheritdoc/>
    public override string ToString() => Normal == Shading ? "a flat surface" : IsLiteral ? "a surface of literal normals" : "a surface of mended normals";

    /// <summary>The surface as rays meet it, prepared for a material.</summary>
    /// <param name="material">The material.</param>
    /// <param name="incoming">Unit directions of the rays.</param>
    public SurfaceW Meet(Material material, in Vec3W incoming)
    {
        SurfaceW surface = new SurfaceCase(1).Prepare(material);
        surface.Normal = (Vector3)Normal;
        surface.Shading = (Vector3)Shading;
        surface.Rules = ShadingGroup.RulesOf(material, Normal != Shading, IsLiteral);
        surface.Incoming = incoming;
        float[][] lanes = [new float[FloatW.Count], new float[FloatW.Count], new float[FloatW.Count], new float[FloatW.Count], new float[FloatW.Count]];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            (Vector3D facing, bool inside) = Facing(Vector3D.Of(incoming, lane), TakesLiterally(material));
            (lanes[0][lane], lanes[1][lane], lanes[2][lane]) = ((float)facing.X, (float)facing.Y, (float)facing.Z);
            lanes[3][lane] = (float)-facing.Dot(Vector3D.Of(incoming, lane));
            lanes[4][lane] = inside ? 1 : 0;
        }

        surface.Facing = new(Load(lanes[0]), Load(lanes[1]), Load(lanes[2]));
        surface.Cosine = Load(lanes[3]);
        surface.Inside = Load(lanes[4]) > 0.5f;
        Onb.FromNormal(surface.Normal, out Onb frame);
        surface.AlongU = frame.U;
        surface.AlongV = frame.V * 1.5f;
        surface.SetTangent();
        material.Prepare(ref surface);
        return surface;
    }

    /// <summary>Whether light on its way to the camera would pass through the surface, so that it is dropped.</summary>
    /// <param name="material">The material.</param>
    /// <param name="camera">Direction to the camera.</param>
    /// <param name="light">Direction to where the light comes from.</param>
    /// <param name="facing">The normal that the camera sees.</param>
    public bool Leaks(Material material, Vector3D camera, Vector3D light, Vector3D facing) =>
        !TakesLiterally(material) && (Normal != Shading || material.Traits.TurnsNormal) && Math.Sign(camera.Dot(Normal)) * light.Dot(Normal) * light.Dot(facing) <= 0;

    private static ShadedSurface Of(Vector3D normal, Vector3D tilt, bool isLiteral) => new(normal.Unit, (normal.Unit + tilt).Unit, isLiteral);

    private static FloatW Load(float[] lanes) => new(new Vector<float>(lanes));

    private bool TakesLiterally(Material material) => IsLiteral && !material.Traits.MirrorsNormal;

    private (Vector3D Facing, bool Inside) Facing(Vector3D incoming, bool isLiteral)
    {
        bool isInside = incoming.Dot(isLiteral ? Shading : Normal) > 0;
        if (isLiteral)
        {
            return (isInside ? -Shading : Shading, isInside);
        }

        Vector3D own = isInside ? -Normal : Normal;
        Vector3D shading = Shading.Dot(own) < 0 ? -Shading : Shading;
        return (shading - (incoming * (2 * Math.Max(0, incoming.Dot(shading)))), isInside);
    }
}
