using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Textbook.Tests;

/// <summary>One scene, rendered by both editions.</summary>
internal static class Editions
{
    /// <summary>Loads a scene file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="change">Changes the description; null for none.</param>
    public static SceneLoadResult Load(string path, Func<SceneDescription, SceneDescription>? change = null)
    {
        SceneLoadResult load = SceneLoader.Load(path, change);
        return load.Scene is null ? throw new InvalidOperationException(Diagnostic.Format(load.Diagnostics)) : load;
    }

    /// <summary>Loads a scene from the text of a scene file.</summary>
    public static SceneLoadResult LoadText(string text)
    {
        SceneLoadResult load = SceneLoader.LoadText(text, "test.json", ".");
        return load.Scene is null ? throw new InvalidOperationException(Diagnostic.Format(load.Diagnostics)) : load;
    }

    /// <summary>Renders a scene by the textbook edition, with independent seeds.</summary>
    public static ImageSamples Textbook(SceneLoadResult load, int seeds, string? integrator = null)
    {
        RenderDescription render = load.Description!.Render;
        ImageSamples images = new(render.Width, render.Height);
        for (int seed = 1; seed <= seeds; seed++)
        {
            SceneReader reader = new(load.LoadPicture, load.LoadModel);
            Renderer renderer = reader.Read(WithSeed(load.Description, seed), integrator) ?? throw new InvalidOperationException(string.Join('\n', reader.Complaints));
            images.Add(Render(renderer, render));
        }

        return images;
    }

    /// <summary>Renders a scene by the fast edition, with independent seeds.</summary>
    public static ImageSamples Fast(SceneLoadResult load, int seeds)
    {
        RenderDescription render = load.Description!.Render;
        ImageSamples images = new(render.Width, render.Height);
        for (int seed = 1; seed <= seeds; seed++)
        {
            SceneBuilder builder = new(load.LoadPicture, load.LoadModel);
            images.Add(new RTracer(builder.Build(WithSeed(load.Description, seed + 1000))!).Render().Film);
        }

        return images;
    }

    /// <summary>The mean of all samples of a scene.</summary>
    public static Picture Render(Renderer renderer, RenderDescription render)
    {
        Picture picture = new(render.Width, render.Height);
        for (int sample = 0; sample < render.SamplesPerPixel; sample++)
        {
            Rgb[] pixels = renderer.Pass(sample, Environment.ProcessorCount);
            for (int i = 0; i < pixels.Length; i++)
            {
                picture.Pixels[3 * i] += (float)(pixels[i].R / render.SamplesPerPixel);
                picture.Pixels[(3 * i) + 1] += (float)(pixels[i].G / render.SamplesPerPixel);
                picture.Pixels[(3 * i) + 2] += (float)(pixels[i].B / render.SamplesPerPixel);
            }
        }

        return picture;
    }

    private static SceneDescription WithSeed(SceneDescription scene, long seed) => scene with { Render = scene.Render with { Seed = seed + (TestSettings.Seed * 1_000_000L) } };
}
