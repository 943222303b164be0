using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.RenderTests.References;

/// <summary>A render that takes part in a case.</summary>
/// <param name="Sources">Which light it has.</param>
/// <param name="MaxDiffuseDepth">Limit of diffuse bounces.</param>
/// <param name="MaxSpecularDepth">Limit of specular bounces.</param>
public sealed record ReferenceTerm(Sources Sources, int MaxDiffuseDepth, int MaxSpecularDepth)
{
    private static readonly MaterialDescription s_black = new DiffuseMaterialDescription { Color = new SolidTextureDescription() };

    /// <summary>The scene with this term's light and limits.</summary>
    public SceneDescription Apply(SceneDescription scene, long seed, int samplesPerPixel)
    {
        RenderDescription render = scene.Render with
        {
            Seed = seed,
            SamplesPerPixel = samplesPerPixel,
            MaxDiffuseDepth = MaxDiffuseDepth,
            MaxSpecularDepth = MaxSpecularDepth,
        };
        return Sources switch
        {
            Sources.Lamps => scene with { Render = render, Background = Rgb.Black },
            Sources.Background => scene with
            {
                Render = render,
                Lights = [],
                Shapes = [.. scene.Shapes, .. scene.Lights.Select(lamp => lamp with { Material = s_black })],
            },
            _ => scene with { Render = render },
        };
    }
}

/// <summary>Which light a render has.</summary>
public enum Sources
{
    /// <summary>All that the scene has.</summary>
    All,

    /// <summary>Lamps alone: the background is black.</summary>
    Lamps,

    /// <summary>The background alone: lamps are black bodies.</summary>
    Background,
}
