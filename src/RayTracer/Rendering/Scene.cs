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
    private Scene(RenderDescription render, Camera camera, SpaceContents contents, Rgb background, Rgb ambient, int? largestLoop)
    {
        Render = render;
        Camera = camera;
        Background = background;
        Ambient = ambient;
        Sampler = Sampler.Create(render);
        World = new(contents, (render.Shutter.X, render.Shutter.Y), largestLoop);
        Shapes = World.Itself.Shapes;
        Batches = World.Itself.Batches;
        Primitives = World.Itself.Primitives;
        IsTimed = camera.Moves || World.Instances is { Moves: true };
        Groups = ShadingGroup.Create(World, out int[] groupOf);
        GroupOfPrimitive = groupOf;
        Lights = LightList.Create(World);
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

    /// <summary>The shapes of the world itself by primitive number: those that are neither meshes nor shown by instances.</summary>
    public IReadOnlyList<Shape> Shapes { get; }

    /// <summary>What shines.</summary>
    public IReadOnlyList<LightSource> Lights { get; }

    /// <summary>Those shapes packed by kind.</summary>
    public IReadOnlyList<ShapeBatch> Batches { get; }

    /// <summary>Meets rays with those shapes.</summary>
    public PrimitiveList Primitives { get; }

    /// <summary>Everything that rays can meet.</summary>
    internal World World { get; }

    /// <summary>Whether anything moves while the shutter is open, so that paths have times.</summary>
    internal bool IsTimed { get; }

    /// <summary>What is shaded together.</summary>
    internal ShadingGroup[] Groups { get; }

    /// <summary>The group of each primitive, and, one further, what stands for rays that hit nothing.</summary>
    internal int[] GroupOfPrimitive { get; }

    /// <summary>Makes a scene from built shapes; reports what is wrong and returns null.</summary>
    internal static Scene? Create(SceneDescription description, SpaceContents contents, SceneBuilder builder)
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

        if (!(render.Shutter.Y >= render.Shutter.X) || !float.IsFinite(render.Shutter.Y - render.Shutter.X))
        {
            builder.Error(render, nameof(RenderDescription.Shutter), $"the shutter must not close before it opens, but it opens at {render.Shutter.X} and closes at {render.Shutter.Y}");
        }

        if (description.Camera.Lens is { Shape: not LensShape.EyeJitter, ApertureRadius: 0, FocusDistance: > 0 })
        {
            builder.Warn(description.Camera.Lens, nameof(LensDescription.FocusDistance), "without an \"apertureRadius\" the lens is a pinhole, and \"focusDistance\" has no effect");
        }

        Camera? camera = Camera.Create(description.Camera, render.Width, render.Height, builder);
        return camera is null || builder.HasErrors ? null : new Scene(render, camera, contents, description.Background, description.Ambient, builder.LargestLoop);
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
