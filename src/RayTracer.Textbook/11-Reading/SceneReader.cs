using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Textbook;

/// <summary>Turns the description of a scene into one of this edition, and refuses by name what it lacks.</summary>
/// <param name="loadPicture">Reads the picture file of a path; raw where the second argument says so. Null where there are none.</param>
/// <param name="loadModel">Reads the model file of a path. Null where there are none.</param>
public sealed class SceneReader(Func<string, bool, Picture>? loadPicture = null, Func<string, ImportedModel>? loadModel = null)
{
    /// <summary>The integrators that scene files do not know, by the names under which they are asked for.</summary>
    public static IReadOnlyList<string> OwnIntegrators { get; } = ["whitted", "printed"];

    private readonly Refusals _refusals = new();

    /// <summary>All that was refused.</summary>
    public IReadOnlyList<SceneComplaint> Complaints => _refusals.All;

    /// <summary>Makes what renders the scene; null where something was refused.</summary>
    /// <param name="description">The description, whose parameters are within their ranges.</param>
    /// <param name="integrator">One of <see cref="OwnIntegrators"/>; null for that of the scene.</param>
    public Renderer? Read(SceneDescription description, string? integrator = null)
    {
        RenderDescription render = description.Render;
        MaterialReader materials = new(_refusals, loadPicture ?? ((_, _) => throw new PictureException("there is nothing that reads pictures here")));
        ShapeReader shapes = new(_refusals, materials, loadModel ?? (_ => throw new ModelException("there is nothing that reads models here")));
        foreach (ShapeDescription shape in description.Shapes.Concat(description.Lights))
        {
            shapes.Add(shape);
        }

        IEnvironment? around = materials.Environment(description);
        ICamera? camera = new CameraReader(_refusals).Read(description.Camera, render.Width, render.Height);
        IIntegrator? method = Integrator(render, integrator);
        Func<int, ISampler>? samplers = Samplers(render);
        RefuseRest(render);
        if (Complaints.Count > 0 || camera is null || method is null || samplers is null)
        {
            return null;
        }

        Scene scene = new(camera, shapes.Things, shapes.Points, around, description.Ambient);
        if (scene is { IsEndless: true, Environment: not null } && method is LightPathIntegrator or PhotonIntegrator)
        {
            _refusals.Say(description, null, "paths of light from all around cannot start at an endless plane: give it a \"size\"");
            return null;
        }

        return new(scene, method, render.Width, render.Height, samplers);
    }

    private IIntegrator? Integrator(RenderDescription render, string? own)
    {
        switch (own ?? render.Integrator.Name)
        {
            case "whitted":
                return new WhittedIntegrator(render.MaxSpecularDepth);
            case "printed":
                return new ReportIntegrator(render.MaxDiffuseDepth, render.MaxSpecularDepth, isAsPrinted: true);
            case "report":
                return new ReportIntegrator(render.MaxDiffuseDepth, render.MaxSpecularDepth, isAsPrinted: false);
            case "direct":
                return new DirectIntegrator();
            case "path":
                return new PathIntegrator(render.MaxDepth, render.RouletteDepth);
            case "light":
                return new LightPathIntegrator(render.MaxDepth, render.RouletteDepth);
            case "photons":
                return new PhotonIntegrator(render.MaxDepth, render.RouletteDepth, render.MergeRadius);
            case var _ when render.Integrator is IOwnIntegrator mine:
                return mine.Make(render);
            default:
                _refusals.Say(
                    render, nameof(render.Integrator), $"the textbook edition has no integrator \"{render.Integrator.Name}\": it has report, direct, path, light and photons");
                return null;
        }
    }

    private Func<int, ISampler>? Samplers(RenderDescription render)
    {
        // Rays and paths from lights have streams of their own.
        static long Seed(long seed, int stream) => (seed * 2) + stream;
        if (render.Sampler == SamplerKind.Independent)
        {
            return stream => new IndependentSampler(Seed(render.Seed, stream));
        }

        if (render.Sampler == SamplerKind.Jittered || render.Sampler == SamplerKind.Sobol)
        {
            int side = (int)Math.Max(1, Math.Sqrt(render.SamplesPerPixel));
            return stream => new StratifiedSampler(side, Seed(render.Seed, stream));
        }

        _refusals.Say(render, nameof(render.Sampler), $"the textbook edition has no sampler \"{render.Sampler.Name}\": it has independent and jittered, which stands for sobol too");
        return null;
    }

    private void RefuseRest(RenderDescription render)
    {
        if (render.Filter.Shape != FilterShape.Box || render.Filter.Radius is not (0 or 0.5f))
        {
            _refusals.Say(render, nameof(render.Filter), "the textbook edition has no \"filter\": a pixel is the mean over its square");
        }

        _refusals.Rest(
            render, nameof(render.Width), nameof(render.Height), nameof(render.SamplesPerPixel), nameof(render.Integrator), nameof(render.MaxDepth),
            nameof(render.RouletteDepth), nameof(render.MergeRadius), nameof(render.MaxDiffuseDepth), nameof(render.MaxSpecularDepth), nameof(render.Sampler),
            nameof(render.Filter), nameof(render.Shutter), nameof(render.Seed), nameof(render.OcclusionDistance));
    }
}
