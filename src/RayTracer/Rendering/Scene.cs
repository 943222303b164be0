using RayTracer.Acceleration;
using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>
/// A scene that is ready to be rendered: never changed any more, so any number of threads may read it. Made by <see cref="SceneBuilder"/>.
/// </summary>
public sealed class Scene
{
    private Scene(RenderDescription render, Camera camera, IReadOnlyList<Shape> shapes, Rgb background, Rgb ambient)
    {
        Render = render;
        Camera = camera;
        Background = background;
        Ambient = ambient;
        Sampler = Sampler.Create(render);
        Batches = [.. shapes.GroupBy(s => s.GetType()).Select(kind => kind.First().CreateBatch([.. kind]))];
        Shapes = [.. shapes.GroupBy(s => s.GetType()).SelectMany(kind => kind)];
        int first = 0;
        foreach (ShapeBatch batch in Batches)
        {
            batch.FirstPrimitive = first;
            first += batch.Count;
        }

        Primitives = new([.. Batches]);
        Groups = ShadingGroup.Create(this, out int[] groupOf);
        GroupOfPrimitive = groupOf;
        Lights = [.. Shapes.Select((shape, i) => (shape, i)).Where(s => s.shape.Material.Emits).Select(s => new AreaLight(s.shape, s.i))];
    }

    /// <summary>Size, samples, depths and sampler.</summary>
    public RenderDescription Render { get; }

    /// <summary>The camera.</summary>
    public Camera Camera { get; }

    /// <summary>Where random numbers come from.</summary>
    public Sampler Sampler { get; }

    /// <summary>Radiance where nothing is hit.</summary>
    public Rgb Background { get; }

    /// <summary>Ambient radiance.</summary>
    public Rgb Ambient { get; }

    /// <summary>All shapes by primitive number.</summary>
    public IReadOnlyList<Shape> Shapes { get; }

    /// <summary>The shapes that shine.</summary>
    public IReadOnlyList<AreaLight> Lights { get; }

    /// <summary>The shapes packed by kind.</summary>
    public IReadOnlyList<ShapeBatch> Batches { get; }

    /// <summary>Meets rays with the shapes.</summary>
    public PrimitiveList Primitives { get; }

    /// <summary>What is shaded together.</summary>
    internal ShadingGroup[] Groups { get; }

    /// <summary>The group of each primitive, and, one further, what stands for rays that hit nothing.</summary>
    internal int[] GroupOfPrimitive { get; }

    /// <summary>Makes a scene from built shapes; reports what is wrong and returns null.</summary>
    internal static Scene? Create(SceneDescription description, IReadOnlyList<Shape> shapes, SceneBuilder builder)
    {
        RenderDescription render = description.Render;
        CheckRange(builder, render, nameof(render.Width), render.Width, 1, 65536);
        CheckRange(builder, render, nameof(render.Height), render.Height, 1, 65536);
        CheckRange(builder, render, nameof(render.SamplesPerPixel), render.SamplesPerPixel, 1, 1 << 24);
        CheckRange(builder, render, nameof(render.MaxDiffuseDepth), render.MaxDiffuseDepth, 0, (int)PathState.DepthMask);
        CheckRange(builder, render, nameof(render.MaxSpecularDepth), render.MaxSpecularDepth, 0, (int)PathState.DepthMask);
        if (Sampler.Complaint(render.Sampler, render.SamplesPerPixel) is { } complaint)
        {
            builder.Error(render, nameof(RenderDescription.SamplesPerPixel), complaint);
        }

        if (description.Camera.Lens is { Shape: not LensShape.EyeJitter, ApertureRadius: 0, FocusDistance: > 0 })
        {
            builder.Warn(description.Camera.Lens, nameof(LensDescription.FocusDistance), "without an \"apertureRadius\" the lens is a pinhole, and \"focusDistance\" has no effect");
        }

        Camera? camera = Camera.Create(description.Camera, render.Width, render.Height, builder);
        return camera is null || builder.HasErrors ? null : new Scene(render, camera, shapes, description.Background, description.Ambient);
    }

    // Scene files are checked by their reader; descriptions may also be made by programs.
    private static void CheckRange(SceneBuilder builder, RenderDescription render, string property, int value, int minimum, int maximum)
    {
        if (value < minimum || value > maximum)
        {
            builder.Error(render, property, $"must be from {minimum} to {maximum}, but is {value}");
        }
    }
}
