using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Chooses the integrator.</summary>
internal static class MitsubaIntegrators
{
    /// <summary>The render settings for an integrator.</summary>
    public static RenderDescription Read(MitsubaObject integrator, RenderDescription render)
    {
        switch (integrator.Type)
        {
            case "path" or "volpath" or "volpathmis":
                Integrator kind = integrator.Type == "path" ? Integrator.Path : Integrator.VolPath;
                render = render with { Integrator = kind, StraightThrough = kind == Integrator.VolPath, MaxDepth = Depth(integrator), RouletteDepth = int.Min(integrator.Integer("rr_depth", 5, 1), RenderDescription.LongestPath) };
                break;
            case "direct":
                integrator.Ignore("shading_samples", "emitter_samples", "bsdf_samples");
                render = render with { Integrator = Integrator.Path, MaxDepth = 2 };
                break;
            case "ptracer":
                integrator.Ignore("samples_per_pass");
                render = render with { Integrator = Integrator.Light, MaxDepth = Depth(integrator), RouletteDepth = int.Min(integrator.Integer("rr_depth", 5, 1), RenderDescription.LongestPath) };
                break;
            case "aov":
                integrator.Ignore("aovs");
                return Inner(integrator, render, "auxiliary images are chosen with --aov, not in the scene");
            case "moment":
                return Inner(integrator, render, "the squares of samples are not written: the noise of a picture is an auxiliary image, --aov error");
            default:
                integrator.UnknownType("integrators", "path", "direct", "volpath", "volpathmis", "ptracer", "aov", "moment");
                return render;
        }

        render = render with { HideLights = integrator.Boolean("hide_emitters", false) };
        if (render.HideLights && integrator.Type == "ptracer")
        {
            integrator.Log.Unsupported(
                integrator.PlaceOf("hide_emitters"), "with \"ptracer\", emitters that the camera does not see are not supported: \"path\" hides them", "they are seen");
            render = render with { HideLights = false };
        }

        integrator.Finish();
        return render;
    }

    // Edges of a path, without limit below 0. Paths longer than ours are of no weight.
    private static int Depth(MitsubaObject integrator)
    {
        int depth = integrator.Integer("max_depth", -1, -1);
        if (depth == 0)
        {
            integrator.Log.Error(integrator.PlaceOf("max_depth"), "paths without an edge see nothing: expected at least 1, or -1 for no limit");
            return 1;
        }

        return int.Min(depth, RenderDescription.LongestPath);
    }

    // The integrator within one that writes further images.
    private static RenderDescription Inner(MitsubaObject integrator, RenderDescription render, string warning)
    {
        integrator.Log.Warn(integrator.TypePlace, warning);
        RenderDescription inner = integrator.Only("integrator") is { } nested ? Read(nested, render) : render;
        integrator.Finish();
        return inner;
    }
}
