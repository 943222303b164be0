using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Chooses the integrator.</summary>
internal static class MitsubaIntegrators
{
    /// <summary>How a scene is rendered by an integrator.</summary>
    public static RenderDescription Read(MitsubaObject integrator, RenderDescription render)
    {
        switch (integrator.Type)
        {
            case "path":
                break;
            case "direct":
                break;
            case "volpath" or "volpathmis":
                break;
            case "aov":
                return Aov(integrator, render);
            default:
                integrator.Log.Unknown(integrator.TypePlace, $"integrators of the type {Quotation.Of(integrator.Type)} are not read here", integrator.Type, ["path", "direct", "volpath", "volpathmis", "aov"]);
                return render;
        }

        integrator.Ignore("rr_depth");
        if (integrator.Boolean("hide_emitters", false))
        {
            integrator.Log.Error(integrator.PlaceOf("hide_emitters"), "emitters that the camera does not see are not known here");
        }

        integrator.Finish();
        return render;
    }

    private static RenderDescription Aov(MitsubaObject integrator, RenderDescription render)
    {
        integrator.Ignore("aovs");
        integrator.Log.Warn(integrator.TypePlace, "which auxiliary images are written is said with --aov, and not in the scene");
        RenderDescription inner = integrator.Only("integrator") is { } nested ? Read(nested, render) : render;
        integrator.Finish();
        return inner;
    }
}
